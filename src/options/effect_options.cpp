#include "effect_options.h"

#include "parsed_option.h"
#include "scene_options.h"

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
    const render::Occlusion occlusion{.radius = base::parseNumber("--occlusion", parts[0]),
                                      .perLayer = parts.size() == 2};
    requireUsable(render::Effects{.occlusion = occlusion});
    return occlusion;
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
    requireUsable(render::Effects{.fog = fog});
    return fog;
}

render::Focus focusOf(const std::string& text) {
    const std::vector<std::string> parts = partsOf(text, ':');
    if (parts.size() < 2 || parts.size() > 3 || (parts.size() == 3 && parts[2] != "blend")) {
        throw base::InputError(fmt::format(
            "--focus takes DISTANCE:APERTURE or DISTANCE:APERTURE:blend, not '{}'", text.substr(0, 60)));
    }
    const render::Focus focus{.distance = base::parseNumber("--focus", parts[0]),
                              .aperture = base::parseNumber("--focus", parts[1]),
                              .blend = parts.size() == 3};
    requireUsable(focus);
    return focus;
}

void addPictureEffects(CLI::App& command, render::Effects& effects) {
    addNamed(command, "--antialias", effects.antialias, render::parseAntialias,
             "How edges are smoothed: none or edges");
    addParsed(command, "--occlusion", effects.occlusion, occlusionOf,
              "Ambient occlusion within RADIUS scene units; RADIUS:layers works it out on each "
              "cascade alone, as the thesis' method 2 has it");
    addParsed(command, "--fog", effects.fog, fogOf,
              "Fog with a VISIBILITY in scene units, in which 2 % of a colour is left; "
              "VISIBILITY,r,g,b gives its linear colour");
    addNamed(
        command, "--tone-map", effects.finish.toneMap, render::parseToneMap,
        "How bright light comes into the picture: none cuts it off, neutral compresses it and keeps base "
        "colours (Khronos PBR Neutral); scene: neutral under a sky or through air, else none");
    command
        .add_option_function<double>(
            "--exposure",
            [&effects](double stops) {
                effects.finish.exposure = stops;
                requireUsable(effects); // the range lets NaN through
            },
            "Stops by which the picture is brighter, -16 to 16")
        ->check(CLI::Range(-render::kMaxExposure, render::kMaxExposure))
        ->default_str(fmt::format("{}", effects.finish.exposure));
}

void addTranslucency(CLI::App& command, render::TranslucencyOptions& translucency) {
    addNamed(command, "--translucency", translucency.method, render::parseTranslucency,
             "How blended surfaces are laid over each other: weighted, or sorted, which is exact");
    command
        .add_option_function<std::uint64_t>(
            "--translucency-memory",
            [&translucency](std::uint64_t mebibytes) { translucency.maxBytes = mebibytes << 20u; },
            "Most MiB for sorted fragments; frames that need more are drawn weighted")
        ->check(CLI::Range(std::uint64_t{1}, kMaxTranslucencyMiB))
        ->default_str(fmt::format("{}", translucency.maxBytes >> 20u));
}

} // namespace

void addEffectOptions(CLI::App& command, render::RenderOptions& options, scene::GltfChoice& choice) {
    addPictureEffects(command, options.effects);
    addLight(command, choice, scene::ModelLight::sky);
    addParsed(command, "--focus", options.focus, focusOf,
              "A lens sharp at view distance DISTANCE, as DISTANCE:APERTURE in scene units: cascades "
              "out of focus are drawn in fewer pixels, for --targets layers; with :blend they fade "
              "into each other");
    addNamed(command, "--shadows", options.shadows.method, render::parseShadowMethod,
             "How the first four lights cast shadows: none, anchored or plain");
    command.add_option("--shadow-texels", options.shadows.maxTexels, "Most texels of a side of a shadow map")
        ->check(CLI::Range(render::kMinShadowTexels, render::kMaxShadowTexels))
        ->capture_default_str();
    addTranslucency(command, options.translucency);
}

} // namespace cdr::options
