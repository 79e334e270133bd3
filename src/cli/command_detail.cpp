#include "commands.h"
#include "console.h"

#include <cdr/base/file.h>
#include <cdr/base/worker_pool.h>
#include <cdr/image/codec.h>

#include <experiments/detail.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace cdr::cli {

namespace {

struct DetailArguments {
    experiments::DetailOptions options;
    std::string size = "1280x720";
    std::string depth = "standard";
    std::string split = "count:5";
    std::filesystem::path folder; ///< no pictures when empty
    OutputOptions output;
};

std::string pictureOf(const experiments::DetailResult& result) {
    return result.mode + ".png";
}

std::string crackPictureOf(const experiments::DetailResult& result) {
    return result.mode + "_cracks.png";
}

nlohmann::ordered_json toJson(const experiments::DetailResult& result, bool hasPictures) {
    nlohmann::ordered_json row{{"mode", result.mode},
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
    if (hasPictures) {
        row["picture"] = pictureOf(result);
        row["cracks_picture"] = crackPictureOf(result);
    }
    return row;
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
    const PictureSize size = parseSize(arguments.size);
    options.width = size.width;
    options.height = size.height;
    options.technique = depth::makeTechnique(depth::parseMapping(arguments.depth),
                                             depth::parseSplit(arguments.split), depth::DepthFormat::d32f);
    scene::requireUsable(scene::Detail{.mode = scene::DetailMode::perObject, .pixels = options.pixels});
    requireJsonWritable(arguments.output);
    if (!arguments.folder.empty()) {
        base::makeFolder(arguments.folder);
    }
    const Session session(global);
    const Console console(global, arguments.output);
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
                             base::buildInfo().commit));
    auto document = base::makeDocument("detail", session.documentDevice(),
                                       {{"scene", options.scene},
                                        {"width", options.width},
                                        {"height", options.height},
                                        {"frames", options.frames},
                                        {"threads", options.threads},
                                        {"seed", options.seed},
                                        {"mapping", nameOf(options.technique.mapping)},
                                        {"split", nameOf(options.technique.split)},
                                        {"error_pixels", options.pixels}});
    for (const auto& result : report.results) {
        document["results"].push_back(toJson(result, !arguments.folder.empty()));
        if (!arguments.folder.empty()) {
            image::writeImage(arguments.folder / pictureOf(result), result.picture);
            image::writeImage(arguments.folder / crackPictureOf(result), result.cracked);
        }
    }
    document["scene_triangles"] = report.sceneTriangles;
    document["levels"] = report.meshLevels;
    document["make_levels_ms"] = report.makeMs;
    writeJson(arguments.output, document);
}

} // namespace

void addDetail(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "detail",
        "What levels of detail save and change, chosen by object and by cascade (thesis chapter 3)");
    auto arguments = std::make_shared<DetailArguments>();
    experiments::DetailOptions& options = arguments->options;
    command->add_option("scene", options.scene, "boulders, or any scene that render takes")
        ->capture_default_str();
    command->add_option("--frames", options.frames, "Measured frames of every mode, spread over the path")
        ->check(CLI::Range(1u, kMaxFrames))
        ->capture_default_str();
    command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--pixels", options.pixels, "Largest error of a level on screen, in pixels")
        ->capture_default_str();
    command->add_option("--depth", arguments->depth, "Depth mapping")->capture_default_str();
    command->add_option("--split", arguments->split, "How cascades are cut")->capture_default_str();
    command->add_option("--threads", options.threads, "Threads that make levels, cull, bin and record")
        ->check(CLI::Range(std::size_t{1}, base::WorkerPool::kMaxThreads))
        ->capture_default_str();
    command->add_option("--seed", options.seed, "Seed of the scene, the orders and the bootstrap")
        ->capture_default_str();
    command->add_option("--out", arguments->folder,
                        "Folder for the first frame's pictures, cracks marked red beside them");
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
