#pragma once

#include <cdr/depth/cascade.h>

#include <string>
#include <variant>
#include <vector>

namespace cdr::depth {

/// One cascade over [near, far].
struct SplitNone {
    bool operator==(const SplitNone&) const = default;
};

/// Each far plane is `ratio` times its near plane, the last ends at far (thesis Listing 5.2: 1000).
struct SplitRatio {
    double ratio = 1000.0; ///< > 1
    bool operator==(const SplitRatio&) const = default;
};

/// `count` cascades of one ratio.
struct SplitCount {
    unsigned count = 1; ///< 1 to kMaxCascades
    bool operator==(const SplitCount&) const = default;
};

/// Boundaries given by hand, ascending; those outside (near, far) are left out.
struct SplitAt {
    std::vector<double> boundariesView;
    bool operator==(const SplitAt&) const = default;
};

/// How the view-distance range is cut into cascades.
using Split = std::variant<SplitNone, SplitRatio, SplitCount, SplitAt>;

/// Reads "none", "ratio:R", "count:K" or "at:a,b,...". base::InputError says what is wrong.
Split parseSplit(const std::string& text);

/// The text parseSplit() reads.
std::string nameOf(const Split& split);

/// Cuts [nearView, farView] without gap or overlap, nearest first.
/// base::InputError unless 0 < near < far, both finite, and the split gives at most kMaxCascades.
Cascades makeCascades(const Split& split, double nearView, double farView);

} // namespace cdr::depth
