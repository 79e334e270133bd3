#pragma once

#include <cdr/render/shadows/light_view.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

namespace cdr::render {

/// Directions: those through a rectangle that lies across the z axis.
struct DirectionWindow {
    glm::dvec2 low{0.0};  ///< x and y of a corner of the rectangle
    glm::dvec2 high{0.0}; ///< of the opposite corner, not below `low`
    double depth = 1.0;   ///< z of the rectangle, above 0
};

/// The greatest cosine of the angles between an axis and all directions of a window: -1 to 1, but for rounding.
/// @param axis of length 1, in the axes of the window.
double greatestCosine(const glm::dvec3& axis, const DirectionWindow& window);

/// Whether some light falls on what a view shows. False only if all of it is outside the light's cone, and so far outside
/// that the device finds so too.
/// @param view of that light.
bool isInCone(const scene::PointLight& light, const LightView& view);

/// Whether some light falls on surfaces of a slice. False only if all are beyond the light's range, as the device finds too.
/// @param camera position that the slice is relative to.
bool isInRange(const scene::PointLight& light, const glm::dvec3& camera, const ReceiverSlice& slice);

} // namespace cdr::render
