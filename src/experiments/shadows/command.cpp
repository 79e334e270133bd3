#include <cli/command.h>
#include <cli/commands.h>
#include <cli/picture_folder.h>
#include <experiments/shadows/shadows.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <options/help_texts.h>
#include <options/parsed_option.h>
#include <output/columns.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cdr::cli {

namespace {

struct ShadowArguments {
    experiments::ShadowExperiment experiment;
    std::string scene = "alley";
    std::uint64_t seed = scenes::kDefaultSeed;
    options::CameraOptions camera;
    scene::GltfChoice choice;
    std::filesystem::path folder;
};

output::Columns<experiments::ShadowResult> shadowColumns() {
    using Result = experiments::ShadowResult;
    using Wrong = measure::WrongShadows;
    using Flips = measure::FlipCount;
    const output::Columns<Wrong> wrong{
        {.key = "pixels", .value = &Wrong::pixels, .heading = "pixels"},
        {.key = "shadowed", .value = &Wrong::shadowed, .heading = "shadowed"},
        {.key = "wrong", .value = &Wrong::wrong, .heading = "wrong"},
        {.key = "wrong_fraction",
         .value = &Wrong::fraction,
         .heading = "wrong",
         .format = {.pattern = "{} %", .scale = 100.0}},
        {.key = "edge_wrong", .value = &Wrong::edgeWrong, .heading = "wrong at edges"}};
    const output::Columns<Flips> flips{{.key = "flips", .value = &Flips::flips, .heading = "flips"},
                                       {.key = "flips_compared", .value = &Flips::compared}};
    return output::joined<Result>(
        {{{.key = "technique", .value = &Result::technique, .heading = "technique"},
          {.key = "method", .value = &Result::method, .heading = "method"},
          {.key = "frame", .value = &Result::frame, .heading = "frame"},
          {.key = "light", .value = &Result::light, .heading = "light"}},
         output::columnsOf(&Result::wrong, wrong),
         output::columnsOf<Result>(&Result::flips, flips), // since the frame before
         {{.key = "maps", .value = &Result::maps, .heading = "maps"},
          {.key = "casters", .value = &Result::casters, .heading = "casters"},
          {.key = "execute_ms", .value = &Result::executeMs, .heading = "execute ms"}}});
}

/// Of the files of a technique and a method of shadows.
std::string startOf(const std::string& technique, std::string_view method) {
    return fmt::format("{}_{}_", technique, method);
}

/// Whether a name goes on behind its start as "0_1.png" or "0_1_wrong.png" do.
bool isNumbered(std::string_view rest) {
    const std::string_view end = rest.substr(std::min(rest.find_first_not_of("0123456789_"), rest.size()));
    return end == ".png" || end == "wrong.png";
}

/// Which files of a folder may be one of the pictures, by their names. The lights of the scene are not known yet.
std::function<bool(const std::string& name)> shadowFiles(const experiments::ShadowExperiment& experiment) {
    std::vector<std::string> starts;
    for (const depth::NamedTechnique& technique : experiment.techniques) {
        for (const render::ShadowMethod method : experiment.methods) {
            starts.push_back(PictureFolder::nameInFolder(startOf(technique.name, nameOf(method))));
        }
    }
    return [starts](const std::string& name) {
        return std::ranges::any_of(starts, [&](const std::string& start) {
            return name.starts_with(start) && isNumbered(std::string_view(name).substr(start.size()));
        });
    };
}

void run(Command& command, ShadowArguments& arguments) {
    experiments::ShadowExperiment& experiment = arguments.experiment;
    if (!arguments.camera.path.empty()) {
        command.reads(arguments.camera.path);
    }
    const options::FrameCameras cameras(arguments.camera);
    const PictureFolder folder(arguments.folder, command.files(), shadowFiles(experiment));
    const scene::SceneSetup setup = command.openScene(arguments.scene, arguments.seed, arguments.choice);
    const gpu::Device& device = command.device(); // which the document names
    const auto columns = shadowColumns();
    output::Table table = output::tableOf(columns, std::vector<experiments::ShadowResult>());
    auto document = command.makeDocument({{"scene", arguments.scene},
                                          {"seed", arguments.seed},
                                          {"width", experiment.options.width},
                                          {"height", experiment.options.height},
                                          {"surface", nameOf(experiment.options.surface)},
                                          {"snap_bits", experiment.options.snapBits},
                                          {"threads", experiment.options.threads}});
    options::addChoiceJson(document["options"], arguments.choice);
    experiments::runShadows(device, setup, cameras, experiment, command.progressOf(arguments.scene),
                            [&](const experiments::ShadowResult& result) {
                                nlohmann::ordered_json row = output::jsonOf(columns, result);
                                const std::string stem =
                                    fmt::format("{}{}_{}", startOf(result.technique, result.method),
                                                result.frame, result.light);
                                folder.write("picture", stem + ".png", result.picture, row);
                                folder.write("wrong_picture", stem + "_wrong.png", result.heatMap, row);
                                document["results"].push_back(std::move(row));
                                table.rows.push_back(output::cellsOf(columns, result));
                            });
    command.endProgress();
    command.console().table(table);
    command.console().line(fmt::format("\n{}; {}, {}x{}, except at edges of objects and shadows",
                                       command.opened().text(), arguments.scene, experiment.options.width,
                                       experiment.options.height));
    command.writeDocument(std::move(document));
}

void addOptions(CLI::App& command, ShadowArguments& arguments) {
    experiments::ShadowExperiment& experiment = arguments.experiment;
    addValue(command, "scene", arguments.scene, "A generated scene with lights, or a .gltf or .glb file");
    addTechniques(command, experiment.techniques)->default_str("anchored");
    options::addParsedList(
        command, "--methods", experiment.methods, render::parseShadowMethod,
        "Shadow methods to compare, separated by commas: anchored, plain (the usual method)")
        ->default_str("anchored");
    addValue(command, "--shadow-texels", experiment.options.shadows.maxTexels, options::shadowTexelsHelp())
        ->check(CLI::Range(render::kMinShadowTexels, render::kMaxShadowTexels));
    options::addNamed(command, "--surface", arguments.experiment.options.surface, render::parseSurfacePath,
                      options::kSurfaceHelp);
    options::addFrameOptions(command, arguments.camera);
    options::addCameraOptions(command, arguments.camera);
    options::addStillChoice(command, arguments.choice);
    options::addLight(command, arguments.choice, scene::ModelLight::lamps);
    addSize(command, experiment.options.width, experiment.options.height);
    addSnapBits(command, experiment.options.snapBits);
    addThreads(command, experiment.options.threads);
    addSeed(command, arguments.seed);
    options::addFolder(command, "--out", arguments.folder, "Folder for the pictures and their wrong shadows");
}

} // namespace

void addShadows(CLI::App& program, const GlobalOptions& global) {
    addCommand<ShadowArguments>(program, global, "shadows",
                                "Count wrong pixels of shadows, compared with float64 rays", addOptions, run);
}

} // namespace cdr::cli
