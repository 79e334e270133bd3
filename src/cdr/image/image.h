#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Pictures in main memory.
/// @threads Functions keep nothing, so any thread may call them. One that changes an object has it to itself.
namespace cdr::image {

/// One 8-bit pixel: red, green, blue, alpha.
using Rgba8 = std::array<std::uint8_t, 4>;

/// A rectangle of pixels, rows from the top, each row from the left, no padding.
/// @errors None.
/// @lifetime References stay valid until `pixels` changes its size.
template <typename Pixel>
struct Raster {
    std::uint32_t width = 0;   ///< pixels of a row
    std::uint32_t height = 0;  ///< rows
    std::vector<Pixel> pixels; ///< row by row

    Raster() = default;
    /// All pixels alike.
    Raster(std::uint32_t w, std::uint32_t h, Pixel fill = {})
        : width(w),
          height(h),
          pixels(static_cast<std::size_t>(w) * h, fill) {}

    /// A pixel; column and row must be within the raster, which is not checked.
    Pixel& at(std::uint32_t x, std::uint32_t y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
    /// A pixel; column and row must be within the raster, which is not checked.
    const Pixel& at(std::uint32_t x, std::uint32_t y) const {
        return pixels[static_cast<std::size_t>(y) * width + x];
    }
    bool operator==(const Raster&) const = default;
};

/// Colour, 8 bits a channel.
using ImageRgba8 = Raster<Rgba8>;
/// One float a pixel.
using ImageFloat = Raster<float>;
/// One number a pixel, such as an id.
using ImageU32 = Raster<std::uint32_t>;

} // namespace cdr::image
