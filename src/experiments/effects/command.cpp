#include <cdr/render/effects.h>
#include <cli/comparison.h>
#include <experiments/columns.h>
#include <experiments/effects/effects.h>

#include <fmt/format.h>

namespace cdr::cli {

namespace {

struct EffectsArguments {
    experiments::EffectsOptions options;
    ComparisonArguments common;
};

experiments::Columns<experiments::EffectsResult> effectsColumns() {
    using Result = experiments::EffectsResult;
    return {{.key = "mode", .value = &Result::mode, .heading = "effect"},
            {.key = "execute_ms", .value = &Result::executeMs, .heading = "execute ms", .format = {"{:.2f}"}},
            {.key = "execute_ratio", .value = &Result::ratio, .heading = "over plain", .format = {"{:.3f}"}},
            {.key = "ci95",
             .value = [](const Result& result) { return experiments::jsonOf(result.ratio95); },
             .heading = "95 % interval",
             .format = {"{:.3f} to {:.3f}"}},
            {.key = "least_alike", .value = &Result::leastAlike, .heading = "under"},
            {.key = "differing",
             .value = &Result::differing,
             .heading = "differing",
             .format = {"{:.4f} %", 100.0},
             .before = "under"}};
}

void run(const GlobalOptions& global, EffectsArguments& arguments) {
    experiments::EffectsOptions& options = arguments.options;
    requireUsable(render::Effects{.occlusion = {.radius = options.occlusionRadius},
                                  .fog = {.visibility = options.visibility}});
    begin(arguments.common, options);
    const Session session(global);
    const Console console(global, arguments.common.output);
    const experiments::EffectsReport report =
        experiments::runEffects(session.device(), options, [&](std::size_t done, std::size_t all) {
            console.progress(done, all, "frames with effects");
        });
    console.endProgress();
    session.requireSilentValidation();

    const auto columns = effectsColumns();
    console.table(experiments::tableOf(columns, report.results));
    console.line(fmt::format("\nocclusion per layer leaves {:.3f} % of the pixels too bright",
                             100.0 * report.lostPerLayer));
    console.line(fmt::format("{}; {}, {} frames, {}x{}, radius {}, visibility {}, {} threads; differing: by "
                             "more than {} of 255 from anchored, which preset most",
                             describe(session.device()), options.scene, options.frames, options.width,
                             options.height, options.occlusionRadius, options.visibility, options.threads,
                             experiments::kEffectTolerance));
    nlohmann::ordered_json settings = settingsOf(options);
    settings.update({{"occlusion_radius", options.occlusionRadius}, {"visibility", options.visibility}});
    auto document = base::makeDocument("effects", session.documentDevice(), std::move(settings));
    for (const auto& result : report.results) {
        auto& row = document["results"].emplace_back(experiments::jsonOf(columns, result));
        keepPicture(arguments.common, "picture", result.mode + ".png", result.picture, row);
    }
    document["lost_per_layer"] = report.lostPerLayer;
    writeJson(arguments.common.output, document);
}

} // namespace

void addEffects(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "effects", "What screen-space effects cost, and whether they look alike under every technique");
    auto arguments = std::make_shared<EffectsArguments>();
    experiments::EffectsOptions& options = arguments->options;
    addComparison(*command, options, arguments->common);
    command->add_option("--occlusion", options.occlusionRadius, "Radius of ambient occlusion, scene units")
        ->capture_default_str();
    command->add_option("--fog", options.visibility, "Visibility in fog, scene units")->capture_default_str();
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
