#pragma once

#include <cdr/image/image.h>
#include <scenes/orbit/earth_surface.h>

#include <glm/glm.hpp>

namespace cdr::scenes {

/// What the blue marble shows at a place.
struct MarbleColor {
    glm::dvec3 color{0.0}; ///< linear, of the land alone where there is some
    double water = 0.0;    ///< 0 on land, 1 at sea
};

/// NASA's picture of the Earth, read smoothly: a texel is 10 km wide, so it is blurred, not squared.
class BlueMarble {
  public:
    /// @param picture plate carree; must outlive the marble.
    explicit BlueMarble(const image::ImageRgba8& picture) : m_picture(picture) {}

    /// @param place degrees; longitudes go round.
    MarbleColor at(const Geodetic& place) const;

  private:
    glm::dvec3 texel(std::int64_t x, std::int64_t y) const;

    const image::ImageRgba8& m_picture;
};

} // namespace cdr::scenes
