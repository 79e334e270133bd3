#pragma once

/// @file
/// @errors None but those that a function names.
/// @lifetime Names live as long as the program.

#include <cdr/base/export.h>
#include <cdr/scene/scene.h>
#include <cdr/visibility/level_choice.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cdr::render {

/// How lights cast shadows.
enum class ShadowMethod : std::uint8_t {
    none,
    /// A map for each slice of distances, laid around what is seen. Places are subtracted in float64, and a surface is
    /// compared with the planes of what the map holds.
    anchored,
    /// Today's practice, for comparison. Four maps by the practical split (Zhang and others 2006), with reversed depth and
    /// a bias by slope. Positions are relative to the camera in float32.
    plain,
};

/// All of them.
inline constexpr std::array kShadowMethods{ShadowMethod::none, ShadowMethod::anchored, ShadowMethod::plain};

/// "none", "anchored" or "plain".
CDR_EXPORT std::string_view nameOf(ShadowMethod method);
/// @throws base::InputError with a suggestion for an unknown name.
CDR_EXPORT ShadowMethod parseShadowMethod(std::string_view name);

/// Shadows of opaque surfaces, on opaque and on translucent surfaces.
struct Shadows {
    ShadowMethod method = ShadowMethod::none; ///< how they are cast
    std::uint32_t maxTexels = 2048;           ///< of a side of a map, kMinShadowTexels to kMaxShadowTexels

    /// Whether lights cast shadows.
    bool isOn() const { return method != ShadowMethod::none; }
    bool operator==(const Shadows&) const = default;
};

/// Least and most texels of a side of a map. Each device has images of the most.
inline constexpr std::uint32_t kMinShadowTexels = 64;
inline constexpr std::uint32_t kMaxShadowTexels = 4096; ///< as above

/// Whether shadows go with levels of detail that are chosen so. A caster has one level for all lights and slices, and a surface
/// would shade whatever else stands in for it.
constexpr bool castsShadows(visibility::DetailMode mode) {
    return mode == visibility::DetailMode::none || mode == visibility::DetailMode::perObject;
}

/// How many lights cast shadows: scene::shadowLights().
inline constexpr std::size_t kMaxShadowLights = scene::kMaxShadowLights;

/// Counts of a frame's shadows.
struct ShadowStats {
    std::size_t maps = 0;    ///< that were recorded; the device may skip those that no pixel reads
    std::size_t casters = 0; ///< draws into them
};

} // namespace cdr::render
