#pragma once

#include <cdr/depth/cascade.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace cdr::visibility {

/// Instances classified together: the working set stays in the first-level cache and the loops over it are
/// vectorised.
inline constexpr std::size_t kLandingBlock = 256;

/// The ranges that are binned into as two plain arrays, both ascending, so that the cascades an instance meets
/// are neighbours.
struct LandingRanges {
    std::array<double, depth::kMaxCascades> nearView{};
    std::array<double, depth::kMaxCascades> farView{};
    std::size_t count = 0;
    double wideSpan = 0.0;

    /// As binByDistance() takes them.
    LandingRanges(const depth::Cascades& clipRanges, double span);
};

/// Where each instance of a block lands: in the cascades [first, end), none where end <= first.
struct Landings {
    // As wide as the numbers they are compared from, so that compilers need not pack them in between.
    std::array<std::int64_t, kLandingBlock> first;
    std::array<std::int64_t, kLandingBlock> end;
    std::array<std::int64_t, kLandingBlock> wide; ///< 1 or 0
};

/// @param distanceView and radius of `count` instances, at most kLandingBlock.
void findLandings(const LandingRanges& ranges, const double* distanceView, const float* radius,
                  std::size_t count, Landings& landings);

} // namespace cdr::visibility
