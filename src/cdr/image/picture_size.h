#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace cdr::image {

/// Columns and rows of a picture.
struct PictureSize {
    std::uint32_t width = 0;
    std::uint32_t height = 0;

    bool operator==(const PictureSize&) const = default;
};

/// The size in a text such as "1280x720". None for any other text, and where a side is 0 or too long for its type.
std::optional<PictureSize> parsePictureSize(std::string_view text);

} // namespace cdr::image
