#pragma once

#include <glm/glm.hpp>

namespace cdr::scene {

/// A perspective camera in float64. View space is right-handed, y up, looking down -z; the view distance of a
/// point is w = -z_view.
struct Camera {
    glm::dvec3 position{0.0};        ///< world space
    glm::dvec3 right{1.0, 0.0, 0.0}; ///< world space, unit; right, up and back are orthonormal
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 back{0.0, 0.0, 1.0};
    double fovY = 1.0;     ///< vertical field of view, radians, in (0, pi)
    double nearView = 0.1; ///< view distance, > 0
    double farView = 1e5;  ///< view distance, > nearView, finite

    glm::dvec3 toView(const glm::dvec3& world) const {
        const glm::dvec3 d = world - position;
        return {glm::dot(right, d), glm::dot(up, d), glm::dot(back, d)};
    }
    double viewDistance(const glm::dvec3& world) const { return glm::dot(back, position - world); }
};

/// Turns `camera` to look from `eye` at `target`, keeping its lens. World y is up, or world z when the view
/// is along y. base::InputError when eye and target coincide or are not finite.
Camera lookAt(Camera camera, const glm::dvec3& eye, const glm::dvec3& target);

/// Turns `camera` to look from `eye` along `forward`, keeping its lens. A unit vector is taken as it is, to
/// the bit, so lookAlong(c, c.position, -c.back) gives back a camera that came from lookAt(), wherever it
/// stands. Without `up`, that is as in lookAt(); with it, the camera's up is what of it is across the view.
/// base::InputError when a vector is zero or not finite, or `up` lies along the view.
Camera lookAlong(Camera camera, const glm::dvec3& eye, const glm::dvec3& forward);
Camera lookAlong(Camera camera, const glm::dvec3& eye, const glm::dvec3& forward, const glm::dvec3& up);

/// The camera that words can say: the nearest that lookAlong() and radiansOf() give for it. Differs by
/// roundings alone where its axes are orthonormal; the same camera, to the bit, when applied again.
/// base::InputError as lookAlong().
Camera canonical(const Camera& camera);
/// Whether the camera is what lookAlong() makes of its eye and forward alone, to the bit.
bool isLevel(const Camera& camera);

/// Radians of an angle in degrees, the way every option of the command line is read.
double radiansOf(double degrees);
/// The degrees whose radiansOf() is `radians`, or comes nearest.
double degreesOf(double radians);

/// base::InputError, naming the value, unless the lens is usable: finite, 0 < near < far, 0 < fovY < pi.
void requireUsable(const Camera& camera);

} // namespace cdr::scene
