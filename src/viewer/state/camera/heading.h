#pragma once

#include <cdr/scene/camera.h>

#include <glm/glm.hpp>

namespace cdr::viewer {

/// Where a camera without roll looks: along the horizon, and how far above it.
struct Heading {
    glm::dvec3 level{0.0, 0.0, -1.0}; ///< world space, unit, level: y is 0
    double elevation = 0.0;           ///< radians, up positive, at most kSteepest either way

    glm::dvec3 forward() const;
};

/// How near to straight up or down a camera looks, radians: a little short of a right angle, where level has
/// a direction still.
inline constexpr double kSteepest = 1.5707963267948966 - 1e-5;

/// Of a camera that may be rolled or look straight down, where its upper edge stands in for the level.
Heading headingOf(const scene::Camera& camera);

/// Turned to the right by `right` and up by `up`, radians, the elevation limited.
Heading turned(const Heading& heading, double right, double up);

/// The camera, where it stands and with its lens, looking there without roll.
scene::Camera lookingAlong(const scene::Camera& camera, const Heading& heading);

/// Slopes, x right and y up, of a pixel's ray in view space: view x and y per unit of view distance.
/// @param pixel from the picture's top left corner; 0.5, 0.5 is the centre of the first.
glm::dvec2 slopeOf(const scene::Camera& camera, const glm::dvec2& pixel, std::uint32_t width,
                   std::uint32_t height);

/// What a pixel covers per unit of view distance: 2 tan(fovY / 2) / height.
double footprintSlope(const scene::Camera& camera, std::uint32_t height);

} // namespace cdr::viewer
