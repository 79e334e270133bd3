#pragma once

#include <cdr/image/image.h>

#include <cstdint>

namespace cdr::viewer {

/// Gives a picture a size; one that has it keeps its memory and its pixels.
inline void resize(image::ImageRgba8& picture, std::uint32_t width, std::uint32_t height) {
    if (picture.width != width || picture.height != height) {
        picture = image::ImageRgba8(width, height);
    }
}

} // namespace cdr::viewer
