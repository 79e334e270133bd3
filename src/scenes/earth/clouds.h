#pragma once

#include <scenes/earth/noise.h>

#include <glm/glm.hpp>

namespace cdr::scenes {

/// Fair weather over the airport and clouds all around, from noise alone. They are painted on the ground, 3 km too low, which is
/// less than a pixel from the station, and their shadows beside them.
class Clouds {
  public:
    /// What changes slowly from place to place, so that a coarse grid holds it.
    struct Weather {
        glm::dvec2 wind{0.0};  ///< how far clouds were blown, metres
        double here = 0.0;     ///< how thick they are, in part
        double sunwards = 0.0; ///< the same of what shades the place
    };
    struct Cover {
        double share = 0.0;  ///< of the ground that is hidden
        double shade = 0.0;  ///< share of sunlight that is taken from the ground
        double bright = 1.0; ///< of the clouds
    };

    /// @param toShade from a place to that below the cloud that shades it, metres east and south.
    explicit Clouds(const glm::dvec2& toShade) : m_toShade(toShade) {}

    Weather weatherAt(const glm::dvec2& place, const Fineness& fineness) const;
    Cover coverAt(const Weather& weather, const glm::dvec2& place, const Fineness& fineness) const;

  private:
    glm::dvec2 m_toShade;
};

} // namespace cdr::scenes
