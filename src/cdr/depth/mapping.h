#pragma once

/// @file
/// @errors None but those that a function names.
/// @units Depths are of the depth buffer, in [0, 1]. Distances are view distances in scene units.

#include <cdr/base/export.h>
#include <cdr/base/result.h>
#include <cdr/depth/cascade.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace cdr::depth {

/// How a view distance w becomes a depth-buffer value in Vulkan's range [0, 1], between near n and far f.
///
/// - standard: f(w-n) / ((f-n)w), section 1.1.1 of the thesis.
/// - reversed: n / w where there is no far plane to clip at (Lapidous and Jiao 1999), else n(f-w) / ((f-n)w),
///   the mirror image of standard.
/// - log: ln(w/n) / ln(f/n), set per vertex, Listing 5.1 of the thesis after Ulrich 2011.
/// - logFragment: the same, set per fragment. Right on long triangles; costs early depth tests.
/// - anchored: standard, with w - n formed on the CPU in float64 per object. float32 then rounds the distance
///   to the near plane of the cascade, not to the camera.
/// - anchoredReversed: reversed, anchored at the far plane of the cascade, so it is finest there.
///
/// Choose anchoredReversed for detail on a backdrop, and for a target in scene units over a wide range, which
/// it meets with fewer cascades. In integer formats the two are mirror images of each other.
enum class Mapping : std::uint8_t { standard, reversed, log, logFragment, anchored, anchoredReversed };

/// All of them.
inline constexpr std::array kMappings{Mapping::standard,    Mapping::reversed, Mapping::log,
                                      Mapping::logFragment, Mapping::anchored, Mapping::anchoredReversed};

/// "standard", "reversed", "log", "log-fragment", "anchored" or "anchored-reversed".
/// @lifetime The program's.
CDR_EXPORT std::string_view nameOf(Mapping mapping);

/// A sentence or two for a user interface: what the mapping does, and what it is good and bad at.
/// @lifetime The program's.
CDR_EXPORT std::string_view explanationOf(Mapping mapping);

/// @throws base::InputError with a suggestion for an unknown name.
CDR_EXPORT Mapping parseMapping(std::string_view name);
/// parseMapping(), refused instead of thrown.
CDR_EXPORT base::Result<Mapping> tryParseMapping(std::string_view name);

/// Nearer surfaces have the larger depth: clear to 0, compare GREATER_OR_EQUAL.
constexpr bool isReversed(Mapping mapping) {
    return mapping == Mapping::reversed || mapping == Mapping::anchoredReversed;
}
/// Whether the depth is a logarithm of the view distance.
constexpr bool isLog(Mapping mapping) {
    return mapping == Mapping::log || mapping == Mapping::logFragment;
}
/// Whether view distances are taken relative to an anchor plane.
constexpr bool isAnchored(Mapping mapping) {
    return mapping == Mapping::anchored || mapping == Mapping::anchoredReversed;
}

/// A mapping over one range, [near, far] or [near, infinity).
struct DepthRange {
    Mapping mapping = Mapping::standard; ///< of view distance to depth
    double nearView = 0.0;               ///< view distance of the near plane
    /// Empty for reversed without a far plane, the form that engines ship. Every other mapping needs one.
    std::optional<double> farView;
};

/// The range that cascade `index` clips and bins against. It is the cascade's own; where the next cascade
/// touches it, the far plane is moved a little into that cascade, at most to its end. Otherwise view distances that round across
/// the shared plane would leave cracks (chapter 3 of the thesis). The overlap depends on what rounds:
/// - linear mappings: float32 view distances, 1e-6 of the far plane (1 unit at 10^6, as in the thesis);
/// - log: a logarithm that is interpolated linearly, 1e-4 of the far plane;
/// - anchored: float32 distances to the anchor plane, 1e-4 of the thickness of the cascade. Objects may be far larger than thin
///   cascades are, so there it is 1e-6 of the far plane, but at most 1 % of the thickness. Depth gets coarser by as much;
/// - anchoredReversed: the same, but at least 1e-6 of the thickness of the next cascade, whose anchor plane is its far one.
///
/// @param index below the number of cascades, which is not checked.
CDR_EXPORT Cascade clipRange(Mapping mapping, const Cascades& cascades, std::size_t index);

/// Where the depth range of the last reversed cascade ends. `open` is at infinity, which costs a float buffer
/// no precision. `closed` is at its far plane: an open thin cascade would use a small part of the depth range.
enum class FarEnd : std::uint8_t { open, closed };

/// The depth range of cascade `index`: its clip range. The last cascade of reversed is open to infinity
/// unless `farEnd` closes it.
/// @param index as clipRange() takes it.
CDR_EXPORT DepthRange depthRange(Mapping mapping, const Cascades& cascades, std::size_t index,
                                 FarEnd farEnd = FarEnd::open);
/// The same of a clip range. @param farEnd `open` only for the last cascade.
CDR_EXPORT DepthRange depthRange(Mapping mapping, const Cascade& clip, FarEnd farEnd);

/// Depth of a point at view distance w, w within the range.
CDR_EXPORT double zNdcAt(const DepthRange& range, double distanceView);

/// How much depth changes per unit of view distance at w, as a positive number.
CDR_EXPORT double depthSlope(const DepthRange& range, double distanceView);

/// Inverse of zNdcAt().
CDR_EXPORT double distanceViewAt(const DepthRange& range, double zNdc);

/// What a vertex shader needs. Let d = w - anchorView. Then clip w is w. Clip z is
/// - scale * d + offset for the linear mappings,
/// - w * ln(d * scale) * offset for the logarithmic ones.
struct ClipTerms {
    double anchorView = 0.0; ///< subtracted in float64; 0 unless the mapping is anchored
    double scale = 0.0;      ///< in the forms above
    double offset = 0.0;     ///< in the forms above
};

/// Of a range.
/// @throws base::RunError for a mapping that is none of the enumeration.
CDR_EXPORT ClipTerms clipTerms(const DepthRange& range);

} // namespace cdr::depth
