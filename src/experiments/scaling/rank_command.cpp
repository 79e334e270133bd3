#include "rank_command.h"

#include <cdr/base/format_error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::cli {

namespace {

constexpr std::uint32_t kMaxHeight = 16'384;
constexpr std::size_t kMaxProjected = 1'000'000;

void requireSameImages(const std::vector<experiments::RankPoint>& points) {
    const auto differs = std::ranges::find_if(points, [](const auto& point) { return !point.sameImage; });
    if (differs != points.end()) {
        throw base::runError("{} cascades: the image of {} ranks differs from that of one", differs->cascades,
                             differs->ranks);
    }
}

/// Behind a time that was predicted, in brackets.
std::string intervalText(const std::optional<measure::Interval>& interval) {
    return interval ? fmt::format("{:.3g} to {:.3g}", interval->low, interval->high)
                    : fmt::format("a 95 % interval needs {} frames", measure::kMinIntervalSamples);
}

double sendMs(const experiments::FrameCosts& costs) {
    return costs.msPerByte * costs.bytes;
}

std::string costsText(const experiments::FrameCosts& costs, std::size_t ranks) {
    const std::string made =
        fmt::format("A frame takes {:.4g} ms to make, and the first rank {:.4g} ms to take its {} bytes.",
                    measure::median(costs.makeMs), measure::median(costs.takeMs), costs.bytes);
    return made + (ranks > 1
                       ? fmt::format(" They take {:.3g} ms to send. Claiming a frame takes {:.3g} ms.",
                                     sendMs(costs), costs.claimMs)
                       : " In one process no frame is claimed or sent, so the prediction leaves both out.");
}

} // namespace

void addRankSweepOptions(CLI::App& command, RankSweepArguments& arguments) {
    command.add_flag("--ranks", arguments.isAsked,
                     "Measure MPI ranks that divide the cascades of a frame, instead of threads");
    addList(command, "--heights", arguments.heights,
            "Heights of the 16:9 pictures to measure in pixels, separated by commas");
    const CLI::Range projected(std::size_t{1}, kMaxProjected);
    command
        .add_option(
            "--project", arguments.nodes,
            "Predict the time of a run on up to this many nodes, from measured frames of --size and of one --draws")
        ->check(projected);
    addValue(command, "--frames", arguments.frames, "Frames of the predicted run")->check(projected);
}

void runRankSweep(Command& command, experiments::RankSweepOptions options,
                  const RankSweepArguments& arguments) {
    options.sizes.clear();
    for (const std::uint32_t height : arguments.heights) {
        if (height < 1 || height > kMaxHeight) {
            throw base::inputError("--heights must be 1 to {}, not {}", kMaxHeight, height);
        }
        options.sizes.push_back({.width = (height * 16 + 8) / 9, .height = height});
    }
    requireUsable(options);
    const std::vector<experiments::RankPoint> points =
        experiments::runRankSweep(command.device(), options, command.ranks(), command.progress());
    command.endProgress();
    const auto columns = experiments::rankPointColumns();
    const ranks::Place& place = command.ranks().place();
    command.console().table(output::tableOf(columns, points));
    command.console().line(
        fmt::format("\n{}; medians of {} frames of {} cubes, seed {}; {} of {} ranks on this machine",
                    command.opened().text(), options.repeats, options.cubes, options.seed, place.countOnNode,
                    place.count));
    auto document = command.makeDocument({{"ranks", place.count},
                                          {"ranks_on_node", place.countOnNode},
                                          {"cpu_choice", ranks::nameOf(place.cpus.choice)},
                                          {"cubes", options.cubes},
                                          {"repeats", options.repeats},
                                          {"seed", options.seed}});
    document["results"] = output::jsonOf(columns, points);
    command.writeDocument(document);
    requireSameImages(points);
}

void runProjection(Command& command, const experiments::RankSweepOptions& options,
                   const RankSweepArguments& arguments) {
    const auto [costs, run] = experiments::measureFrameCosts(command.device(), options, command.ranks());
    command.endProgress();
    if (!command.ranks().isFirst()) {
        return;
    }
    std::vector<experiments::Projection> projections;
    for (const std::size_t nodes : experiments::rankSteps(arguments.nodes)) {
        projections.push_back(experiments::project(costs, nodes, arguments.frames, options.seed));
    }
    const std::size_t ranks = command.ranks().place().count;
    const experiments::Projection here = experiments::project(costs, ranks, run.frames, options.seed);
    const std::size_t useful = experiments::lastUsefulNodes(costs, arguments.frames);
    const auto columns = experiments::projectionColumns();
    const Console& console = command.console();
    console.table(output::tableOf(columns, projections));
    console.line(fmt::format("\n{} More than {} nodes do not help.", costsText(costs, ranks), useful));
    console.line(fmt::format("Check: {} frames by {} rank{} took {:.3g} s. The prediction is {:.3g} s ({}).",
                             run.frames, ranks, ranks == 1 ? "" : "s", run.seconds, here.seconds,
                             intervalText(here.secondsInterval)));
    console.line(command.opened().text());
    auto document = command.makeDocument({{"ranks", ranks},
                                          {"ranks_on_node", command.ranks().place().countOnNode},
                                          {"cpu_choice", ranks::nameOf(command.ranks().place().cpus.choice)},
                                          {"width", options.sizes.front().width},
                                          {"height", options.sizes.front().height},
                                          {"cubes", options.cubes},
                                          {"repeats", options.repeats},
                                          {"seed", options.seed},
                                          {"frames", arguments.frames}});
    document["results"] = output::jsonOf(columns, projections);
    document["costs"] = {{"make_ms", measure::median(costs.makeMs)},
                         {"take_ms", measure::median(costs.takeMs)},
                         {"bytes", costs.bytes},
                         {"claim_ms", ranks > 1 ? output::Json(costs.claimMs) : output::Json(nullptr)},
                         {"send_ms", ranks > 1 ? output::Json(sendMs(costs)) : output::Json(nullptr)}};
    document["useful_nodes"] = useful;
    document["check"] = {{"frames", run.frames},
                         {"seconds", run.seconds},
                         {"predicted", here.seconds},
                         {"predicted_interval", output::jsonOf(here.secondsInterval)}};
    command.writeDocument(document);
}

} // namespace cdr::cli
