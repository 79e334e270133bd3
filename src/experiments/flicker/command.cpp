#include <cli/command.h>
#include <cli/commands.h>
#include <cli/picture_folder.h>
#include <experiments/flicker/flicker.h>
#include <experiments/flicker/output.h>
#include <experiments/flicker/pairs.h>
#include <experiments/rivals/needs_command.h>
#include <experiments/rivals/row_columns.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <options/drawing_options.h>
#include <options/parsed_option.h>
#include <output/wrong_pixels_columns.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cdr::cli {

namespace {

struct FlickerArguments {
    experiments::FlickerOptions options;
    std::optional<depth::DepthFormat> format; ///< else every technique's own
    bool moved = false;
    bool fittedRange = false;
    std::optional<std::filesystem::path> videos;
    std::optional<std::filesystem::path> tga;
    std::filesystem::path state;
};

output::Columns<experiments::FlickerResult> flickerColumns() {
    using Result = experiments::FlickerResult;
    return output::joined<Result>(
        {{{.key = "scene", .value = &Result::scene},
          {.key = "technique", .value = &Result::technique, .heading = "technique"},
          experiments::rivalColumn(&Result::isRival),
          experiments::formatColumn(&Result::format),
          {.key = "frames", .value = &Result::frames}},
         output::columnsOf(&Result::wrong,
                           output::wrongPixelsColumns(
                               {.pixels = "inner pixels", .wrong = "wrong", .share = "wrong share"})),
         {{.key = "flips",
           .value = [](const Result& result) { return result.flips.flips; },
           .heading = "flips"},
          {.key = "compared", .value = [](const Result& result) { return result.flips.compared; }},
          {.key = "flips_per_thousand",
           .value = [](const Result& result) { return result.flips.perThousand(); },
           .heading = "flips / 1000"},
          {.key = "mean_flip",
           .value =
               [](const Result& result) {
                   return result.isRival() ? output::Json(nullptr) : output::Json(result.meanFlip());
               },
           .heading = "mean FLIP",
           .format = {.missing = "-"}},
          {.key = "flip_frames", .value = &Result::flipFrames},
          {.key = "duplication", .value = &Result::duplication},
          {.key = "cascades", .value = &Result::cascades, .heading = "cascades"}}});
}

output::Columns<experiments::FlickerPair> pairColumns() {
    using Pair = experiments::FlickerPair;
    const auto sideName = [](const Pair& pair, experiments::Side side) {
        return side == experiments::Side::left ? pair.left : pair.right;
    };
    return {
        {.key = "left", .value = &Pair::left, .heading = "left"},
        {.key = "right", .value = &Pair::right, .heading = "right"},
        {.key = "left_flips",
         .value = [](const Pair& pair) { return pair.flipsLeft.flips; },
         .heading = "flips left"},
        {.key = "right_flips",
         .value = [](const Pair& pair) { return pair.flipsRight.flips; },
         .heading = "flips right"},
        {.key = "observer",
         .value =
             [sideName](const Pair& pair) {
                 return pair.observer ? output::Json(sideName(pair, *pair.observer)) : output::Json(nullptr);
             },
         .heading = "observer takes",
         .text =
             [sideName](const Pair& pair) {
                 return pair.observer ? sideName(pair, *pair.observer) : pair.couldJudge() ? "neither" : "";
             }},
        {.key = "humans_left",
         .value = [](const Pair& pair) { return pair.humans.left; },
         .heading = "twelve people",
         .text =
             [](const Pair& pair) { return fmt::format("{} : {}", pair.humans.left, pair.humans.right); }},
        {.key = "humans_right", .value = [](const Pair& pair) { return pair.humans.right; }},
        {.key = "humans",
         .value = [sideName](const Pair& pair) { return sideName(pair, pair.humansChoice()); }},
        {.key = "agree",
         .value =
             [](const Pair& pair) {
                 return pair.couldJudge() ? output::Json(pair.agree()) : output::Json(nullptr);
             },
         .heading = "agree",
         .text = [](const Pair& pair) { return !pair.couldJudge() ? ""
                                               : pair.agree()     ? "yes"
                                                                  : "no"; }},
        {.key = "chi_squared", .value = &Pair::chiSquared, .heading = "chi-squared"},
        {.key = "chi_squared_p",
         .value = [](const Pair& pair) { return measure::chiSquaredTail(pair.chiSquared()); }},
        {.key = "binomial_p", .value = &Pair::binomialP, .heading = "binomial p"}};
}

std::vector<depth::NamedTechnique> techniquesOf(const FlickerArguments& arguments) {
    std::vector<depth::NamedTechnique> techniques = arguments.options.techniques;
    if (arguments.moved) {
        const auto moved = experiments::movedBoundaries();
        techniques.insert(techniques.end(), moved.begin(), moved.end());
    }
    if (arguments.fittedRange) {
        techniques.push_back(experiments::fittedRange());
    }
    for (depth::NamedTechnique& named : techniques) {
        named.technique.format = arguments.format.value_or(named.technique.format);
    }
    return techniques;
}

std::vector<experiments::FlickerResult> measure(Command& command, const FlickerArguments& arguments) {
    const experiments::FlickerOptions& options = arguments.options;
    std::vector<std::string> names;
    for (const depth::NamedTechnique& technique : options.techniques) {
        names.push_back(technique.name);
    }
    std::optional<experiments::PairVideos> videos;
    if (arguments.videos && command.ranks().isFirst()) {
        videos.emplace(*arguments.videos, names, options.drawing.width, options.drawing.height,
                       options.frames);
    }
    auto results = experiments::runFlicker(command.device(), options, command.progress(), command.ranks());
    const auto write = [&](std::uint32_t frame, const std::vector<image::ImageRgba8>& pictures) {
        if (videos) {
            videos->add(pictures);
        }
        if (arguments.tga) {
            experiments::writeTgaFrames(*arguments.tga, names, frame, pictures);
        }
    };
    if (arguments.videos || arguments.tga) { // by ranks that keep nothing: pictures would fill a state
        experiments::showFlicker(command.device(), options, command.progress(), *command.global().ranks,
                                 write);
    }
    command.endProgress();
    if (videos) {
        videos->finish();
    }
    return results;
}

/// The files that may be written of the thesis' pairs.
std::vector<std::string> videoFiles() {
    std::vector<std::string> files;
    for (const experiments::ThesisPair& pair : experiments::kThesisPairs) {
        for (const char* kind : {"mp4", "png"}) {
            files.push_back(fmt::format("{}_{}.{}", pair.left, pair.right, kind));
        }
    }
    return files;
}

/// A folder of each technique, in one that has no files of its own.
void noteTgaFolders(CommandFiles& files, const FlickerArguments& arguments) {
    requireFolder(*arguments.tga);
    files.writesFolder("--tga", *arguments.tga, [](const std::string&) { return false; });
    for (const depth::NamedTechnique& technique : arguments.options.techniques) {
        const std::filesystem::path own = *arguments.tga / technique.name;
        requireFolder(own);
        files.writesFolder("--tga", own, [](const std::string& name) { return name.ends_with(".tga"); });
    }
}

void run(Command& command, FlickerArguments& arguments) {
    experiments::FlickerOptions& options = arguments.options;
    options.techniques = techniquesOf(arguments);
    std::error_code error; // a path that cannot be looked at is refused below
    if (std::filesystem::is_directory(arguments.state, error)) {
        arguments.state /= "flicker_state.json";
    }
    if (arguments.videos) {
        command.files().writesFolder("--videos", *arguments.videos, PictureFolder::oneOf(videoFiles()));
    }
    if (arguments.tga) {
        noteTgaFolders(command.files(), arguments);
    }
    command.keepUnits(arguments.state);
    const auto results = measure(command, arguments);
    if (!command.ranks().isFirst()) {
        return;
    }
    const auto pairs = experiments::comparePairs(results);
    const Console& console = command.console();
    const auto columns = flickerColumns();
    console.table(output::tableOf(columns, results));
    if (!pairs.empty()) {
        console.line("");
        console.table(output::tableOf(pairColumns(), pairs));
    }
    printNeeds(console, options.rivalsBeside);
    console.line(fmt::format("\n{}; {} frames of {}x{}, FLIP of one frame in {}, seed {}",
                             command.opened().text(), options.frames, options.drawing.width,
                             options.drawing.height, options.flipEvery, options.seed));

    auto document = command.makeDocument({{"width", options.drawing.width},
                                          {"height", options.drawing.height},
                                          {"frames", options.frames},
                                          {"seed", options.seed},
                                          {"snap_bits", options.drawing.snapBits},
                                          {"near_object", options.nearObject},
                                          {"flip_every", options.flipEvery}});
    document["results"] = output::jsonOf(columns, results);
    document["pairs"] = output::jsonOf(pairColumns(), pairs);
    addNeeds(document, options.rivalsBeside);
    command.writeDocument(document);
}

void addOptions(CLI::App& command, FlickerArguments& arguments) {
    experiments::FlickerOptions& options = arguments.options;
    addFrames(command, options.frames, "Frames, spread evenly over the 360 frames of one turn of the camera",
              360);
    addSize(command, options.drawing.width, options.drawing.height);
    addTechniques(command, options.techniques);
    addRivalList(command, options.rivalsBeside, "none");
    options::addDepthFormat(command, arguments.format);
    addSeed(command, options.seed);
    addSnapBits(command, options.drawing.snapBits);
    command.add_flag("--near-object", options.nearObject,
                     "Keep a tiny object beside the camera, so that the near plane must stay close to it");
    command.add_flag(
        "--moved", arguments.moved,
        "Also measure cdr with its last cascade boundary moved in front of the cubes (cdr-before) and "
        "behind them (cdr-behind)");
    command.add_flag("--fitted-range", arguments.fittedRange,
                     "Also measure standard with near and far fitted to what is visible (standard-fitted)");
    addValue(command, "--flip-every", options.flipEvery,
             "Interval of the frames for which FLIP is computed; 1 is every frame")
        ->check(CLI::Range(1u, kMaxFrames));
    addThreads(command, options.drawing.threads);
    options::addFile(command, "--state", arguments.state, std::string(kStateHelp) + ". FILE may be a folder");
    options::addFolder(command, "--videos", arguments.videos,
                       "Folder for the six videos of the thesis (needs ffmpeg)");
    options::addFolder(command, "--tga", arguments.tga, "Folder for a TGA file of each frame");
}

} // namespace

void addFlicker(CLI::App& program, const GlobalOptions& global) {
    addCommand<FlickerArguments>(
        program, global, "flicker",
        "Measure flicker under a moving camera: wrong pixels, pixels that flip, and the image difference FLIP "
        "(thesis section 6.1)",
        addOptions, run, RankUse::all);
}

} // namespace cdr::cli
