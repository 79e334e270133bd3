#pragma once

#include <cdr/image/image.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace cdr::measure {

/// How many pixels around a pixel findCracks() looks by default. An error of half a pixel moves a silhouette by one pixel at
/// the picture's corners, and rasterisation rounds by another.
inline constexpr std::uint32_t kCrackReach = 2;

/// What a picture shows in a pixel.
struct SeenPixel {
    std::uint32_t id = 0;                                          ///< object index + 1, 0 for background
    double distanceView = std::numeric_limits<double>::infinity(); ///< infinity for background
};
using SeenImage = image::Raster<SeenPixel>;

/// A pixel that shows an object which the whole picture does not show nearby.
struct Crack {
    std::uint32_t x = 0; ///< pixels from the top left
    std::uint32_t y = 0;
    std::uint32_t id = 0; ///< object index + 1 of what shows through, 0 for background

    bool operator==(const Crack&) const = default;
};

/// Finds holes, row by row: pixels where a surface behind shows through the middle of another. Within `reach`
/// pixels along rows and columns of such a pixel, `whole` shows a single object. It is nearer than what `shown`
/// has there, and another object. A silhouette that moves by `reach` pixels or less is not found, nor is a gap
/// between two silhouettes that both retreat. So a hole within `reach` pixels of a silhouette is not found
/// either. Nor is one through which an object shows itself.
/// @param whole the same view without holes; base::InputError when the sizes differ.
std::vector<Crack> findCracks(const SeenImage& shown, const SeenImage& whole,
                              std::uint32_t reach = kCrackReach);

} // namespace cdr::measure
