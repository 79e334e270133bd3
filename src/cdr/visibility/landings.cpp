#include <cdr/platform/vector_clones.h>
#include <cdr/visibility/landings.h>

#include <algorithm>

namespace cdr::visibility {

LandingRanges::LandingRanges(const depth::Cascades& clipRanges, double span)
    : count(clipRanges.size()),
      wideSpan(span) {
    double farthest = 0.0;
    for (std::size_t c = 0; c < count; ++c) {
        nearView[c] = clipRanges[c].nearView;
        farthest = std::max(farthest, clipRanges[c].farView);
        farView[c] = farthest;
    }
}

/// The hot loops: straight-line arithmetic over arrays, no branch, so compilers vectorise them.
CDR_VECTOR_CLONES
void findLandings(const LandingRanges& ranges, const double* distanceView, const float* radius,
                  std::size_t count, Landings& landings) {
    std::array<double, kLandingBlock> lows;
    std::array<double, kLandingBlock> highs;
    for (std::size_t i = 0; i < count; ++i) {
        const double low = distanceView[i] - static_cast<double>(radius[i]);
        const double high = distanceView[i] + static_cast<double>(radius[i]);
        lows[i] = low;
        highs[i] = high;
        // An infinite span times a distance of 0 is not a number, compares false, and so still says compact.
        landings.wide[i] = high - low > ranges.wideSpan * std::max(low, 0.0) ? 1 : 0;
        landings.first[i] = 0;
        landings.end[i] = 0;
    }
    for (std::size_t c = 0; c < ranges.count; ++c) {
        const double farView = ranges.farView[c];
        const double nearView = ranges.nearView[c];
        for (std::size_t i = 0; i < count; ++i) {
            landings.first[i] += farView < lows[i] ? 1 : 0;
            landings.end[i] += nearView <= highs[i] ? 1 : 0;
        }
    }
}

} // namespace cdr::visibility
