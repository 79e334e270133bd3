#include <cdr/depth/cascade_plan.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cdr::depth {

namespace {

/// Bounds every bisection, whatever the numbers are. With usual numbers their tolerances end them long
/// before.
constexpr int kMaxBisections = 200;

/// Where a cascade begins: at a view distance within an occupied interval.
struct Start {
    std::size_t interval = 0;
    double nearView = 0.0;

    bool isBeyond(const Start& other) const {
        return interval != other.interval ? interval > other.interval : nearView > other.nearView;
    }
};

/// How far one cascade may reach.
struct Reach {
    /// Intervals before this one can be covered whole.
    std::size_t whole = 0;
    /// How far into interval `whole` the cascade can go; empty when not past its beginning.
    std::optional<double> cutView;
};

/// The model, the target and what is occupied.
struct Problem {
    const StepModel& model;
    const StepTarget& target;
    std::span<const Interval> occupied;

    bool meets(double nearView, double farView) const {
        return worstStepShare(model, target, {nearView, farView}) <= 1.0;
    }
    Start start(std::size_t interval) const { return {interval, occupied[interval].nearView}; }

    Reach reach(const Start& from) const {
        std::size_t low = from.interval; // not known to be covered
        std::size_t high = occupied.size();
        while (low < high) {
            const std::size_t middle = low + (high - low) / 2;
            if (meets(from.nearView, occupied[middle].farView)) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        Reach reach{.whole = low, .cutView = std::nullopt};
        if (low < occupied.size()) {
            reach.cutView = cutWithin(from, occupied[low]);
        }
        return reach;
    }

    /// The last distance within `interval`, beyond its beginning, that a cascade from `from` may reach.
    std::optional<double> cutWithin(const Start& from, const Interval& interval) const {
        double low = std::max(from.nearView, interval.nearView);
        if (!meets(from.nearView, low)) {
            return std::nullopt;
        }
        const double begin = low;
        double high = interval.farView;
        // A millionth of the cascade is exact enough, and takes half the time of the last bit.
        const auto isFine = [&] {
            return !(high - low > 1e-12 * high && high - low > 1e-6 * (low - from.nearView));
        };
        for (int i = 0; i < kMaxBisections && !isFine(); ++i) {
            const double middle = 0.5 * (low + high);
            (meets(from.nearView, middle) ? low : high) = middle;
        }
        return low > begin ? std::optional(low) : std::nullopt;
    }
};

/// A way to cover the nearest part: the one that reaches farthest for its numbers of cascades and clean ends.
struct Partial {
    Start next;                    ///< where the next cascade begins
    double farView = 0.0;          ///< where the last one ended
    std::size_t previousClean = 0; ///< clean ends of the Partial it goes on from
    bool reached = false;
};
using Row = std::vector<Partial>; ///< by clean ends

void offer(Row& row, std::size_t clean, const Partial& partial) {
    if (!row[clean].reached || partial.next.isBeyond(row[clean].next)) {
        row[clean] = partial;
    }
}

/// Row k + 1 from row k.
Row advance(const Problem& problem, const Row& row) {
    Row next(row.size() + 1);
    for (std::size_t clean = 0; clean < row.size(); ++clean) {
        if (!row[clean].reached) {
            continue;
        }
        const Start from = row[clean].next;
        const Reach reach = problem.reach(from);
        if (reach.whole > from.interval) {
            const bool done = reach.whole == problem.occupied.size();
            offer(next, clean + 1,
                  {.next = done ? Start{reach.whole, 0.0} : problem.start(reach.whole),
                   .farView = problem.occupied[reach.whole - 1].farView,
                   .previousClean = clean,
                   .reached = true});
        }
        if (reach.cutView) {
            offer(next, clean,
                  {.next = {reach.whole, *reach.cutView},
                   .farView = *reach.cutView,
                   .previousClean = clean,
                   .reached = true});
        }
    }
    return next;
}

/// The cascades that lead to the last row's entry `clean`.
Cascades trace(const std::vector<Row>& rows, std::size_t clean) {
    Cascades cascades(rows.size() - 1);
    for (std::size_t k = rows.size() - 1; k > 0; --k) {
        const Partial& partial = rows[k][clean];
        clean = partial.previousClean;
        cascades[k - 1] = {rows[k - 1][clean].next.nearView, partial.farView};
    }
    return cascades;
}

} // namespace

std::optional<Cascades> planCascades(const StepModel& model, const StepTarget& target,
                                     std::span<const Interval> occupied, std::size_t most) {
    const Problem problem{model, target, occupied};
    std::vector<Row> rows{{{.next = problem.start(0), .reached = true}}};
    while (rows.size() <= most) {
        rows.push_back(advance(problem, rows.back()));
        const Row& row = rows.back();
        for (std::size_t clean = row.size(); clean-- > 0;) {
            if (row[clean].reached && row[clean].next.interval == occupied.size()) {
                return trace(rows, clean);
            }
        }
    }
    return std::nullopt;
}

bool canMeet(const StepModel& model, const StepTarget& target, std::span<const Interval> occupied,
             std::size_t most) {
    const Problem problem{model, target, occupied};
    Start from = problem.start(0);
    for (std::size_t k = 0; k < most; ++k) {
        const Reach reach = problem.reach(from);
        if (reach.whole == occupied.size()) {
            return true;
        }
        from = reach.cutView ? Start{reach.whole, *reach.cutView} : problem.start(reach.whole);
    }
    return false;
}

StepTarget relaxToMeet(const StepModel& model, const StepTarget& target, std::span<const Interval> occupied,
                       std::size_t most) {
    if (canMeet(model, target, occupied, most)) {
        return target;
    }
    // One cascade over everything meets the target times the worst share that it takes of it.
    const StepTarget bare{.unitsView = target.unitsView, .shareView = target.shareView};
    const Cascade all{occupied.front().nearView, occupied.back().farView};
    double low = 0.0;
    double high = std::log2(worstStepShare(model, bare, all)) + 1e-9;
    for (int i = 0; i < kMaxBisections && high - low > 1e-3; ++i) {
        const double middle = 0.5 * (low + high);
        (canMeet(model, target.scaled(std::exp2(middle)), occupied, most) ? high : low) = middle;
    }
    return target.scaled(std::exp2(high));
}

} // namespace cdr::depth
