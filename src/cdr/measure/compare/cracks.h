#pragma once

#include <cdr/image/image.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace cdr::measure {

/// How many pixels around a pixel findCracks() looks, unless told otherwise. An error of half a pixel moves a
/// silhouette by one pixel at the picture's corners, and rasterisation rounds by another.
inline constexpr std::uint32_t kCrackReach = 2;

/// What a picture shows in a pixel.
struct SeenPixel {
    std::uint32_t id = 0;                                          ///< object index + 1, 0 for background
    double distanceView = std::numeric_limits<double>::infinity(); ///< infinity for background
};
using SeenImage = image::Raster<SeenPixel>;

/// A place where a picture shows what the whole one shows nowhere near.
struct Crack {
    std::uint32_t x = 0; ///< pixels from the top left
    std::uint32_t y = 0;
    std::uint32_t id = 0; ///< object index + 1 of what shows through, 0 for background

    bool operator==(const Crack&) const = default;
};

/// Hunts for holes: every pixel of `shown` around which `whole` shows a single object, another and nearer
/// one, within `reach` pixels along rows and columns. There, what is behind shows through in the middle of a
/// surface. Silhouettes that move by `reach` pixels or less are none, nor is what opens between two that both
/// retreat. Neither, thus, are holes that close to one. An object that shows through itself is not found. Row
/// by row.
/// @param whole the same view without holes; base::InputError when the sizes differ.
std::vector<Crack> findCracks(const SeenImage& shown, const SeenImage& whole,
                              std::uint32_t reach = kCrackReach);

} // namespace cdr::measure
