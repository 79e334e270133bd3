#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/base/result.h>
#include <cdr/depth/cascade.h>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cdr::depth {

/// One cascade over [near, far].
struct SplitNone {
    bool operator==(const SplitNone&) const = default;
};

/// Each far plane is `ratio` times its near plane, the last ends at far (thesis Listing 5.2: 1000).
struct SplitRatio {
    double ratio = 1000.0; ///< > 1, finite
    bool operator==(const SplitRatio&) const = default;
};

/// `count` cascades of one ratio.
struct SplitCount {
    unsigned count = 1; ///< 1 to kMaxCascades
    bool operator==(const SplitCount&) const = default;
};

/// Boundaries given by hand, at least one, above 0 and ascending; those outside (near, far) are left out.
struct SplitAt {
    std::vector<double> boundariesView; ///< view distances
    bool operator==(const SplitAt&) const = default;
};

/// Fitted to what is visible: the fewest cascades whose steps stay below a target, and none over empty space.
///
/// Bounds stay put from frame to frame. They have a margin of 1/128 of the cascade where the target allows it. Previous
/// ones are kept while they meet a target that is 1/8 wider.
struct SplitFitted {
    /// What the target is in: a pixel's footprint, or scene units.
    enum class Unit { pixels, scene };
    /// Largest step: a share of what a pixel covers at its distance, or scene units. With a thousandth of a
    /// pixel, a 60 degree lens and Mapping::anchored, one cascade of small objects spans a ratio of 109, 28, 19
    /// or 10 in a picture of 180, 720, 1080 or 2160 rows. Small objects that fill everything from 0.1 to 100,000
    /// so take three, five, five or seven. Large objects alone allow wider cascades.
    ///
    /// Gaps that are smaller than the target may be drawn wrong. A thousandth of a pixel is
    /// 2 tan(fovY / 2) / height / 1000 of the distance. In a picture that spans many decades, Mapping::reversed
    /// can resolve smaller gaps than this target asks for; a smaller target with a larger `most` resolves them.
    double target = 0.001;    ///< > 0, finite
    Unit unit = Unit::pixels; ///< of `target`
    unsigned most = 8;        ///< 1 to kMaxCascades; a target that needs more is relaxed
    bool operator==(const SplitFitted&) const = default;
};

/// `count` cascades over [near, far] whose worst step, in scene units, is the smallest that many can have.
struct SplitMinimax {
    unsigned count = 1; ///< 1 to kMaxCascades
    bool operator==(const SplitMinimax&) const = default;
};

/// How the view-distance range is cut into cascades.
using Split = std::variant<SplitNone, SplitRatio, SplitCount, SplitAt, SplitFitted, SplitMinimax>;

/// Why the numbers of a split are none that it may have: empty where each is in the range that its comment says.
CDR_EXPORT std::optional<base::Refusal> splitProblem(const Split& split);

/// Reads "none", "ratio:R", "count:K", "at:a,b,...", "minimax:K" or "fitted[:TARGET[px][,max=K]]", TARGET in
/// scene units, or in pixels with "px".
/// @throws base::InputError for any other text, and says what is wrong.
CDR_EXPORT Split parseSplit(std::string_view text);
/// parseSplit(), refused instead of thrown.
CDR_EXPORT base::Result<Split> tryParseSplit(std::string_view text);

/// The text parseSplit() reads.
CDR_EXPORT std::string nameOf(const Split& split);

} // namespace cdr::depth
