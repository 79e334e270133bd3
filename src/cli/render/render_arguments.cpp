#include "render_arguments.h"

#include "../shared_options.h"

#include <cdr/base/enum_names.h>
#include <cdr/base/error.h>

#include <options/drawing_options.h>
#include <options/effect_options.h>
#include <options/help_texts.h>
#include <options/parsed_option.h>

namespace cdr::cli {

depth::NamedTechnique techniqueOf(const RenderArguments& arguments) {
    if (arguments.parts.isGiven() && arguments.technique) {
        throw base::InputError("give either --technique, or --depth and --split");
    }
    depth::NamedTechnique named = arguments.technique.value_or(depth::namedTechnique("reversed"));
    if (arguments.parts.isGiven()) {
        named.technique = arguments.parts.technique();
        named.name = partsOf(named.technique);
    }
    named.technique.format = arguments.format.value_or(named.technique.format);
    return named;
}

render::RenderOptions optionsOf(const RenderArguments& arguments) {
    render::RenderOptions options = arguments.drawing;
    options.technique = techniqueOf(arguments).technique;
    options.linear = arguments.aov == output::Aov::linear;
    options.translucency.countsFragments = arguments.aov == output::Aov::coverage;
    return options;
}

nlohmann::ordered_json optionsJson(const RenderArguments& arguments, const depth::Technique& technique) {
    nlohmann::ordered_json options{{"scene", arguments.scene},
                                   {"mapping", nameOf(technique.mapping)},
                                   {"split", nameOf(technique.split)},
                                   {"format", nameOf(technique.format)},
                                   {"width", arguments.drawing.width},
                                   {"height", arguments.drawing.height},
                                   {"seed", arguments.seed},
                                   {"aov", nameOf(arguments.aov)},
                                   {"snap_bits", arguments.drawing.snapBits},
                                   {"snapping", nameOf(arguments.drawing.snapping)}};
    options::addChoiceJson(options, arguments.choice);
    if (arguments.deform) {
        options["deform"] = nameOf(*arguments.deform);
    }
    if (!arguments.layers.texts.empty()) {
        options["layers"] = arguments.layers.texts;
    }
    options::addViewsJson(options, arguments.views);
    return options;
}

namespace {

constexpr base::EnumNames<FrameDivision, 2> kDivisions{"division among ranks", {"frames", "cascades"}};

void addTechniqueOptions(CLI::App& command, RenderArguments& arguments) {
    options::addParsed(command, "--technique", arguments.technique, depth::namedTechnique,
                       "Technique: " + options::techniqueHelp())
        ->default_str("reversed");
    options::addTechniqueParts(command, arguments.parts);
    options::addDepthFormat(command, arguments.format);
    render::RenderOptions& options = arguments.drawing;
    options::addTargets(command, options.targets);
    options::addSubmission(command, options);
    options::addNamed(command, "--surface", options.surface, render::parseSurfacePath, options::kSurfaceHelp);
    command.add_flag("--occlusion-culling", options.occlusionCulling,
                     "Do not draw what opaque surfaces hide; the picture is the same");
    options::addDetail(command, options.detail);
    addThreads(command, options.threads);
}

void addRenderEffects(CLI::App& command, RenderArguments& arguments) {
    options::addEffectOptions(command, arguments.drawing, arguments.choice);
    // Not in the viewer, whose panels turn both on later.
    command.get_option("--shadow-texels")->needs(command.get_option("--shadows"));
    command.get_option("--translucency-memory")->needs(command.get_option("--translucency"));
}

} // namespace

void addRenderOptions(CLI::App& command, RenderArguments& arguments) {
    command.add_option("scene", arguments.scene, options::sceneHelp())->required();
    command.option_defaults()->group("Technique");
    addTechniqueOptions(command, arguments);
    command.option_defaults()->group("Effects");
    addRenderEffects(command, arguments);
    command.option_defaults()->group("Camera");
    options::addFrameOptions(command, arguments.camera);
    options::addCameraOptions(command, arguments.camera);
    command.option_defaults()->group("Views");
    options::addStereoOptions(command, arguments.views);
    options::addViewsOption(command, arguments.views);
    command.option_defaults()->group("Scene");
    options::addSceneChoice(command, arguments.choice);
    options::addAnimationChoice(command, arguments.choice);
    options::addDeform(command, arguments.deform);
    addSeed(command, arguments.seed);
    options::addColours(command, arguments.colours);
    options::addLayers(command, arguments.layers);
    command.option_defaults()->group("Ranks");
    options::addParsed(
        command, "--ranks", arguments.ranks, [](const std::string& name) { return kDivisions.parse(name); },
        "What the ranks of an MPI run divide: frames, or the cascades of each frame. With cascades, leave out "
        "--antialias, --occlusion RADIUS, --shadows, --focus, --occlusion-culling, --submission gpu-driven, --aov "
        "linear and blended materials")
        ->default_str("frames");
    command.option_defaults()->group("Output");
    addSize(command, arguments.drawing.width, arguments.drawing.height);
    addSnapBits(command, arguments.drawing.snapBits);
    addSnapping(command, arguments.drawing.snapping);
    options::addNamed(
        command, "--aov", arguments.aov, output::parseAov,
        "What the picture shows: color, linear (light before tone mapping), id, distance, normal, cascade, wrong "
        "(wrong pixels) or coverage (number of translucent surfaces)");
    options::addFile(
        command, "-o,--output", arguments.file,
        "Picture to write, .png, .tga or .exr; %04d in its name is replaced by the frame number");
    options::addFile(
        command, "--certify", arguments.certify,
        "Prove that each pixel is right, repair wrong ones, and write the certificate to FILE, .json. "
        "Exit status 3 if a pixel shows an error that the device may not make");
    addTrace(command, arguments.trace, "the CPU threads and the cascades");
    addState(command, arguments.state);
    command.add_flag("--hash", arguments.hash, "Print the SHA-256 hash of the values of each output");
}

} // namespace cdr::cli
