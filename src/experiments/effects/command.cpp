#include <cdr/base/error.h>
#include <cdr/render/effects.h>
#include <cli/commands.h>
#include <experiments/comparison_command.h>
#include <experiments/effects/effects.h>

#include <fmt/format.h>
#include <output/columns.h>
#include <output/readable.h>

#include <string>

namespace cdr::cli {

namespace {

struct EffectsArguments {
    experiments::EffectsOptions options;
    scene::GltfChoice choice;
    std::filesystem::path folder;
};

output::Columns<experiments::EffectsResult> effectsColumns() {
    using Result = experiments::EffectsResult;
    return {{.key = "mode",
             .value = [](const Result& result) { return nameOf(result.mode); },
             .heading = "effect"},
            {.key = "execute_ms", .value = &Result::executeMs, .heading = "execute ms"},
            {.key = "execute_ratio", .value = &Result::ratio, .heading = "over plain"},
            output::intervalColumn(&Result::ratio95),
            {.key = "least_alike", .value = &Result::leastAlike, .heading = "under"},
            {.key = "differing",
             .value = &Result::differing,
             .heading = "differing",
             .format = {"{} %", 100.0},
             .before = "under"}};
}

std::string effectPicture(experiments::EffectMode mode) {
    return fmt::format("{}.png", nameOf(mode));
}

void run(Command& command, EffectsArguments& arguments) {
    experiments::EffectsOptions& options = arguments.options;
    requireUsable(render::Effects{.occlusion = {.radius = options.occlusionRadius},
                                  .fog = {.visibility = options.visibility}});
    if (options.occlusionRadius == 0.0 || options.visibility == 0.0) {
        throw base::InputError(
            "--occlusion and --fog must be above 0: without an effect there is nothing to compare");
    }
    const PictureFolder folder(arguments.folder, command.files(),
                               PictureFolder::oneOf(experiments::kEffectModes, effectPicture));
    const scene::SceneSetup setup = command.openScene(options.scene, options.seed, arguments.choice);
    runs::TimedRanks ranks(command.ranks());
    const experiments::EffectsReport report = experiments::runEffects(
        command.device(), setup, options, command.progressOf("frames with effects"), ranks);
    command.endProgress();
    if (!ranks.isFirst()) {
        return;
    }

    const auto columns = effectsColumns();
    command.console().table(output::tableOf(columns, report.results));
    command.console().line(fmt::format(
        "\nOcclusion that is computed in each cascade separately leaves {} % of the pixels too bright.",
        output::percent(report.lostPerLayer)));
    command.console().line(fmt::format(
        "{}; {}, {} frames, {}x{}, radius {}, visibility {}, {} threads; differing: by "
        "more than {} of 255 from anchored, which technique most",
        command.opened().text(), options.scene, options.frames, options.drawing.width, options.drawing.height,
        options.occlusionRadius, options.visibility, options.drawing.threads, experiments::kEffectTolerance));
    nlohmann::ordered_json settings = settingsOf(options, arguments.choice);
    settings.update({{"occlusion_radius", options.occlusionRadius}, {"visibility", options.visibility}});
    if (!options.techniques.empty()) {
        auto& techniques = settings["techniques"];
        for (const depth::NamedTechnique& named : options.techniques) {
            techniques.push_back(named.name);
        }
    }
    auto document = command.makeDocument(std::move(settings));
    for (const auto& result : report.results) {
        auto& row = document["results"].emplace_back(output::jsonOf(columns, result));
        folder.write("picture", effectPicture(result.mode), result.picture, row);
    }
    document["lost_per_layer"] = report.lostPerLayer;
    runs::addMeasuredBy(document, command.ranks(), ranks.measuredBy("frames"));
    command.writeDocument(document);
}

void addOptions(CLI::App& command, EffectsArguments& arguments) {
    experiments::EffectsOptions& options = arguments.options;
    addComparison(command, options, arguments.choice, arguments.folder);
    addTechniques(command, options.techniques);
    addValue(command, "--occlusion", options.occlusionRadius, "Radius of ambient occlusion, in scene units");
    addValue(command, "--fog", options.visibility,
             "Distance at which fog leaves 2 % of a colour, in scene units");
}

} // namespace

void addEffects(CLI::App& program, const GlobalOptions& global) {
    addCommand<EffectsArguments>(
        program, global, "effects",
        "Measure what screen-space effects cost, and whether they look the same with every technique",
        addOptions, run, RankUse::timed);
}

} // namespace cdr::cli
