#include "effect_options.h"

#include "help_texts.h"
#include "parsed_option.h"
#include "scene_options.h"

#include <CLI/CLI.hpp>
#include <cdr/base/format_error.h>
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
        throw base::inputError("--occlusion takes RADIUS or RADIUS:layers, not '{}'", text.substr(0, 60));
    }
    const render::Occlusion occlusion{.radius = base::parseNumber("--occlusion", parts[0]),
                                      .perLayer = parts.size() == 2};
    requireUsable(render::Effects{.occlusion = occlusion});
    return occlusion;
}

render::Fog fogOf(const std::string& text) {
    const std::vector<std::string> parts = partsOf(text, ',');
    if (parts.size() != 1 && parts.size() != 4) {
        throw base::inputError("--fog takes VISIBILITY or VISIBILITY,r,g,b, not '{}'", text.substr(0, 60));
    }
    render::Fog fog{.visibility = base::parseNumber("--fog", parts[0])};
    for (std::size_t i = 1; i < parts.size(); ++i) {
        fog.color[static_cast<int>(i) - 1] = static_cast<float>(base::parseNumber("--fog", parts[i]));
    }
    requireUsable(render::Effects{.fog = fog});
    return fog;
}

render::Focus focusOf(const std::string& text) {
    const std::vector<std::string> parts = partsOf(text, ':');
    if (parts.size() < 2 || parts.size() > 3 || (parts.size() == 3 && parts[2] != "blend")) {
        throw base::inputError("--focus takes DISTANCE:APERTURE or DISTANCE:APERTURE:blend, not '{}'",
                               text.substr(0, 60));
    }
    const render::Focus focus{.distance = base::parseNumber("--focus", parts[0]),
                              .aperture = base::parseNumber("--focus", parts[1]),
                              .blend = parts.size() == 3};
    requireUsable(focus);
    return focus;
}

void addPictureEffects(CLI::App& command, render::Effects& effects) {
    addNamed(command, "--antialias", effects.antialias, render::parseAntialias,
             "Smoothing of edges: none or edges");
    addParsed(
        command, "--occlusion", effects.occlusion, occlusionOf,
        "Ambient occlusion by surfaces within RADIUS scene units; RADIUS:layers computes it in each cascade "
        "separately (method 2 of the thesis)")
        ->default_str("none");
    addParsed(
        command, "--fog", effects.fog, fogOf,
        "Fog that leaves 2 % of a colour at a distance of VISIBILITY scene units; VISIBILITY,R,G,B also sets "
        "its linear colour")
        ->default_str("none");
    addNamed(
        command, "--tone-map", effects.finish.toneMap, render::parseToneMap,
        "Tone mapping: none (bright light is clipped), neutral (Khronos PBR Neutral: bright light is compressed, "
        "base colours stay) or scene (neutral with a sky or air, else none)");
    command
        .add_option_function<double>(
            "--exposure",
            [&effects](double stops) {
                effects.finish.exposure = stops;
                requireUsable(effects); // the range lets NaN through
            },
            fmt::format("Exposure in stops, -{0} to {0}: each stop doubles the light", render::kMaxExposure))
        ->check(CLI::Range(-render::kMaxExposure, render::kMaxExposure))
        ->default_str(fmt::format("{}", effects.finish.exposure));
}

void addTranslucency(CLI::App& command, render::TranslucencyOptions& translucency) {
    addNamed(command, "--translucency", translucency.method, render::parseTranslucency,
             "How translucent surfaces are blended: weighted (approximate) or sorted (exact)");
    command
        .add_option_function<std::uint64_t>(
            "--translucency-memory",
            [&translucency](std::uint64_t mebibytes) { translucency.maxBytes = mebibytes << 20u; },
            kTranslucencyMemoryHelp)
        ->check(CLI::Range(std::uint64_t{1}, kMaxTranslucencyMiB))
        ->default_str(fmt::format("{}", translucency.maxBytes >> 20u));
}

} // namespace

void addEffectOptions(CLI::App& command, render::RenderOptions& options, scene::GltfChoice& choice) {
    addPictureEffects(command, options.effects);
    addLight(command, choice, scene::ModelLight::sky);
    addParsed(
        command, "--focus", options.focus, focusOf,
        "Depth of field, as DISTANCE:APERTURE or DISTANCE:APERTURE:blend: the distance in focus and the "
        "diameter of the lens, in scene units. Cascades out of focus get fewer pixels; with :blend they fade "
        "into each other. Needs --targets layers")
        ->default_str("none");
    addNamed(command, "--shadows", options.shadows.method, render::parseShadowMethod,
             "Shadows of the first four lights: none, anchored, or plain (the usual method)");
    addValue(command, "--shadow-texels", options.shadows.maxTexels, shadowTexelsHelp())
        ->check(CLI::Range(render::kMinShadowTexels, render::kMaxShadowTexels));
    addTranslucency(command, options.translucency);
}

} // namespace cdr::options
