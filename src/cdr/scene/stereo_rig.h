#pragma once

/// @file
/// @errors None but those that a function names.
/// @units Distances are in scene units.
/// @lifetime Names live as long as the program.

#include <cdr/base/export.h>
#include <cdr/scene/camera.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

namespace cdr::scene {

/// How the two eyes of a rig look.
enum class StereoMode : std::uint8_t {
    parallel, ///< along the same direction: objects at infinity coincide in both pictures
    toedIn,   ///< at one point, which coincides in both pictures
    /// Along the same direction, through lenses that are shifted: what lies at one distance coincides in both pictures.
    offAxis
};

/// All modes.
inline constexpr std::array<StereoMode, 3> kStereoModes{StereoMode::parallel, StereoMode::toedIn,
                                                        StereoMode::offAxis};
/// "parallel", "toed-in" or "off-axis".
CDR_EXPORT std::string_view nameOf(StereoMode mode);
/// The mode of such a name.
/// @throws base::InputError with a suggestion for another name.
CDR_EXPORT StereoMode parseStereoMode(std::string_view name);

/// Two eyes beside a camera.
struct StereoRig {
    Camera centre;            ///< between the eyes, with the lens of both
    double eyeDistance = 0.0; ///< between the eyes, > 0
    /// From the centre along its view axis to where the eyes' pictures coincide, > 0; infinity for StereoMode::parallel alone.
    double convergence = std::numeric_limits<double>::infinity();
    StereoMode mode = StereoMode::parallel; ///< how the eyes look
};

/// The left eye, then the right: half the eye distance beside the centre along its right axis. In toed-in rigs both turn
/// to the point at `convergence`, about the centre's up axis. In off-axis rigs Camera::lensShift says how their lenses are shifted.
/// @throws base::InputError for a camera that is not usable, and for a distance that is not above 0 or not finite.
/// @throws base::InputError for an eye distance that is lost in the rounding of the camera's position.
CDR_EXPORT std::array<Camera, 2> eyesOf(const StereoRig& rig);

/// By how many pixels, both together, a rig's pictures are moved so that what lies at `convergence` coincides. The left
/// picture moves to the left, the right one to the right. 0 for rigs of other modes than parallel: their eyes turn, or have shifted lenses.
/// @param width of an eye's picture in pixels. @param height the same.
/// @throws base::InputError as eyesOf(), and where the pictures would not overlap any more.
CDR_EXPORT std::uint32_t stereoShift(const StereoRig& rig, std::uint32_t width, std::uint32_t height);

} // namespace cdr::scene
