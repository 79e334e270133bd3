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

/// Half as bright and without hue, as measure::heatMap() has what is right.
inline std::uint8_t dimGrey(const image::Rgba8& color) {
    // Rec. 709 luma in 1/512, which halves it.
    return static_cast<std::uint8_t>((109u * color[0] + 366u * color[1] + 37u * color[2]) / 1024u);
}

} // namespace cdr::viewer
