#pragma once

#include <glm/glm.hpp>

namespace cdr::scenes {

/// What of the country changes slowly from place to place, so that a coarse grid holds it. Waves are in part: short ones are missing.
struct Country {
    double hills = 0.0;
    double dry = 0.0;
    double woods = 0.0;
    double towns = 0.0;
    glm::dvec2 bend{0.0}; ///< of the borders of fields, metres
    double river = 0.0;   ///< metres to its middle, of either sign
    double road = 0.0;    ///< the same
    double lane = 0.0;    ///< the same
};

/// @param place AirportMap.
/// @param texel metres that one texel covers.
Country countryAt(const glm::dvec2& place, double texel);

Country between(const Country& a, const Country& b, double share);

/// What stands and grows on land, from noise alone: fields with hedges, woods, towns, roads and rivers, and grass between the
/// runways. What is smaller than a texel is averaged.
/// @param color of the land from afar, linear.
glm::dvec3 countryColor(const glm::dvec3& color, const Country& country, const glm::dvec2& place,
                        double texel);

} // namespace cdr::scenes
