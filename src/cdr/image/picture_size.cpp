#include <cdr/image/picture_size.h>

#include <charconv>
#include <system_error>

namespace cdr::image {

std::optional<PictureSize> parsePictureSize(std::string_view text) {
    PictureSize size;
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    const bool hasWidth = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    const auto height = hasWidth ? std::from_chars(width.ptr + 1, end, size.height) : width;
    if (!hasWidth || height.ec != std::errc() || height.ptr != end || size.width < 1 || size.height < 1) {
        return std::nullopt;
    }
    return size;
}

} // namespace cdr::image
