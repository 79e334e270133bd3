#include "render_arguments.h"

#include "../shared_options.h"

#include <cdr/base/enum_names.h>
#include <cdr/base/error.h>
#include <scenes/colours.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace cdr::cli {

depth::NamedTechnique techniqueOf(const RenderArguments& arguments) {
    const bool byParts = !arguments.depth.empty() || !arguments.split.empty();
    if (byParts && !arguments.technique.empty()) {
        throw base::InputError("give either --technique, or --depth and --split");
    }
    depth::NamedTechnique named =
        depth::namedTechnique(arguments.technique.empty() ? "reversed" : arguments.technique);
    if (byParts) {
        named.technique = {.mapping =
                               depth::parseMapping(arguments.depth.empty() ? "standard" : arguments.depth),
                           .split = depth::parseSplit(arguments.split.empty() ? "none" : arguments.split)};
        named.name = partsOf(named.technique);
    }
    if (!arguments.format.empty()) {
        named.technique.format = depth::parseDepthFormat(arguments.format);
    }
    return named;
}

render::RenderOptions optionsOf(const RenderArguments& arguments, output::Aov aov) {
    render::RenderOptions options{.width = arguments.width,
                                  .height = arguments.height,
                                  .technique = techniqueOf(arguments).technique,
                                  .targets = render::parseTargets(arguments.targets),
                                  .threads = arguments.threads,
                                  .submission = render::parseSubmission(arguments.submission),
                                  .batching = render::parseBatching(arguments.batching),
                                  .surface = render::parseSurfacePath(arguments.surface),
                                  .detail = visibility::parseDetail(arguments.detail),
                                  .effects = options::effectsOf(arguments.effects),
                                  .focus = options::focusOf(arguments.effects),
                                  .translucency = options::translucencyOf(arguments.effects)};
    options.snapBits = arguments.snapBits;
    options.snapping = arguments.snapping;
    options.occlusionCulling = arguments.occlusionCulling;
    options.shadows = options::shadowsOf(arguments.effects);
    options.translucency.countsFragments = aov == output::Aov::coverage;
    return options;
}

nlohmann::ordered_json optionsJson(const RenderArguments& arguments, const depth::Technique& technique) {
    nlohmann::ordered_json options{
        {"scene", arguments.scene},         {"mapping", nameOf(technique.mapping)},
        {"split", nameOf(technique.split)}, {"format", nameOf(technique.format)},
        {"width", arguments.width},         {"height", arguments.height},
        {"seed", arguments.seed},           {"aov", arguments.aov},
        {"snap_bits", arguments.snapBits},  {"snapping", nameOf(arguments.snapping)}};
    const auto add = [&](const char* key, const auto& value) {
        if (value) {
            options[key] = *value;
        }
    };
    add("animation", arguments.choice.animation);
    add("time", arguments.choice.seconds);
    add("fps", arguments.choice.framesPerSecond);
    if (!arguments.layers.empty()) {
        options["layers"] = arguments.layers;
    }
    options::addViewsJson(options, arguments.views);
    return options;
}

namespace {

void addTechniqueOptions(CLI::App& command, RenderArguments& arguments) {
    command.add_option("--technique", arguments.technique,
                       "Preset: standard, cdr, log, logcdr, reversed (default) or anchored");
    command.add_option("--depth", arguments.depth,
                       "Depth mapping, instead of a preset: " + base::listNames(depth::kMappings));
    command.add_option(
        "--split", arguments.split,
        "How cascades are cut: none, ratio:R, count:K, at:a,b,..., minimax:K or fitted[:TARGET[px][,max=K]]");
    command.add_option("--format", arguments.format, "Depth buffer: d16, d24 or d32f");
    command
        .add_option("--targets", arguments.targets,
                    "How cascades reach the G-buffer, pool as pool:LAYERS too: " +
                        base::listNames(render::kTargetsKinds))
        ->capture_default_str();
    command
        .add_option("--submission", arguments.submission,
                    "How draws reach the device: secondaries, primaries or gpu-driven")
        ->capture_default_str();
    command
        .add_option("--batching", arguments.batching,
                    "How draws become commands: per-object, push-constants or instanced")
        ->capture_default_str();
    command
        .add_option("--surface", arguments.surface,
                    "What is kept of surfaces until they are shaded: gbuffer or visibility; or lit, "
                    "which shades matt surfaces while they are drawn")
        ->capture_default_str();
    command.add_flag("--occlusion-culling", arguments.occlusionCulling,
                     "Leave out what opaque surfaces hide; the picture is the same");
    command
        .add_option(
            "--detail", arguments.detail,
            "Level of detail by projected error: none, object[:PIXELS], cascade[:PIXELS] or cluster[:PIXELS]")
        ->capture_default_str();
    command.add_option("--threads", arguments.threads, "Threads that cull, bin and record")
        ->capture_default_str();
}

} // namespace

void addRenderOptions(CLI::App& command, RenderArguments& arguments) {
    command
        .add_option("scene", arguments.scene,
                    fmt::format("{}, or a .gltf or .glb file", fmt::join(scenes::generatedScenes(), ", ")))
        ->required();
    command.option_defaults()->group("Technique");
    addTechniqueOptions(command, arguments);
    command.option_defaults()->group("Effects");
    options::addEffectOptions(command, arguments.effects);
    command.option_defaults()->group("Camera");
    options::addFrameOptions(command, arguments.camera);
    options::addCameraOptions(command, arguments.camera);
    command.option_defaults()->group("Views");
    options::addStereoOptions(command, arguments.views);
    options::addViewsOption(command, arguments.views);
    command.option_defaults()->group("Scene");
    options::addSceneChoice(command, arguments.choice);
    options::addAnimationChoice(command, arguments.choice);
    addSeed(command, arguments.seed, "Seed of a random scene");
    options::addColours(command, arguments.colours);
    options::addLayers(command, arguments.layers);
    command.option_defaults()->group("Ranks");
    command
        .add_option(
            "--ranks", arguments.ranks,
            "What the ranks of an MPI run divide: frames, or the cascades of each frame, which are drawn apart "
            "and laid over each other, the nearest on top. Cascades go without smoothed edges, whole-picture "
            "occlusion, a focus, blended materials and gpu-driven draws")
        ->capture_default_str();
    command.option_defaults()->group("Output");
    addSize(command, arguments.width, arguments.height);
    addSnapBits(command, arguments.snapBits);
    addSnapping(command, arguments.snapping);
    command
        .add_option("--aov", arguments.aov, "Output: color, id, distance, normal, cascade, wrong or coverage")
        ->capture_default_str();
    command.add_option("-o,--output", arguments.file,
                       "Picture to write: .png, .tga or .exr; %04d stands for the frame");
    command.add_option(
        "--certify", arguments.certify,
        "Prove that each pixel is right, cast rays for those in doubt and repair wrong ones; the certificate to "
        "write, .json. Status 3 if the device was outside its limits");
    command.add_option(
        "--trace", arguments.trace,
        "Write workers, cascades and execute as a trace for ui.perfetto.dev or chrome://tracing");
    command.add_option(
        "--state", arguments.state,
        "File that keeps the result of each frame; started again, the run makes only what is missing");
    command.add_flag("--hash", arguments.hash, "Print a SHA-256 of each output's values");
}

} // namespace cdr::cli
