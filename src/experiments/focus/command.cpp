#include <cli/comparison.h>
#include <experiments/columns.h>
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

experiments::Columns<experiments::FocusResult> focusColumns() {
    using Result = experiments::FocusResult;
    const auto megapixels = [](const Result& result) {
        return fmt::format("{:.2f}", static_cast<double>(result.pixels) / 1e6);
    };
    return {
        {.key = "mode", .value = &Result::mode, .heading = "lens"},
        {.key = "frame_ms", .value = &Result::frameMs, .heading = "frame ms", .format = {"{:.2f}"}},
        {.key = "execute_ms", .value = &Result::executeMs, .heading = "execute ms", .format = {"{:.2f}"}},
        {.key = "execute_speedup", .value = &Result::speedup, .heading = "speed-up", .format = {"{:.3f}"}},
        {.key = "ci95",
         .value = [](const Result& result) { return experiments::jsonOf(result.speedup95); },
         .heading = "95 % interval",
         .format = {"{:.3f} to {:.3f}"}},
        {.key = "pixels",
         .value = &Result::pixels,
         .heading = "megapixels",
         .text = megapixels,
         .before = "frame ms"},
        {.key = "flip", .value = &Result::flip, .heading = "FLIP", .format = {"{:.4f}"}},
        {.key = "rmse", .value = &Result::rmse, .heading = "RMSE", .format = {"{:.4f}"}}};
}

experiments::Columns<experiments::FocusCascade> cascadeColumns() {
    using Cascade = experiments::FocusCascade;
    return {{.key = "near", .value = &Cascade::nearView},
            {.key = "far", .value = &Cascade::farView},
            {.key = "scale", .value = &Cascade::scale}};
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

    const auto columns = focusColumns();
    console.table(experiments::tableOf(columns, report.results));
    for (const auto& cascade : report.cascades) {
        console.line(fmt::format("cascade from {:.4g} to {:.4g}: {} pixels a pixel", cascade.nearView,
                                 cascade.farView, cascade.scale));
    }
    console.line(
        fmt::format("\n{}; {}, {} frames, {}x{}, sharp at {} through {}, {} cameras, {}, {} threads; "
                    "commit {}",
                    describe(session.device()), options.scene, options.frames, options.width, options.height,
                    options.lens.distance, options.lens.aperture, options.cameras, arguments.depth,
                    options.threads, base::buildInfo().commit));
    nlohmann::ordered_json settings = settingsOf(options);
    settings.update({{"mapping", nameOf(options.mapping)},
                     {"split", arguments.split.empty() ? "circles" : nameOf(options.split)},
                     {"distance", options.lens.distance},
                     {"aperture", options.lens.aperture},
                     {"cameras", options.cameras}});
    auto document = base::makeDocument("focus", session.documentDevice(), std::move(settings));
    for (const auto& result : report.results) {
        auto& row = document["results"].emplace_back(experiments::jsonOf(columns, result));
        keepPicture(arguments.common, "picture", result.mode + ".png", result.picture, row);
    }
    document["cascades"] = experiments::jsonOf(cascadeColumns(), report.cascades);
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
