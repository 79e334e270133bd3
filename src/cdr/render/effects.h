#pragma once

/// @file
/// @errors None but those that a function names.
/// @lifetime Names live as long as the program.

#include <cdr/base/export.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string_view>

namespace cdr::render {

/// The method of antialiasing.
enum class Antialias : std::uint8_t {
    none,
    edges, ///< after shading, along edges of brightness (FXAA, Lottes 2009)
};

/// All of them.
inline constexpr std::array kAntialiases{Antialias::none, Antialias::edges};

/// "none" or "edges".
CDR_EXPORT std::string_view nameOf(Antialias antialias);
/// @throws base::InputError with a suggestion for an unknown name.
CDR_EXPORT Antialias parseAntialias(std::string_view name);

/// Tone mapping: what becomes of light that is brighter than a picture can show.
enum class ToneMap : std::uint8_t {
    scene,   ///< as is usual for the scene: neutral under a sky or through air, else none
    none,    ///< it is cut off
    neutral, ///< highlights are compressed and base colours stay (Khronos PBR Neutral)
};

/// All of them.
inline constexpr std::array kToneMaps{ToneMap::scene, ToneMap::none, ToneMap::neutral};

/// "scene", "none" or "neutral".
CDR_EXPORT std::string_view nameOf(ToneMap toneMap);
/// @throws base::InputError with a suggestion for an unknown name.
CDR_EXPORT ToneMap parseToneMap(std::string_view name);

/// Most stops of exposure, either way.
inline constexpr double kMaxExposure = 16.0;

/// How light becomes a picture.
struct Finish {
    ToneMap toneMap = ToneMap::scene; ///< after exposure
    double exposure = 0.0;            ///< stops: each doubles the light

    bool operator==(const Finish&) const = default;
};

/// Ambient occlusion: ambient light that corners do not get (McGuire, Mara and Luebke 2012).
struct Occlusion {
    double radius = 0.0; ///< within which surfaces take each other's light, scene units; 0 for none
    /// Computes it in the image of each cascade before these are merged, as in the thesis' method 2, instead of over the
    /// whole picture. Then surfaces in another cascade take no light. For layered targets.
    bool perLayer = false;

    bool operator==(const Occlusion&) const = default;
};

/// Fog as thick everywhere.
struct CDR_EXPORT Fog {
    double visibility = 0.0; ///< distance at which it leaves 2 % of a colour, scene units; 0 for none
    glm::vec3 color{0.45f, 0.55f, 0.65f}; ///< linear

    /// What it takes per scene unit (Koschmieder's relation of visibility and extinction).
    double extinction() const;
    bool operator==(const Fog&) const = default;
};

/// What makes a picture look finished, and measurements do without. None of it knows the technique: effects
/// read the one metric distance of the G-buffer.
struct Effects {
    Antialias antialias = Antialias::none; ///< over the finished picture
    Occlusion occlusion{};                 ///< of ambient light
    Fog fog{};                             ///< between the camera and surfaces
    Finish finish{};                       ///< of the picture

    bool operator==(const Effects&) const = default;
};

/// Refuses effects that cannot be drawn.
/// @throws base::InputError that names the value. Every length must be finite and not negative, exposure at
///         most kMaxExposure either way, and colours in [0, 1].
CDR_EXPORT void requireUsable(const Effects& effects);

} // namespace cdr::render
