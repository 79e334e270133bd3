#include <cdr/render/effects.h>
#include <cli/comparison.h>
#include <experiments/effects/effects.h>

#include <fmt/format.h>

namespace cdr::cli {

namespace {

struct EffectsArguments {
    experiments::EffectsOptions options;
    ComparisonArguments common;
};

nlohmann::ordered_json toJson(const experiments::EffectsResult& result) {
    return {{"mode", result.mode},
            {"execute_ms", result.executeMs},
            {"execute_ratio", result.ratio},
            {"ci95", {result.ratio95.low, result.ratio95.high}},
            {"least_alike", result.leastAlike},
            {"differing", result.differing}};
}

void printTable(const Console& console, const experiments::EffectsReport& report) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& result : report.results) {
        rows.push_back({result.mode, fmt::format("{:.2f}", result.executeMs),
                        fmt::format("{:.3f}", result.ratio),
                        fmt::format("{:.3f} to {:.3f}", result.ratio95.low, result.ratio95.high),
                        fmt::format("{:.4f} %", 100.0 * result.differing), result.leastAlike});
    }
    console.table({"effect", "execute ms", "over plain", "95 % interval", "differing", "under"}, rows);
    console.line(fmt::format("\nocclusion per layer leaves {:.3f} % of the pixels too bright",
                             100.0 * report.lostPerLayer));
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

    printTable(console, report);
    console.line(fmt::format("{}; {}, {} frames, {}x{}, radius {}, visibility {}, {} threads; differing: by "
                             "more than {} of 255 from anchored, which preset most",
                             describe(session.device()), options.scene, options.frames, options.width,
                             options.height, options.occlusionRadius, options.visibility, options.threads,
                             experiments::kEffectTolerance));
    nlohmann::ordered_json settings = settingsOf(options);
    settings.update({{"occlusion_radius", options.occlusionRadius}, {"visibility", options.visibility}});
    auto document = host::makeDocument("effects", session.documentDevice(), std::move(settings));
    for (const auto& result : report.results) {
        auto& row = document["results"].emplace_back(toJson(result));
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
