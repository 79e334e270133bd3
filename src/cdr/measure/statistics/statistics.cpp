#include <cdr/base/error.h>
#include <cdr/measure/statistics/statistics.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace cdr::measure {

namespace {

void requireSamples(const std::vector<double>& samples) {
    if (samples.empty()) {
        throw base::InputError("statistics need at least one sample");
    }
}

/// The index below which lie `rank` of the drawn indices, given how often each was drawn.
class RankFinder {
  public:
    explicit RankFinder(const std::vector<std::uint32_t>& drawn) : m_drawn(drawn), m_passed(drawn[0]) {}

    /// Ranks must ascend from call to call.
    std::size_t indexAt(std::size_t rank) {
        while (m_passed <= rank) {
            m_passed += m_drawn[++m_index];
        }
        return m_index;
    }

  private:
    const std::vector<std::uint32_t>& m_drawn;
    std::size_t m_passed;
    std::size_t m_index = 0;
};

/// A whole number in [0, bound) from 32 random bits, the same everywhere, unlike
/// std::uniform_int_distribution's. Its bias is below bound / 2^32.
std::size_t boundedIndex(std::uint32_t bits, std::size_t bound) {
    return static_cast<std::size_t>((std::uint64_t{bits} * bound) >> 32);
}

} // namespace

double percentile(std::vector<double> samples, double percent) {
    requireSamples(samples);
    std::sort(samples.begin(), samples.end());
    return percentileOfSorted(samples, percent);
}

double median(std::vector<double> samples) {
    return percentile(std::move(samples), 50.0);
}

std::optional<Interval> bootstrapMedian(const std::vector<double>& samples, std::uint64_t seed,
                                        std::size_t resamples) {
    requireSamples(samples);
    if (samples.size() < kMinIntervalSamples) {
        return std::nullopt;
    }
    std::vector<double> sorted = samples;
    std::sort(sorted.begin(), sorted.end());
    std::mt19937 random(static_cast<std::uint32_t>(seed ^ (seed >> 32)));
    std::vector<double> medians(resamples);
    std::vector<std::uint32_t> drawn(sorted.size());
    for (double& resampled : medians) {
        // Counting the draws per sorted sample finds the median without sorting the resample.
        std::fill(drawn.begin(), drawn.end(), 0);
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            ++drawn[boundedIndex(static_cast<std::uint32_t>(random()), sorted.size())];
        }
        RankFinder finder(drawn);
        const double low = sorted[finder.indexAt((sorted.size() - 1) / 2)];
        resampled = std::midpoint(low, sorted[finder.indexAt(sorted.size() / 2)]);
    }
    std::sort(medians.begin(), medians.end());
    return Interval{.low = percentileOfSorted(medians, 2.5), .high = percentileOfSorted(medians, 97.5)};
}

} // namespace cdr::measure
