#include <cli/comparison.h>
#include <experiments/detail/detail.h>

#include <fmt/format.h>

namespace cdr::cli {

namespace {

struct DetailArguments {
    experiments::DetailOptions options;
    std::string depth = "standard";
    std::string split = "count:5";
    ComparisonArguments common;
};

nlohmann::ordered_json toJson(const experiments::DetailResult& result) {
    return {{"mode", result.mode},
            {"frame_ms", result.frameMs},
            {"record_ms", result.recordMs},
            {"execute_ms", result.executeMs},
            {"execute_speedup", result.speedup},
            {"ci95", {result.speedup95.low, result.speedup95.high}},
            {"triangles", result.triangles},
            {"flip", result.flip},
            {"largest_flip", result.largestFlip},
            {"pixels", result.pixels},
            {"other_ids", result.otherIds},
            {"cracks", result.cracks}};
}

void printTable(const Console& console, const experiments::DetailReport& report) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& result : report.results) {
        const double share = static_cast<double>(result.otherIds) / static_cast<double>(result.pixels);
        rows.push_back({result.mode, fmt::format("{:.0f}", result.triangles),
                        fmt::format("{:.2f}", result.frameMs), fmt::format("{:.2f}", result.executeMs),
                        fmt::format("{:.2f}", result.speedup),
                        fmt::format("{:.2f} to {:.2f}", result.speedup95.low, result.speedup95.high),
                        fmt::format("{:.5f}", result.flip), fmt::format("{:.4f} %", 100.0 * share),
                        std::to_string(result.cracks)});
    }
    console.table({"detail", "triangles", "frame ms", "execute ms", "speed-up", "95 % interval", "FLIP",
                   "other objects", "cracks"},
                  rows);
}

void run(const GlobalOptions& global, DetailArguments& arguments) {
    experiments::DetailOptions& options = arguments.options;
    options.technique = depth::Technique{depth::parseMapping(arguments.depth),
                                         depth::parseSplit(arguments.split), depth::DepthFormat::d32f};
    visibility::requireUsable(
        visibility::Detail{.mode = visibility::DetailMode::perObject, .pixels = options.pixels});
    begin(arguments.common, options);
    const Session session(global);
    const Console console(global, arguments.common.output);
    const experiments::DetailReport report =
        experiments::runDetail(session.device(), options, [&](std::size_t done, std::size_t all) {
            console.progress(done, all, "frames of every level of detail");
        });
    console.endProgress();
    session.requireSilentValidation();

    printTable(console, report);
    console.line(fmt::format("\n{}; {} of {} triangles, {} levels made in {:.0f} ms; {} frames, {}x{}, {} "
                             "pixels of error, {} {}, {} threads; commit {}",
                             describe(session.device()), options.scene, report.sceneTriangles,
                             report.meshLevels, report.makeMs, options.frames, options.width, options.height,
                             options.pixels, arguments.depth, arguments.split, options.threads,
                             host::buildInfo().commit));
    nlohmann::ordered_json settings = settingsOf(options);
    settings.update({{"mapping", nameOf(options.technique.mapping)},
                     {"split", nameOf(options.technique.split)},
                     {"error_pixels", options.pixels}});
    auto document = host::makeDocument("detail", session.documentDevice(), std::move(settings));
    for (const auto& result : report.results) {
        auto& row = document["results"].emplace_back(toJson(result));
        keepPicture(arguments.common, "picture", result.mode + ".png", result.picture, row);
        keepPicture(arguments.common, "cracks_picture", result.mode + "_cracks.png", result.cracked, row);
    }
    document["scene_triangles"] = report.sceneTriangles;
    document["levels"] = report.meshLevels;
    document["make_levels_ms"] = report.makeMs;
    writeJson(arguments.common.output, document);
}

} // namespace

void addDetail(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "detail",
        "What levels of detail save and change, chosen by object and by cascade (thesis chapter 3)");
    auto arguments = std::make_shared<DetailArguments>();
    experiments::DetailOptions& options = arguments->options;
    addComparison(*command, options, arguments->common);
    command->add_option("--pixels", options.pixels, "Largest error of a level on screen, in pixels")
        ->capture_default_str();
    command->add_option("--depth", arguments->depth, "Depth mapping")->capture_default_str();
    command->add_option("--split", arguments->split, "How cascades are cut")->capture_default_str();
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
