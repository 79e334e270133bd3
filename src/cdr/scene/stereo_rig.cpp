#include <cdr/base/enum_names.h>
#include <cdr/base/format_error.h>
#include <cdr/scene/frustum.h>
#include <cdr/scene/stereo_rig.h>

#include <cmath>

namespace cdr::scene {

namespace {

constexpr base::EnumNames<StereoMode, kStereoModes.size()> kStereoModeNames{
    "stereo", {"parallel", "toed-in", "off-axis"}};

void requireStereoDistance(double distance, const char* what) {
    if (!std::isfinite(distance) || distance <= 0.0) {
        throw base::inputError("{} must be finite and above 0, not {}", what, distance);
    }
}

void requireRig(const StereoRig& rig) {
    requireUsable(rig.centre);
    requireStereoDistance(rig.eyeDistance, "eye distance");
    if (rig.mode != StereoMode::parallel || rig.convergence != std::numeric_limits<double>::infinity()) {
        requireStereoDistance(rig.convergence, "convergence distance");
    }
}

/// @param side -1 for the left eye, 1 for the right.
Camera eyeOf(const StereoRig& rig, double side) {
    const Camera& centre = rig.centre;
    const glm::dvec3 aside = side * 0.5 * rig.eyeDistance * centre.right;
    Camera eye = centre;
    eye.position += aside;
    if (rig.mode == StereoMode::toedIn) {
        // Of the offsets alone: far from the origin the difference of two positions would be rounded.
        const glm::dvec3 forward = -rig.convergence * centre.back - aside;
        eye = lookAlong(eye, eye.position, forward, centre.up);
    }
    if (rig.mode == StereoMode::offAxis) {
        eye.lensShift.x -= side * 0.5 * rig.eyeDistance / rig.convergence;
    }
    requireUsable(eye);
    return eye;
}

} // namespace

std::string_view nameOf(StereoMode mode) {
    return kStereoModeNames.nameOf(mode);
}

StereoMode parseStereoMode(std::string_view name) {
    return kStereoModeNames.parse(name);
}

std::array<Camera, 2> eyesOf(const StereoRig& rig) {
    requireRig(rig);
    const std::array<Camera, 2> eyes{eyeOf(rig, -1.0), eyeOf(rig, 1.0)};
    // Positions are rounded, so the distance of the eyes is off by up to half a step of both.
    constexpr double kMaxLost = 1e-3;
    const double drawn = glm::length(eyes[1].position - eyes[0].position);
    if (std::abs(drawn - rig.eyeDistance) > kMaxLost * rig.eyeDistance) {
        throw base::inputError(
            "eye distance {} is lost in the rounding of the camera's position, which makes it {}",
            rig.eyeDistance, drawn);
    }
    return eyes;
}

std::uint32_t stereoShift(const StereoRig& rig, std::uint32_t width, std::uint32_t height) {
    requireRig(rig);
    if (rig.mode != StereoMode::parallel) {
        return 0;
    }
    const Frustum frustum = frustumOf(rig.centre, width, height);
    const double shift = rig.eyeDistance / (2.0 * rig.convergence * frustum.tanX) * width;
    if (!(shift < width - 0.5)) {
        throw base::inputError("convergence distance {} is so near that the eyes' pictures, {} apart, "
                               "would not overlap",
                               rig.convergence, rig.eyeDistance);
    }
    return static_cast<std::uint32_t>(std::lround(shift));
}

} // namespace cdr::scene
