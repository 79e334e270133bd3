#pragma once

#include <scenes/earth/noise.h>

#include <glm/glm.hpp>

namespace cdr::scenes {

/// What of the country changes slowly from place to place, so that a coarse grid holds it. Waves are in part: short ones are missing.
struct Country {
    double hills = 0.0;
    double dry = 0.0;
    double woods = 0.0;
    double towns = 0.0;
    double woodsBlur =
        0.0; ///< half the width of the step that blurs their edges, for waves that texels are too large for
    double townsBlur = 0.0; ///< the same
    glm::dvec2 bend{0.0};   ///< of the borders of fields, metres
    double river = 0.0;     ///< metres to its middle, of either sign
    double road = 0.0;      ///< the same
    double lane = 0.0;      ///< the same
};

/// @param place AirportMap.
/// @param fineness metres.
Country countryAt(const glm::dvec2& place, const Fineness& fineness);

Country between(const Country& a, const Country& b, double share);

/// What stands and grows on land, from noise alone: fields with hedges, woods, towns, roads and rivers, and grass between the
/// runways. What is smaller than a texel is averaged.
/// @param color of the land from afar, linear.
glm::dvec3 countryColor(const glm::dvec3& color, const Country& country, const glm::dvec2& place,
                        const Fineness& fineness);

} // namespace cdr::scenes
