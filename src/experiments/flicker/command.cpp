#include <cdr/base/error.h>
#include <cdr/host/file.h>
#include <cli/commands.h>
#include <cli/console.h>
#include <cli/wrong_pixels_json.h>
#include <experiments/flicker/flicker.h>
#include <experiments/flicker/output.h>
#include <experiments/flicker/pairs.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>

namespace cdr::cli {

namespace {

struct FlickerArguments {
    experiments::FlickerOptions options;
    std::string size = "1280x720";
    std::vector<std::string> techniques; ///< all presets when empty
    std::string format;                  ///< every technique's own when empty
    bool moved = false;
    bool fittedRange = false;
    std::optional<std::filesystem::path> videos;
    std::optional<std::filesystem::path> tga;
    OutputOptions output;
};

nlohmann::ordered_json toJson(const experiments::FlickerResult& result) {
    nlohmann::ordered_json row{{"scene", result.scene},
                               {"technique", result.technique},
                               {"format", result.format},
                               {"frames", result.frames}};
    addWrongPixels(row, result.wrong);
    row.update({{"flips", result.flips.flips},
                {"compared", result.flips.compared},
                {"flips_per_thousand", result.flips.perThousand()},
                {"mean_flip", result.meanFlip()},
                {"flip_frames", result.flipFrames},
                {"duplication", result.duplication()},
                {"cascades", result.cascades}});
    return row;
}

nlohmann::ordered_json toJson(const experiments::FlickerPair& pair) {
    const auto sideName = [&](experiments::Side side) {
        return side == experiments::Side::left ? pair.left : pair.right;
    };
    return {{"left", pair.left},
            {"right", pair.right},
            {"left_flips", pair.flipsLeft.flips},
            {"right_flips", pair.flipsRight.flips},
            {"observer", pair.observer ? nlohmann::ordered_json(sideName(*pair.observer))
                                       : nlohmann::ordered_json(nullptr)},
            {"humans_left", pair.humans.left},
            {"humans_right", pair.humans.right},
            {"humans", sideName(pair.humansChoice())},
            {"agree", pair.agree()},
            {"chi_squared", pair.chiSquared()},
            {"chi_squared_p", measure::chiSquaredTail(pair.chiSquared())},
            {"binomial_p", pair.binomialP()}};
}

void printTables(const Console& console, const std::vector<experiments::FlickerResult>& results,
                 const std::vector<experiments::FlickerPair>& pairs) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& result : results) {
        rows.push_back({result.technique, result.format, std::to_string(result.wrong.pixels),
                        std::to_string(result.wrong.wrong),
                        fmt::format("{:.5f} %", 100.0 * result.wrong.fraction()),
                        std::to_string(result.flips.flips), fmt::format("{:.4f}", result.flips.perThousand()),
                        fmt::format("{:.6f}", result.meanFlip()), std::to_string(result.cascades)});
    }
    console.table({"technique", "format", "inner pixels", "wrong", "wrong share", "flips", "flips / 1000",
                   "mean FLIP", "cascades"},
                  rows);
    if (pairs.empty()) {
        return;
    }
    rows.clear();
    for (const auto& pair : pairs) {
        const bool left = pair.observer == experiments::Side::left;
        rows.push_back({pair.left, pair.right, std::to_string(pair.flipsLeft.flips),
                        std::to_string(pair.flipsRight.flips),
                        pair.observer ? (left ? pair.left : pair.right) : "neither",
                        fmt::format("{} : {}", pair.humans.left, pair.humans.right),
                        pair.agree() ? "yes" : "no", fmt::format("{:.3f}", pair.chiSquared()),
                        fmt::format("{:.5f}", pair.binomialP())});
    }
    console.line("");
    console.table({"left", "right", "flips left", "flips right", "observer takes", "twelve people", "agree",
                   "chi-squared", "binomial p"},
                  rows);
}

std::vector<depth::NamedTechnique> techniquesOf(const FlickerArguments& arguments) {
    std::vector<depth::NamedTechnique> techniques;
    for (const std::string& name : arguments.techniques) {
        techniques.push_back(depth::namedTechnique(name));
    }
    if (techniques.empty()) {
        techniques.assign(depth::presets().begin(), depth::presets().end());
    }
    if (arguments.moved) {
        const auto moved = experiments::movedBoundaries();
        techniques.insert(techniques.end(), moved.begin(), moved.end());
    }
    if (arguments.fittedRange) {
        techniques.push_back(experiments::fittedRange());
    }
    for (depth::NamedTechnique& named : techniques) {
        named.technique.format =
            arguments.format.empty() ? named.technique.format : depth::parseDepthFormat(arguments.format);
    }
    return techniques;
}

