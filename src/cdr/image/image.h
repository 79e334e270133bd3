#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::image {

/// One 8-bit pixel: red, green, blue, alpha.
using Rgba8 = std::array<std::uint8_t, 4>;

/// A rectangle of pixels, rows from the top, each row from the left, no padding.
template <typename Pixel>
struct Raster {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<Pixel> pixels;

    Raster() = default;
    Raster(std::uint32_t w, std::uint32_t h, Pixel fill = {})
        : width(w),
          height(h),
          pixels(static_cast<std::size_t>(w) * h, fill) {}

    Pixel& at(std::uint32_t x, std::uint32_t y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
    const Pixel& at(std::uint32_t x, std::uint32_t y) const {
        return pixels[static_cast<std::size_t>(y) * width + x];
    }
    bool operator==(const Raster&) const = default;
};

using ImageRgba8 = Raster<Rgba8>;
using ImageFloat = Raster<float>;
using ImageU32 = Raster<std::uint32_t>;

} // namespace cdr::image
