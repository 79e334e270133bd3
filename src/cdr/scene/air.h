#pragma once

/// @file
/// @errors None.

#include <glm/glm.hpp>

namespace cdr::scene {

/// A part of the air. It is thinner by a factor of e for each `height` above the planet.
struct AirPart {
    glm::vec3 scattering{0.0f}; ///< of red, green and blue on the ground, share per scene unit, 0 or more
    double height = 1.0;        ///< scene units, above 0
};

/// Air around a planet. It takes light from what is seen through it, and adds sunlight that it scatters once. Both are worked
/// out along each pixel's ray, so the same air is a sky from the ground and a rim from space. Default values are the Earth's
/// in metres; heights are above its ellipsoid, within half a percent.
struct Air {
    glm::dvec3 centre{0.0};          ///< of the planet, world space
    double radius = 6'378'137.0;     ///< of its equator, scene units, above 0
    glm::dvec3 axis{0.0, 1.0, 0.0};  ///< from its south to its north pole: world axes, unit length
    double flattening = 0.0;         ///< 1 - polar radius / radius, 0 to 0.1
    glm::dvec3 toSun{0.0, 1.0, 0.0}; ///< towards the Sun: world axes, unit length
    glm::vec3 sunlight{1.0f};        ///< linear, 0 or more, as PointLight::color has it
    AirPart molecules{.scattering = {5.8e-6f, 13.5e-6f, 33.1e-6f},
                      .height = 8'000.0};                            ///< bluish, alike ahead and back
    AirPart haze{.scattering = glm::vec3(4e-6f), .height = 1'200.0}; ///< drops and dust, mostly ahead
    double hazeAhead = 0.76; ///< how much haze scatters ahead (Henyey and Greenstein 1941), 0 to 0.95
};

} // namespace cdr::scene
