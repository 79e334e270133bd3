#include "commands.h"
#include "console.h"

#include <cdr/base/file.h>
#include <cdr/base/worker_pool.h>
#include <cdr/image/codec.h>
#include <cdr/render/effects.h>

#include <experiments/effects.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace cdr::cli {

namespace {

struct EffectsArguments {
    experiments::EffectsOptions options;
    std::string size = "1280x720";
    std::filesystem::path folder; ///< no pictures when empty
    OutputOptions output;
};

std::string pictureOf(const experiments::EffectsResult& result) {
    return result.mode + ".png";
}

nlohmann::ordered_json toJson(const experiments::EffectsResult& result, bool hasPictures) {
    nlohmann::ordered_json row{{"mode", result.mode},
                               {"execute_ms", result.executeMs},
                               {"execute_ratio", result.ratio},
                               {"ci95", {result.ratio95.low, result.ratio95.high}},
                               {"least_alike", result.leastAlike},
                               {"differing", result.differing}};
    if (hasPictures) {
        row["picture"] = pictureOf(result);
    }
    return row;
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
    const PictureSize size = parseSize(arguments.size);
    options.width = size.width;
    options.height = size.height;
    requireUsable(render::Effects{.occlusion = {.radius = options.occlusionRadius},
                                  .fog = {.visibility = options.visibility}});
    requireJsonWritable(arguments.output);
    if (!arguments.folder.empty()) {
        base::makeFolder(arguments.folder);
    }
    const Session session(global);
    const Console console(global, arguments.output);
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
    auto document = base::makeDocument("effects", session.documentDevice(),
                                       {{"scene", options.scene},
                                        {"width", options.width},
                                        {"height", options.height},
                                        {"frames", options.frames},
                                        {"threads", options.threads},
                                        {"seed", options.seed},
                                        {"occlusion_radius", options.occlusionRadius},
                                        {"visibility", options.visibility}});
    for (const auto& result : report.results) {
        document["results"].push_back(toJson(result, !arguments.folder.empty()));
        if (!arguments.folder.empty()) {
            image::writeImage(arguments.folder / pictureOf(result), result.picture);
        }
    }
    document["lost_per_layer"] = report.lostPerLayer;
    writeJson(arguments.output, document);
}

} // namespace

void addEffects(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "effects", "What screen-space effects cost, and whether they look alike under every technique");
    auto arguments = std::make_shared<EffectsArguments>();
    experiments::EffectsOptions& options = arguments->options;
    command->add_option("scene", options.scene, "alley, or any scene that render takes")
        ->capture_default_str();
    command->add_option("--frames", options.frames, "Measured frames of every mode")
        ->check(CLI::Range(1u, kMaxFrames))
        ->capture_default_str();
    command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--occlusion", options.occlusionRadius, "Radius of ambient occlusion, scene units")
        ->capture_default_str();
    command->add_option("--fog", options.visibility, "Visibility in fog, scene units")->capture_default_str();
    command->add_option("--threads", options.threads, "Threads that cull, bin and record")
        ->check(CLI::Range(std::size_t{1}, base::WorkerPool::kMaxThreads))
        ->capture_default_str();
    command->add_option("--seed", options.seed, "Seed of the scene, the orders and the bootstrap")
        ->capture_default_str();
    command->add_option("--out", arguments->folder, "Folder for a picture of each effect");
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
