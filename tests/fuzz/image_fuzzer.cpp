#include <cdr/base/error.h>
#include <cdr/image/codec.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace {

/// What decodes has the size that its header says. The header is not refused, then: that would end the program.
void checkHeader(std::span<const std::uint8_t> encoded, const cdr::image::ImageRgba8& image) noexcept {
    const cdr::image::PictureSize decoded{image.width, image.height};
    if (cdr::image::sizeOfEncoded(encoded, "a.png") != decoded) {
        __builtin_trap();
    }
}

} // namespace

/// Any bytes decode, within the limits of size, or are refused with base::InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const cdr::image::ImageRgba8 image = cdr::image::decodeImage({data, size}, "a.png");
        if (image.pixels.size() != std::size_t{image.width} * image.height || image.pixels.empty() ||
            image.pixels.size() > cdr::image::kMaxDecodedPixels) {
            __builtin_trap();
        }
        checkHeader({data, size}, image);
    } catch (const cdr::base::InputError&) {
    }
    return 0;
}
