#pragma once

#include <cdr/base/export.h>
#include <cdr/scene/camera.h>

namespace cdr::scene {

/// What follows from a camera's lens and a picture's size. It is computed once per frame and passed on.
struct Frustum {
    double tanX = 1.0;      ///< half the picture's width at view distance 1
    double tanY = 1.0;      ///< half its height there
    glm::dvec2 centre{0.0}; ///< view-space x and y of the picture's middle there: Camera::lensShift
    /// Sines and cosines of the half angles. Let x be in view space and w the view distance of a point. It lies between
    /// the planes left and right where w * sinX >= |x - w * centre.x| * cosX; above and below alike. Where the lens is shifted,
    /// the cosine is that of the edge farther from the axis. A sphere beyond the other edge then counts as in view a little too
    /// long.
    double sinX = 0.0;
    double cosX = 1.0;           ///< of half the horizontal angle
    double sinY = 0.0;           ///< of half the vertical angle
    double cosY = 1.0;           ///< of half the vertical angle
    double aspect = 1.0;         ///< width over height
    double footprintSlope = 0.0; ///< what a pixel covers per unit of view distance, in scene units

    /// Where the x axis of the picture points in world space: along it a point has x - w * centre.x. It is not unit where the lens
    /// is shifted.
    /// @errors None.
    glm::dvec3 rightOf(const Camera& camera) const { return camera.right + centre.x * camera.back; }
    /// As rightOf(), of y.
    /// @errors None.
    glm::dvec3 upOf(const Camera& camera) const { return camera.up + centre.y * camera.back; }
};

/// The frustum of a usable camera.
/// @param width of the picture in pixels, > 0.
/// @param height of the picture in pixels, > 0. Without a picture: 1, and its aspect as the width.
/// @errors None.
CDR_EXPORT Frustum frustumOf(const Camera& camera, double width, double height);

} // namespace cdr::scene