std::vector<experiments::FlickerResult> measure(const Session& session, const Console& console,
                                                const FlickerArguments& arguments) {
    const experiments::FlickerOptions& options = arguments.options;
    std::vector<std::string> names;
    for (const depth::NamedTechnique& technique : options.techniques) {
        names.push_back(technique.name);
    }
    std::optional<experiments::PairVideos> videos;
    if (arguments.videos) {
        videos.emplace(*arguments.videos, names, options.width, options.height, options.frames);
    }
    experiments::FlickerHooks hooks;
    hooks.progress = [&](std::size_t done, std::size_t all, const std::string& what) {
        console.progress(done, all, what);
    };
    if (videos || arguments.tga) {
        hooks.pictures = [&](std::uint32_t frame, const std::vector<image::ImageRgba8>& pictures) {
            if (videos) {
                videos->add(pictures);
            }
            if (arguments.tga) {
                experiments::writeTgaFrames(*arguments.tga, names, frame, pictures);
            }
        };
    }
    auto results = experiments::runFlicker(session.device(), options, hooks);
    session.requireSilentValidation();
    if (videos) {
        videos->finish();
    }
    console.endProgress();
    return results;
}

void run(const GlobalOptions& global, FlickerArguments& arguments) {
    const PictureSize size = parseSize(arguments.size);
    experiments::FlickerOptions& options = arguments.options;
    options.width = size.width;
    options.height = size.height;
    options.techniques = techniquesOf(arguments);
    if (options.state && std::filesystem::is_directory(*options.state)) {
        *options.state /= "flicker_state.json";
    }
    requireJsonWritable(arguments.output);
    const Session session(global);
    const Console console(global, arguments.output);
    const auto results = measure(session, console, arguments);
    const auto pairs = experiments::comparePairs(results);
    printTables(console, results, pairs);
    console.line(fmt::format("\n{}; {} frames of {}x{}, FLIP of every {}., seed {}",
                             describe(session.device()), options.frames, size.width, size.height,
                             options.flipEvery, options.seed));

    auto document = host::makeDocument("flicker", session.documentDevice(),
                                       {{"width", size.width},
                                        {"height", size.height},
                                        {"frames", options.frames},
                                        {"seed", options.seed},
                                        {"near_object", options.nearObject},
                                        {"flip_every", options.flipEvery}});
    for (const auto& result : results) {
        document["results"].push_back(toJson(result));
    }
    auto& section = host::addSection(document, "pairs");
    for (const auto& pair : pairs) {
        section.push_back(toJson(pair));
    }
    writeJson(arguments.output, document);
}

} // namespace

void addFlicker(CLI::App& program, const GlobalOptions& global) {
    CLI::App* command = program.add_subcommand(
        "flicker", "Wrong pixels, flips and FLIP over the 2AFC experiment's frames (thesis section 6.1)");
    auto arguments = std::make_shared<FlickerArguments>();
    experiments::FlickerOptions& options = arguments->options;
    command->add_option("--frames", options.frames, "Frames, spread evenly over one turn of the camera")
        ->check(CLI::Range(1u, kMaxFrames))
        ->capture_default_str();
    command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command
        ->add_option("--techniques", arguments->techniques, "Techniques, a comma between them; all presets")
        ->delimiter(',');
    command->add_option("--format", arguments->format, "Depth format of all: d16, d24 or d32f");
    command->add_option("--seed", options.seed, "Seed of the field")->capture_default_str();
    command->add_flag("--near-object", options.nearObject,
                      "A tiny object stays beside the camera, so fitting near and far does not help");
    command->add_flag("--moved", arguments->moved,
                      "Adds cdr with its last boundary moved off the field: cdr-before and cdr-behind");
    command->add_flag("--fitted-range", arguments->fittedRange,
                      "Adds standard with near and far fitted to what is visible: standard-fitted");
    command->add_option("--flip-every", options.flipEvery, "Take FLIP of every so-many-th frame")
        ->check(CLI::Range(1u, kMaxFrames))
        ->capture_default_str();
    command->add_option("--threads", options.threads, "Threads that cull, bin, record and measure")
        ->capture_default_str();
    command->add_option("--state", options.state,
                        "File or folder where the run is kept, to go on from when it is interrupted");
    command->add_option("--videos", arguments->videos, "Folder for the thesis' six videos (needs ffmpeg)");
    command->add_option("--tga", arguments->tga, "Folder for every frame as TGA");
    addJson(*command, arguments->output);
    command->callback([&global, arguments] { run(global, *arguments); });
}

} // namespace cdr::cli
