#include "effect_options.h"

#include <CLI/CLI.hpp>
#include <cdr/base/error.h>
#include <cdr/base/suggest.h>

#include <fmt/format.h>

#include <vector>

namespace cdr::options {

namespace {

std::vector<std::string> partsOf(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t end = text.find(separator); end != std::string::npos;
         end = text.find(separator, begin)) {
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    parts.push_back(text.substr(begin)); // also where it is empty, which no number is
    return parts;
}

render::Occlusion occlusionOf(const std::string& text) {
    const std::vector<std::string> parts = partsOf(text, ':');
    if (parts.empty() || parts.size() > 2 || (parts.size() == 2 && parts[1] != "layers")) {
        throw base::InputError(
            fmt::format("--occlusion takes RADIUS or RADIUS:layers, not '{}'", text.substr(0, 60)));
    }
    return {.radius = base::parseNumber("--occlusion", parts[0]), .perLayer = parts.size() == 2};
}

render::Fog fogOf(const std::string& text) {
    const std::vector<std::string> parts = partsOf(text, ',');
    if (parts.size() != 1 && parts.size() != 4) {
        throw base::InputError(
            fmt::format("--fog takes VISIBILITY or VISIBILITY,r,g,b, not '{}'", text.substr(0, 60)));
    }
    render::Fog fog{.visibility = base::parseNumber("--fog", parts[0])};
    for (std::size_t i = 1; i < parts.size(); ++i) {
        fog.color[static_cast<int>(i) - 1] = static_cast<float>(base::parseNumber("--fog", parts[i]));
    }
    return fog;
}

} // namespace

void addEffectOptions(CLI::App& command, EffectArguments& arguments) {
    command.add_option("--antialias", arguments.antialias, "How edges are smoothed: none or edges")
        ->capture_default_str();
    command.add_option("--occlusion", arguments.occlusion,
                       "Ambient occlusion within RADIUS scene units; RADIUS:layers works it out on each "
                       "cascade's layer alone, as the thesis' method 2 has it");
    command.add_option("--fog", arguments.fog,
                       "Fog with a VISIBILITY in scene units, in which 2 % of a colour is left; "
                       "VISIBILITY,r,g,b gives its linear colour");
    command
        .add_option(
            "--tone-map", arguments.toneMap,
            "How bright light comes into the picture: none cuts it off, neutral compresses it and keeps base "
            "colours (Khronos PBR Neutral); scene: neutral under a sky or through air, else none")
        ->capture_default_str();
    command.add_option("--exposure", arguments.exposure, "Stops by which the picture is brighter, -16 to 16")
        ->check(CLI::Range(-render::kMaxExposure, render::kMaxExposure))
        ->capture_default_str();
    command.add_option("--light", arguments.light,
                       "Of a glTF file: sky (a computed one, default), lamps or file (its own lights)");
    command.add_option(
        "--focus", arguments.focus,
        "A lens sharp at view distance DISTANCE, as DISTANCE:APERTURE in scene units: cascades "
        "out of focus are drawn in fewer pixels, for --targets layers; with :blend they fade "
        "into each other");
    command
        .add_option("--shadows", arguments.shadows,
                    "How the first four lights cast shadows: none, anchored or plain")
        ->capture_default_str();
    command.add_option("--shadow-texels", arguments.shadowTexels, "Most texels of a side of a shadow map")
        ->check(CLI::Range(render::kMinShadowTexels, render::kMaxShadowTexels))
        ->capture_default_str();
    command
        .add_option("--translucency", arguments.translucency,
                    "How blended surfaces are laid over each other: weighted, or sorted, which is exact")
        ->capture_default_str();
    command
        .add_option("--translucency-memory", arguments.translucencyMiB,
                    "Most MiB for sorted fragments; frames that need more are drawn weighted")
        ->check(CLI::Range(std::uint64_t{1}, kMaxTranslucencyMiB))
        ->capture_default_str();
}

render::Effects effectsOf(const EffectArguments& arguments) {
    render::Effects effects{.antialias = render::parseAntialias(arguments.antialias)};
    if (!arguments.occlusion.empty()) {
        effects.occlusion = occlusionOf(arguments.occlusion);
    }
    if (!arguments.fog.empty()) {
        effects.fog = fogOf(arguments.fog);
    }
    effects.finish = {.toneMap = render::parseToneMap(arguments.toneMap), .exposure = arguments.exposure};
    requireUsable(effects);
    return effects;
}

render::Focus focusOf(const EffectArguments& arguments) {
    if (arguments.focus.empty()) {
        return {};
    }
    const std::vector<std::string> parts = partsOf(arguments.focus, ':');
    if (parts.size() < 2 || parts.size() > 3 || (parts.size() == 3 && parts[2] != "blend")) {
        throw base::InputError(
            fmt::format("--focus takes DISTANCE:APERTURE or DISTANCE:APERTURE:blend, not '{}'",
                        arguments.focus.substr(0, 60)));
    }
    const render::Focus focus{.distance = base::parseNumber("--focus", parts[0]),
                              .aperture = base::parseNumber("--focus", parts[1]),
                              .blend = parts.size() == 3};
    requireUsable(focus);
    return focus;
}

std::optional<scene::ModelLight> lightOf(const EffectArguments& arguments) {
    return arguments.light.empty() ? std::nullopt : std::optional(scene::parseModelLight(arguments.light));
}

render::Shadows shadowsOf(const EffectArguments& arguments) {
    return {.method = render::parseShadowMethod(arguments.shadows), .maxTexels = arguments.shadowTexels};
}

render::TranslucencyOptions translucencyOf(const EffectArguments& arguments) {
    return {.method = render::parseTranslucency(arguments.translucency),
            .maxBytes = arguments.translucencyMiB << 20u};
}

} // namespace cdr::options
