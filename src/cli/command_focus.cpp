#include "commands.h"
#include "console.h"

#include <cdr/base/file.h>
#include <cdr/base/worker_pool.h>
#include <cdr/image/codec.h>

#include <experiments/focus.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace cdr::cli {

namespace {

struct FocusArguments {
    experiments::FocusOptions options;
    std::string size = "1280x720";
    std::string depth = "reversed";
    std::string split;
    std::filesystem::path folder; ///< no pictures when empty
    OutputOptions output;
};

std::string pictureOf(const experiments::FocusResult& result) {
    return result.mode + ".png";
}

nlohmann::ordered_json toJson(const experiments::FocusResult& result, bool hasPictures) {
    nlohmann::ordered_json row{{"mode", result.mode},
                               {"frame_ms", result.frameMs},
                               {"execute_ms", result.executeMs},
                               {"execute_speedup", result.speedup},
                               {"ci95", {result.speedup95.low, result.speedup95.high}},
                               {"pixels", result.pixels},
                               {"flip", result.flip},
                               {"rmse", result.rmse}};
    if (hasPictures) {
        row["picture"] = pictureOf(result);
    }
    return row;
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
    const PictureSize size = parseSize(arguments.size);
    options.width = size.width;
    options.height = size.height;
    options.mapping = depth::parseMapping(arguments.depth);
    if (!arguments.split.empty()) {
        options.split = depth::parseSplit(arguments.split);
    }
    requireUsable(options.lens);
    requireJsonWritable(arguments.output);
    if (!arguments.folder.empty()) {
        base::makeFolder(arguments.folder);
    }
    const Session session(global);
    const Console console(global, arguments.output);
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
                    options.threads, base::buildInfo().commit));
    auto document =
        base::makeDocument("focus", session.documentDevice(),
                           {{"scene", options.scene},
                            {"width", options.width},
                            {"height", options.height},
                            {"frames", options.frames},
                            {"threads", options.threads},
                            {"seed", options.seed},
                            {"mapping", nameOf(options.mapping)},
                            {"split", arguments.split.empty() ? "circles" : nameOf(options.split)},
                            {"distance", options.lens.distance},
                            {"aperture", options.lens.aperture},
                            {"cameras", options.cameras}});
    for (const auto& result : report.results) {
        document["results"].push_back(toJson(result, !arguments.folder.empty()));
        if (!arguments.folder.empty()) {
            image::writeImage(arguments.folder / pictureOf(result), result.picture);
        }
    }
    for (const auto& cascade : report.cascades) {
        document["cascades"].push_back(toJson(cascade));
    }
    writeJson(arguments.output, document);
}

} // namespace

void addFocus(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "focus", "What depth of field by per-cascade resolution saves and shows (thesis chapter 3)");
    auto arguments = std::make_shared<FocusArguments>();
    experiments::FocusOptions& options = arguments->options;
    command->add_option("scene", options.scene, "alley, or any scene that render takes")
        ->capture_default_str();
    command->add_option("--frames", options.frames, "Measured frames of every mode")
        ->check(CLI::Range(1u, kMaxFrames))
        ->capture_default_str();
    command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
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
    command->add_option("--threads", options.threads, "Threads that cull, bin and record")
        ->check(CLI::Range(std::size_t{1}, base::WorkerPool::kMaxThreads))
        ->capture_default_str();
    command->add_option("--seed", options.seed, "Seed of the scene, the orders and the bootstrap")
        ->capture_default_str();
    command->add_option("--out", arguments->folder, "Folder for the pictures of every lens");
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
