#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>

#include <glm/glm.hpp>

namespace cdr::scene {

static_assert(
    sizeof(glm::dvec3) == 3 * sizeof(double),
    "cdr's libraries were built without GLM's aligned types: leave out GLM_FORCE_DEFAULT_ALIGNED_GENTYPES");

/// Of Camera::lensShift, in halves of the picture's height.
inline constexpr double kMaxLensShift = 1000.0;

/// Least field of view in radians, 1e-28 degrees. Below, shaders multiply by numbers near the end of float32, and pictures
/// become empty.
inline constexpr double kMinFovY = 1.745e-30;

/// A perspective camera in float64. View space is right-handed, y up, looking down -z; the view distance of a
/// point is w = -z_view.
struct Camera {
    glm::dvec3 position{0.0};        ///< world space
    glm::dvec3 right{1.0, 0.0, 0.0}; ///< world space, unit; right, up and back are orthonormal
    glm::dvec3 up{0.0, 1.0, 0.0};    ///< world space, unit
    glm::dvec3 back{0.0, 0.0, 1.0};  ///< world space, unit: away from what is looked at
    double fovY = 1.0;               ///< vertical field of view, radians, in [kMinFovY, pi)
    double nearView = 0.1;           ///< view distance, > 0
    double farView = 1e5;            ///< view distance, > nearView, finite
    /// How far the middle of the picture lies to the right of the view axis and above it, at view distance 1. Each is at most
    /// kMaxLensShift times tan(fovY / 2), either way. A headset's eyes have such lenses, and so has a tile of a larger picture.
    /// By less than a pixel it is the jitter of temporal antialiasing: a pixel is Frustum::footprintSlope wide.
    glm::dvec2 lensShift{0.0};

    /// View-space position of a point of world space.
    glm::dvec3 toView(const glm::dvec3& world) const {
        const glm::dvec3 d = world - position;
        return {glm::dot(right, d), glm::dot(up, d), glm::dot(back, d)};
    }
    /// How far along the view axis a point of world space lies.
    double viewDistance(const glm::dvec3& world) const { return glm::dot(back, position - world); }

    bool operator==(const Camera&) const = default;
};

/// Turns `camera` to look from `eye` at `target`, keeping its lens. World y is up, or world z when the view
/// is along y. Both points are in world space.
/// @throws base::InputError when eye and target coincide or are not finite.
CDR_EXPORT Camera lookAt(Camera camera, const glm::dvec3& eye, const glm::dvec3& target);

/// Turns `camera` to look from `eye` along `forward`, keeping its lens. A unit vector is used exactly, to the
/// bit. So lookAlong(c, c.position, -c.back) returns a camera that came from lookAt() unchanged, however far
/// out it stands. Without `up`, up is as in lookAt(). With it, the camera's up is the part of `up` across the
/// view.
/// @throws base::InputError when a vector is zero or not finite, or `up` lies along the view.
CDR_EXPORT Camera lookAlong(Camera camera, const glm::dvec3& eye, const glm::dvec3& forward);
/// The same, with an up of the caller's.
/// @throws base::InputError as above.
CDR_EXPORT Camera lookAlong(Camera camera, const glm::dvec3& eye, const glm::dvec3& forward,
                            const glm::dvec3& up);

/// The nearest camera that command line options can express, through lookAlong() and radiansOf(). If the axes
/// are orthonormal, it differs by roundings only. Applied to its own result it changes nothing.
/// @throws base::InputError as lookAlong().
CDR_EXPORT Camera canonical(const Camera& camera);
/// Whether lookAlong() gives this camera, to the bit, from its eye and forward vector without `up`.
/// @throws base::InputError as lookAlong().
CDR_EXPORT bool isLevel(const Camera& camera);

/// Radians of an angle in degrees, as every option of the command line is read.
CDR_EXPORT double radiansOf(double degrees);
/// The degrees whose radiansOf() is `radians` or nearest to it.
CDR_EXPORT double degreesOf(double radians);

/// The tangents of the angles between the view axis and the picture's edges, as a headset names them. All are finite.
struct LensEdges {
    double left = -1.0; ///< negative where that edge lies left of the axis
    double right = 1.0; ///< > left
    double down = -1.0; ///< negative where that edge lies below the axis
    double up = 1.0;    ///< > down
};

/// Gives `camera` a lens with these edges. Pixels are square. So the picture's width follows from its height if their ratio
/// is not (right - left) / (up - down). The middle between left and right stays.
/// @throws base::InputError for edges that are not in order or not finite, and for a lens shift beyond its limit.
CDR_EXPORT Camera withLens(Camera camera, const LensEdges& edges);

/// @throws base::InputError with the value unless the camera is usable. Lens, position and axes are finite, and no lens shift
///         is beyond its limit. depth::requireRange() takes near and far, and kMinFovY <= fovY < pi. Axes have length 1 to
///         1e-5. Whether axes are at right angles is not looked at.
CDR_EXPORT void requireUsable(const Camera& camera);

} // namespace cdr::scene
