#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::measure {

/// The value below which `percent` of the samples lie, interpolated linearly between neighbours. Hyndman and
/// Fan 1996, type 7: what NumPy, R and spreadsheets give.
/// @param samples at least one, in any order, none of them NaN; base::InputError when empty.
/// @param percent 0 to 100.
double percentile(std::vector<double> samples, double percent);

/// percentile() of samples in ascending order, without an allocation.
/// @param sorted at least one, which is not checked.
/// @tparam Number float or double.
template <typename Number>
double percentileOfSorted(const std::vector<Number>& sorted, double percent) {
    const double place = percent / 100.0 * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double share = place - std::floor(place);
    // The next one may be infinite, no part of which is 0.
    return share > 0.0
               ? std::lerp(static_cast<double>(sorted[below]), static_cast<double>(sorted[above]), share)
               : static_cast<double>(sorted[below]);
}

/// The 50th percentile: the mean of the two middle samples where their number is even.
double median(std::vector<double> samples);

struct Interval {
    double low = 0.0;
    double high = 0.0;

    bool contains(double value) const { return value >= low && value <= high; }
};

/// Fewer samples have no 95 % interval of their median: even from the smallest to the largest of n it is missed with 2^(1 - n).
inline constexpr std::size_t kMinIntervalSamples = 6;

/// How often bootstrapMedian() resamples by default: its interval's ends then vary by a few percent of its width.
inline constexpr std::size_t kResamples = 2000;

/// 95 % interval of the median by the percentile bootstrap (Efron 1979): the middle 95 % of the medians of
/// resamples drawn with replacement. The same interval for the same samples and seed on every platform.
/// Samples count as independent, so it is too narrow for a series that drifts. Nothing for fewer than kMinIntervalSamples.
/// @param samples at least one; base::InputError when empty.
/// @param resamples at least one.
std::optional<Interval> bootstrapMedian(const std::vector<double>& samples, std::uint64_t seed,
                                        std::size_t resamples = kResamples);

} // namespace cdr::measure
