#include "projection.h"

#include <cdr/base/enum_names.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::experiments {

namespace {

constexpr double kMsPerSecond = 1e3;
constexpr double kRounding = 1e-12; ///< of a time, by which equal ones may differ
constexpr base::EnumNames<ProjectionBound, 3> kBoundNames{"bound", {"making", "taking", "frames"}};

/// One frame's costs, as single numbers.
struct Costs {
    double make = 0.0;
    double take = 0.0;
    double claim = 0.0;
    double transfer = 0.0;
};

/// By ProjectionBound, the milliseconds that a run takes at least.
std::array<double, 3> leastMs(const Costs& costs, std::size_t nodes, std::size_t frames) {
    const auto count = static_cast<double>(frames);
    const double rounds = std::ceil(count / static_cast<double>(nodes));
    const double transfer = nodes > 1 ? costs.transfer : 0.0;
    return {count * (costs.make + costs.claim + costs.take) / static_cast<double>(nodes),
            count * (costs.take + transfer), rounds * (costs.make + costs.claim)};
}

double msOf(const Costs& costs, std::size_t nodes, std::size_t frames) {
    const std::array<double, 3> least = leastMs(costs, nodes, frames);
    return *std::max_element(least.begin(), least.end());
}

Costs medianOf(const FrameCosts& costs) {
    return {.make = measure::median(costs.makeMs),
            .take = measure::median(costs.takeMs),
            .claim = costs.claimMs,
            .transfer = costs.bytes * costs.msPerByte};
}

} // namespace

Projection project(const FrameCosts& costs, std::size_t nodes, std::size_t frames, std::uint64_t seed) {
    const Costs middle = medianOf(costs);
    const std::optional<measure::Interval> make = measure::bootstrapMedian(costs.makeMs, seed);
    const std::optional<measure::Interval> take = measure::bootstrapMedian(costs.takeMs, seed);
    const auto secondsOf = [&](double makeMs, double takeMs) {
        Costs each = middle;
        each.make = makeMs;
        each.take = takeMs;
        return msOf(each, nodes, frames) / kMsPerSecond;
    };
    const std::array<double, 3> least = leastMs(middle, nodes, frames);
    const bool isUneven = least[2] > least[0];
    const bool takes = least[1] >= std::max(least[0], least[2]);
    Projection projection{.nodes = nodes,
                          .seconds = secondsOf(middle.make, middle.take),
                          .bound = takes      ? ProjectionBound::taking
                                   : isUneven ? ProjectionBound::frames
                                              : ProjectionBound::making};
    if (make && take) {
        projection.secondsInterval = {.low = secondsOf(make->low, take->low),
                                      .high = secondsOf(make->high, take->high)};
    }
    projection.efficiency =
        msOf(middle, 1, frames) / kMsPerSecond / (static_cast<double>(nodes) * projection.seconds);
    return projection;
}

std::size_t lastUsefulNodes(const FrameCosts& costs, std::size_t frames) {
    const Costs middle = medianOf(costs);
    // A node for each frame and one that takes them need least. From two nodes on, more never need longer.
    const double least = msOf(middle, frames + 1, frames);
    const auto isEnough = [&](std::size_t nodes) {
        return msOf(middle, nodes, frames) <= least * (1.0 + kRounding);
    };
    if (isEnough(1)) {
        return 1;
    }
    std::size_t slower = 1;
    std::size_t enough = frames + 1;
    while (enough - slower > 1) {
        const std::size_t between = slower + (enough - slower) / 2;
        (isEnough(between) ? enough : slower) = between;
    }
    return enough;
}

output::Columns<Projection> projectionColumns() {
    return {{.key = "nodes", .value = &Projection::nodes, .heading = "nodes"},
            {.key = "seconds", .value = &Projection::seconds, .heading = "seconds"},
            output::intervalColumn(&Projection::secondsInterval,
                                   {.key = "seconds_interval", .heading = "95 % of the costs"}),
            {.key = "efficiency", .value = &Projection::efficiency, .heading = "efficiency"},
            {.key = "bound",
             .value = [](const Projection& projection) { return kBoundNames.nameOf(projection.bound); },
             .heading = "bound by"}};
}

} // namespace cdr::experiments
