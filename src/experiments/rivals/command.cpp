#include <cli/command.h>
#include <cli/commands.h>
#include <experiments/rivals/rivals.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <options/help_texts.h>
#include <output/readable.h>
#include <output/wrong_pixels_columns.h>

namespace cdr::cli {

namespace {

struct RivalsArguments {
    std::vector<std::string> scenes{"afc", "mixed", "orbit"};
    experiments::RivalsOptions options;
    std::vector<depth::NamedTechnique> techniques; ///< today's
    std::vector<rivals::NamedRival> chosenRivals;
};

output::Columns<experiments::RivalScene> rivalSceneColumns() {
    using Result = experiments::RivalScene;
    return output::joined<Result>(
        {{{.key = "scene", .value = &Result::scene, .heading = "scene"},
          {.key = "technique", .value = &Result::contender, .heading = "technique"},
          {.key = "rival", .value = &Result::isRival},
          {.key = "frames", .value = &Result::frames},
          {.key = "cascades", .value = &Result::cascades}},
         output::columnsOf(&Result::wrong, output::wrongPixelsColumns({.share = "wrong share"})),
         {{.key = "flips", .value = [](const Result& result) { return result.flips.flips; }},
          {.key = "compared", .value = [](const Result& result) { return result.flips.compared; }},
          {.key = "flips_per_thousand",
           .value = [](const Result& result) { return result.flips.perThousand(); },
           .heading = "flips / 1000"},
          {.key = "frame_ms", .value = &Result::frameMs, .heading = "frame ms"},
          {.key = "execute_ms", .value = &Result::executeMs},
          {.key = "frame_ratio", .value = &Result::ratio, .heading = "over anchored"},
          output::intervalColumn(&Result::ratio95)}});
}

output::Columns<experiments::RivalResolved> rivalResolvedColumns(base::LengthUnit unit) {
    using Result = experiments::RivalResolved;
    const auto textOf = [unit](std::optional<double> Result::*part, bool Result::*all,
                               std::size_t Result::*pairsSeen) {
        return [unit, part, all, pairsSeen](const Result& result) -> std::string {
            const auto text = [unit](double view) {
                return base::quantityText(view, unit, base::NumberStyle::plain);
            };
            return result.*part             ? text(*(result.*part)) + (result.*all ? " or less" : "")
                   : result.*pairsSeen == 0 ? "no pixel tells"
                                            : "none, > " + text(result.largestView);
        };
    };
    return {
        {.key = "distance", .value = &Result::distanceView, .heading = "distance", .format = {.unit = unit}},
        {.key = "technique", .value = &Result::contender, .heading = "technique"},
        {.key = "rival", .value = &Result::isRival},
        {.key = "resolved",
         .value = &Result::resolvedView,
         .heading = "resolves equal cubes",
         .text = textOf(&Result::resolvedView, &Result::resolvesAll, &Result::pairsSeen)},
        {.key = "resolved_unlike",
         .value = &Result::unlikeView,
         .heading = "unlike ones",
         .text = textOf(&Result::unlikeView, &Result::unlikeResolvesAll, &Result::unlikePairsSeen)},
        {.key = "resolved_ratio", .value = &Result::ratio, .heading = "over anchored"},
        {.key = "resolves_all", .value = &Result::resolvesAll},
        {.key = "resolves_all_unlike", .value = &Result::unlikeResolvesAll},
        {.key = "pairs_seen", .value = &Result::pairsSeen},
        {.key = "pairs_seen_unlike", .value = &Result::unlikePairsSeen},
        {.key = "smallest", .value = &Result::smallestView},
        {.key = "largest", .value = &Result::largestView}};
}

output::Columns<experiments::RivalWholeFrame> wholeFrameColumns() {
    using Result = experiments::RivalWholeFrame;
    return {{.key = "scene", .value = &Result::scene},
            {.key = "frame_ratio", .value = &Result::ratio},
            output::intervalColumn(&Result::ratio95, {.heading = ""})};
}

/// Those asked for; all that the device can draw where none are.
std::vector<experiments::NamedContender> contendersOf(const gpu::DeviceInfo& device,
                                                      const RivalsArguments& arguments) {
    const std::vector<experiments::NamedContender> all = experiments::defaultContenders(device);
    std::vector<experiments::NamedContender> chosen;
    for (const depth::NamedTechnique& named : arguments.techniques) {
        chosen.push_back({named.name, named.technique});
    }
    if (chosen.empty()) {
        std::copy_if(all.begin(), all.end(), std::back_inserter(chosen),
                     [](const experiments::NamedContender& named) { return !named.isRival(); });
    }
    for (const rivals::NamedRival& named : arguments.chosenRivals) {
        chosen.push_back({named.name, named.rival});
    }
    if (arguments.chosenRivals.empty()) {
        std::copy_if(all.begin(), all.end(), std::back_inserter(chosen),
                     [](const experiments::NamedContender& named) { return named.isRival(); });
    }
    return chosen;
}

/// A line for each rival that is left out because the device lacks what it needs; none where rivals were asked for.
std::vector<std::string> leftOutBy(const gpu::DeviceInfo& device, const RivalsArguments& arguments) {
    std::vector<std::string> lines;
    for (const rivals::NamedRival& named : rivals::namedRivals()) {
        const auto missing = rivals::missingFeatures(device, named.rival);
        if (arguments.chosenRivals.empty() && !missing.empty()) {
            lines.push_back(
                fmt::format("left out: {}, since the device lacks {}", named.name, fmt::join(missing, ", ")));
        }
    }
    return lines;
}

void run(Command& command, RivalsArguments& arguments) {
    experiments::RivalsOptions& options = arguments.options;
    options.contenders = contendersOf(command.device().info(), arguments);
    std::vector<experiments::NamedScene> scenes;
    for (const std::string& name : arguments.scenes) {
        scenes.push_back({name, command.openScene(name, options.seed)});
    }
    const experiments::RivalsReport report =
        experiments::runRivals(command.device(), scenes, options, command.progress());
    command.endProgress();

    const Console& console = command.console();
    const auto sceneColumns = rivalSceneColumns();
    const auto resolvedColumns = rivalResolvedColumns(command.unit());
    const auto needsColumns = experiments::rivalNeedsColumns();
    if (!report.scenes.empty()) {
        console.table(output::tableOf(sceneColumns, report.scenes));
        console.line("");
    }
    if (!report.resolved.empty()) {
        console.table(output::tableOf(resolvedColumns, report.resolved));
        console.line("");
    }
    console.table(output::tableOf(needsColumns, report.needs));
    console.line("");
    for (const std::string& line : leftOutBy(command.device().info(), arguments)) {
        console.line(line);
    }
    for (const experiments::RivalWholeFrame& whole : report.wholeFrames) {
        console.line(fmt::format(
            "{}: a whole frame of {}, with shading, takes {} times as long as its ids and distances",
            whole.scene, options.baseline, output::Readable{whole.ratio}));
    }
    console.line(fmt::format("{}; ids and distances alone, {} frames of {}x{}, seed {}, {} threads",
                             command.opened().text(), options.frames, options.width, options.height,
                             options.seed, options.threads));

    auto document = command.makeDocument({{"width", options.width},
                                          {"height", options.height},
                                          {"frames", options.frames},
                                          {"threads", options.threads},
                                          {"seed", options.seed},
                                          {"baseline", options.baseline}});
    document["results"] = output::jsonOf(sceneColumns, report.scenes);
    document["resolved"] = output::jsonOf(resolvedColumns, report.resolved);
    document["needs"] = output::jsonOf(needsColumns, report.needs);
    document["whole_frames"] = output::jsonOf(wholeFrameColumns(), report.wholeFrames);
    command.writeDocument(document);
}

void addOptions(CLI::App& command, RivalsArguments& arguments) {
    experiments::RivalsOptions& options = arguments.options;
    addValue(command, "SCENE", arguments.scenes, "Scenes, separated by spaces: " + options::sceneHelp());
    addDistances(command, options.distancesView);
    addTechniques(command, arguments.techniques);
    addRivalList(command, arguments.chosenRivals, "all that the device can draw");
    addFrames(command, options.frames,
              "Frames of each scene, spread evenly over its camera path, and timed frames of each technique");
    addSize(command, options.width, options.height);
    addThreads(command, options.threads);
    addSeed(command, options.seed);
}

} // namespace

void addRivals(CLI::App& program, const GlobalOptions& global) {
    addCommand<RivalsArguments>(
        program, global, "rivals",
        "Compare rivals (64-bit depth by atomics, pairs of floats, anchors of objects) with today's techniques: wrong "
        "pixels, resolution, time",
        addOptions, run);
}

} // namespace cdr::cli
