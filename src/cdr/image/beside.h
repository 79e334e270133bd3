#pragma once

/// @file
/// @errors None.

#include <cdr/image/compose.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace cdr::image {

/// Pictures beside each other, from the left, all of the height of the first. The first one moves to the left by half of
/// `shift`, rounded down. The others move to the right by half of it, rounded up. Columns that leave their own part are
/// lost. Columns that become free are `fill`.
template <typename Pixel>
Raster<Pixel> beside(std::span<const Raster<Pixel>* const> pictures, std::uint32_t shift = 0,
                     Pixel fill = {}) {
    if (pictures.empty()) {
        return {};
    }
    const std::uint32_t width = pictures.front()->width;
    const std::uint32_t height = pictures.front()->height;
    Raster<Pixel> joined(width * static_cast<std::uint32_t>(pictures.size()), height, fill);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const std::uint32_t moved = std::min(i == 0 ? shift / 2 : shift - shift / 2, width);
        const std::uint32_t from = i == 0 ? moved : 0;
        const std::uint32_t to = static_cast<std::uint32_t>(i) * width + (i == 0 ? 0 : moved);
        for (std::uint32_t y = 0; y < height; ++y) {
            const Pixel* row = &pictures[i]->pixels[static_cast<std::size_t>(y) * width];
            std::copy(row + from, row + from + (width - moved),
                      joined.pixels.begin() + static_cast<std::ptrdiff_t>(y) * joined.width + to);
        }
    }
    return joined;
}

/// One picture for glasses with a red left and a cyan right lens. Red is from the left half, green and blue from the
/// right half.
/// @param besides both eyes' pictures beside each other.
inline ImageRgba8 anaglyphOf(const ImageRgba8& besides) {
    const std::uint32_t width = besides.width / 2;
    return rasterOf<Rgba8>(width, besides.height, [&](auto x, auto y) -> Rgba8 {
        const Rgba8& left = besides.at(x, y);
        const Rgba8& right = besides.at(width + x, y);
        return {left[0], right[1], right[2], left[3]};
    });
}

} // namespace cdr::image
