#pragma once

#include <cdr/render/effects.h>
#include <cdr/render/focus.h>
#include <cdr/render/shadows/shadows.h>
#include <cdr/render/translucency/translucency.h>
#include <cdr/scene/gltf/open_gltf.h>

#include <cstdint>
#include <optional>
#include <string>

// CLI11's own name. NOLINTNEXTLINE(readability-identifier-naming)
namespace CLI {
class App;
}

namespace cdr::options {

/// Most MiB that --translucency-memory takes: 4 TiB.
inline constexpr std::uint64_t kMaxTranslucencyMiB = std::uint64_t{1} << 22u;

/// The effects and the translucency of a picture as a command line gives them.
struct EffectArguments {
    std::string antialias = "none";
    std::string occlusion; ///< RADIUS or RADIUS:layers
    std::string fog;       ///< VISIBILITY or VISIBILITY,r,g,b
    std::string toneMap = "scene";
    double exposure = 0.0; ///< stops
    std::string light;     ///< of a model; empty: as shownChoice() has it
    std::string focus;     ///< DISTANCE:APERTURE or DISTANCE:APERTURE:blend
    std::string translucency = "weighted";
    std::string shadows = "none";
    std::uint32_t shadowTexels = render::Shadows{}.maxTexels;
    std::uint64_t translucencyMiB = render::TranslucencyOptions{}.maxBytes >> 20u;
};

void addEffectOptions(CLI::App& command, EffectArguments& arguments);

/// base::InputError that names the option for text that does not parse, and for values out of range.
render::Effects effectsOf(const EffectArguments& arguments);
render::Focus focusOf(const EffectArguments& arguments);

/// Of the model that is shown. base::InputError with a suggestion for an unknown name.
std::optional<scene::ModelLight> lightOf(const EffectArguments& arguments);

/// base::InputError with a suggestion for an unknown method.
render::Shadows shadowsOf(const EffectArguments& arguments);
/// The same.
render::TranslucencyOptions translucencyOf(const EffectArguments& arguments);

} // namespace cdr::options
