#pragma once

#include <cdr/base/error.h>
#include <cdr/image/image.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace cdr::test {

/// Absolute differences, `gain` times as bright, opaque. base::InputError when the sizes differ.
inline image::ImageRgba8 differencePicture(const image::ImageRgba8& golden, const image::ImageRgba8& render,
                                           int gain) {
    if (golden.width != render.width || golden.height != render.height) {
        throw base::InputError("difference: the sizes differ");
    }
    image::ImageRgba8 picture(golden.width, golden.height, {0, 0, 0, 255});
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const int bright = gain * std::abs(int{golden.pixels[i][c]} - int{render.pixels[i][c]});
            picture.pixels[i][c] = static_cast<std::uint8_t>(std::min(bright, 255));
        }
    }
    return picture;
}

} // namespace cdr::test
