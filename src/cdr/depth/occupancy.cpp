#include <cdr/depth/occupancy.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace cdr::depth {

namespace {

constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigits = 6; ///< of a 64-bit key
constexpr std::size_t kDigitValues = std::size_t{1} << kDigitBits;
/// Below this many a comparison sort is faster.
constexpr std::size_t kRadixSmallest = 1500;

/// Float64 values order as these keys do: positive ones as their bits, negative ones in the opposite order and before.
std::size_t digitOf(const Interval& interval, std::size_t digit) {
    constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
    const auto bits = std::bit_cast<std::uint64_t>(interval.nearView);
    const std::uint64_t key = (bits & kSign) != 0 ? ~bits : bits | kSign;
    return (key >> (digit * kDigitBits)) % kDigitValues;
}

/// Least significant digit first; digits that all share are skipped, as the exponent's often is.
void radixSort(std::span<Interval> intervals) {
    std::vector<std::array<std::uint32_t, kDigitValues>> counts(kDigits);
    for (const Interval& interval : intervals) {
        for (std::size_t digit = 0; digit < kDigits; ++digit) {
            ++counts[digit][digitOf(interval, digit)];
        }
    }
    std::vector<Interval> sorted(intervals.size());
    for (std::size_t digit = 0; digit < kDigits; ++digit) {
        if (counts[digit][digitOf(intervals.front(), digit)] == intervals.size()) {
            continue;
        }
        std::uint32_t next = 0;
        for (std::uint32_t& count : counts[digit]) {
            next += std::exchange(count, next);
        }
        for (const Interval& interval : intervals) {
            sorted[counts[digit][digitOf(interval, digit)]++] = interval;
        }
        std::copy(sorted.begin(), sorted.end(), intervals.begin());
    }
}

bool beginsBefore(const Interval& a, const Interval& b) {
    return a.nearView < b.nearView;
}

void sortByNear(std::span<Interval> intervals) {
    if (intervals.size() < kRadixSmallest) {
        std::sort(intervals.begin(), intervals.end(), beginsBefore);
    } else {
        radixSort(intervals);
    }
}

/// Divides what begins in [first, last] evenly, in ascending order.
class Buckets {
  public:
    static constexpr std::size_t kCount = 1024;

    Buckets(double first, double last) : m_first(first), m_perView(kCount / (last - first)) {}

    /// Whether distances can be told apart by them.
    bool areUsable() const { return std::isfinite(m_perView) && m_perView > 0.0; }

    /// The last one is that of all distances beyond.
    std::size_t of(double view) const {
        return static_cast<std::size_t>(std::min((view - m_first) * m_perView, double{kCount}));
    }

  private:
    double m_first;
    double m_perView;
};

/// Replaces intervals that begin in one bucket and end in a later one by one interval. Each of them holds the last of their
/// beginnings, so they overlap. Sorts the others. Most of a crowded scene is replaced, in one pass.
/// @return how many intervals are left, in ascending order.
std::size_t joinAndSort(std::span<Interval> intervals) {
    const auto [first, last] = std::minmax_element(intervals.begin(), intervals.end(), beginsBefore);
    const Buckets buckets(first->nearView, last->nearView);
    if (!buckets.areUsable()) {
        sortByNear(intervals);
        return intervals.size();
    }
    constexpr double kNone = std::numeric_limits<double>::infinity();
    std::array<Interval, Buckets::kCount> joined;
    joined.fill({kNone, -kNone});
    std::size_t others = 0;
    for (const Interval& interval : intervals) {
        const std::size_t bucket = buckets.of(interval.nearView);
        if (buckets.of(interval.farView) > bucket) {
            Interval& into = joined[bucket];
            into = {std::min(into.nearView, interval.nearView), std::max(into.farView, interval.farView)};
        } else {
            intervals[others++] = interval;
        }
    }
    const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(others);
    const auto end = std::copy_if(joined.begin(), joined.end(), middle,
                                  [](const Interval& interval) { return interval.nearView < kNone; });
    sortByNear({intervals.begin(), middle});
    std::inplace_merge(intervals.begin(), middle, end, beginsBefore);
    return static_cast<std::size_t>(end - intervals.begin());
}

} // namespace

double thinnest(std::span<const Interval> intervals, double nearView, double farView) {
    double least = std::numeric_limits<double>::infinity();
    for (const Interval& interval : intervals) {
        const double thickness = interval.farView - interval.nearView;
        const bool meets = interval.nearView <= farView && interval.farView >= nearView;
        least = meets && thickness > 0.0 && thickness < least ? thickness : least;
    }
    return std::isfinite(least) ? least : 0.0;
}

std::vector<Interval> mergeIntervals(std::span<Interval> intervals, double nearView, double farView,
                                     double rounding) {
    std::size_t kept = 0;
    for (const Interval& interval : intervals) {
        // Written so that a comparison with what is not a number leaves the interval out.
        if (interval.nearView <= farView && interval.farView >= nearView &&
            interval.farView >= interval.nearView) {
            intervals[kept++] = {std::max(interval.nearView, nearView), std::min(interval.farView, farView)};
        }
    }
    if (kept == 0) {
        return {};
    }
    kept = joinAndSort(intervals.first(kept));
    std::vector<Interval> merged;
    for (const Interval& interval : intervals.first(kept)) {
        const double end = merged.empty() ? 0.0 : merged.back().farView;
        if (!merged.empty() && interval.nearView <= end * (1.0 + std::copysign(2.0 * rounding, end))) {
            merged.back().farView = std::max(end, interval.farView);
        } else {
            merged.push_back(interval);
        }
    }
    return merged;
}

double endRounding(Mapping mapping) {
    return isAnchored(mapping) ? 0x1p-46 : 1e-6;
}

} // namespace cdr::depth
