#pragma once

#include <cdr/image/image.h>

#include <string>

namespace cdr::image {

/// A raster whose pixels are what `at` makes of (x, y), row by row.
template <typename Pixel, typename At>
Raster<Pixel> rasterOf(std::uint32_t width, std::uint32_t height, const At& at) {
    Raster<Pixel> raster(width, height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            raster.at(x, y) = at(x, y);
        }
    }
    return raster;
}

/// `source` made smaller by a whole factor: each pixel is the mean of a factor x factor block in linear
/// light. Pixels that do not fill a block are left out. base::InputError when factor is 0 or larger than a
/// side.
ImageRgba8 shrink(const ImageRgba8& source, std::uint32_t factor);

/// By how much to shrink() a picture that is to be about `width` pixels across, or more where it is too low for that: 1 or more.
std::uint32_t shrinkFactor(const ImageRgba8& source, std::uint32_t width);

/// Copies `source` into `target` with its top left corner at (x, y). Pixels outside are left out.
void paste(ImageRgba8& target, const ImageRgba8& source, std::uint32_t x, std::uint32_t y);

/// Draws ASCII text with its top left corner at (x, y), glyphs about 8 * scale pixels high. Pixels outside
/// are left out. Other characters of UTF-8 show as question marks.
void drawText(ImageRgba8& target, const std::string& text, std::uint32_t x, std::uint32_t y,
              std::uint32_t scale, const Rgba8& color);

/// Width of that text in pixels.
std::uint32_t textWidth(const std::string& text, std::uint32_t scale);

} // namespace cdr::image
