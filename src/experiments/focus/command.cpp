#include <cli/comparison.h>
#include <experiments/focus/focus.h>

#include <fmt/format.h>

namespace cdr::cli {

namespace {

struct FocusArguments {
    experiments::FocusOptions options;
    std::string depth = "reversed";
    std::string split;
    ComparisonArguments common;
};

nlohmann::ordered_json toJson(const experiments::FocusResult& result) {
    return {{"mode", result.mode},
            {"frame_ms", result.frameMs},
            {"execute_ms", result.executeMs},
            {"execute_speedup", result.speedup},
            {"ci95", {result.speedup95.low, result.speedup95.high}},
            {"pixels", result.pixels},
            {"flip", result.flip},
            {"rmse", result.rmse}};
}

nlohmann::ordered_json toJson(const experiments::FocusCascade& cascade) {
    return {{"near", cascade.nearView}, {"far", cascade.farView}, {"scale", cascade.scale}};
}

void printTable(const Console& console, const experiments::FocusReport& report) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& result : report.results) {
        rows.push_back({result.mode, fmt::format("{:.2f}", static_cast<double>(result.pixels) / 1e6),
                        fmt::format("{:.2f}", result.frameMs), fmt::format("{:.2f}", result.executeMs),
                        fmt::format("{:.3f}", result.speedup),
                        fmt::format("{:.3f} to {:.3f}", result.speedup95.low, result.speedup95.high),
                        fmt::format("{:.4f}", result.flip), fmt::format("{:.4f}", result.rmse)});
    }
    console.table(
        {"lens", "megapixels", "frame ms", "execute ms", "speed-up", "95 % interval", "FLIP", "RMSE"}, rows);
    for (const auto& cascade : report.cascades) {
        console.line(fmt::format("cascade from {:.4g} to {:.4g}: {} pixels a pixel", cascade.nearView,
                                 cascade.farView, cascade.scale));
    }
}

void run(const GlobalOptions& global, FocusArguments& arguments) {
    experiments::FocusOptions& options = arguments.options;
    options.mapping = depth::parseMapping(arguments.depth);
    if (!arguments.split.empty()) {
        options.split = depth::parseSplit(arguments.split);
    }
    requireUsable(options.lens);
    begin(arguments.common, options);
    const Session session(global);
    const Console console(global, arguments.common.output);
    const experiments::FocusReport report =
        experiments::runFocus(session.device(), options, [&](std::size_t done, std::size_t all) {
            console.progress(done, all, "frames through the lens");
        });
    console.endProgress();
    session.requireSilentValidation();

    printTable(console, report);
    console.line(
        fmt::format("\n{}; {}, {} frames, {}x{}, sharp at {} through {}, {} cameras, {}, {} threads; "
                    "commit {}",
                    describe(session.device()), options.scene, options.frames, options.width, options.height,
                    options.lens.distance, options.lens.aperture, options.cameras, arguments.depth,
                    options.threads, host::buildInfo().commit));
    nlohmann::ordered_json settings = settingsOf(options);
    settings.update({{"mapping", nameOf(options.mapping)},
                     {"split", arguments.split.empty() ? "circles" : nameOf(options.split)},
                     {"distance", options.lens.distance},
                     {"aperture", options.lens.aperture},
                     {"cameras", options.cameras}});
    auto document = host::makeDocument("focus", session.documentDevice(), std::move(settings));
    for (const auto& result : report.results) {
        auto& row = document["results"].emplace_back(toJson(result));
        keepPicture(arguments.common, "picture", result.mode + ".png", result.picture, row);
    }
    for (const auto& cascade : report.cascades) {
        document["cascades"].push_back(toJson(cascade));
    }
    writeJson(arguments.common.output, document);
}

} // namespace

void addFocus(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "focus", "What depth of field by per-cascade resolution saves and shows (thesis chapter 3)");
    auto arguments = std::make_shared<FocusArguments>();
    experiments::FocusOptions& options = arguments->options;
    addComparison(*command, options, arguments->common);
    command->add_option("--distance", options.lens.distance, "View distance that is sharp")
        ->capture_default_str();
    command->add_option("--aperture", options.lens.aperture, "Diameter of the lens, scene units")
        ->capture_default_str();
    command->add_option("--cameras", options.cameras, "Cameras on the lens of the reference")
        ->check(CLI::Range(1u, 4096u))
        ->capture_default_str();
    command->add_option("--depth", arguments->depth, "Depth mapping")->capture_default_str();
    command->add_option("--split", arguments->split,
                        "How cascades are cut; where circles of confusion double unless given");
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
