#pragma once

#include <cdr/depth/cascade.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace cdr::depth {

/// How a view distance w becomes a depth-buffer value, Vulkan range [0, 1].
///
/// - standard: f(w-n) / ((f-n)w), thesis section 1.1.1.
/// - reversed: n / w where the range has no far plane to clip at (Lapidous and Jiao 1999), else its mirror
/// image of
///   standard, n(f-w) / ((f-n)w).
/// - log: ln(w/n) / ln(f/n), set per vertex, thesis Listing 5.1 after Ulrich 2011.
/// - logFragment: the same, set per fragment: right on long triangles, at the price of early depth tests.
/// - anchored: standard, with w - n formed on the CPU in float64 per object, so float32 rounds the distance
/// to the
///   cascade's near plane and not to the camera (DESIGN section 3).
/// - anchoredReversed: reversed, anchored at the cascade's far plane, so finest there.
///
/// anchoredReversed is the better for detail on a backdrop, and for a target in scene units over a wide
/// range, which it holds with fewer cascades; with integer depth the two are mirror images.
enum class Mapping : std::uint8_t { standard, reversed, log, logFragment, anchored, anchoredReversed };

inline constexpr std::array kMappings{Mapping::standard,    Mapping::reversed, Mapping::log,
                                      Mapping::logFragment, Mapping::anchored, Mapping::anchoredReversed};

std::string_view nameOf(Mapping mapping);

/// base::InputError with a suggestion for an unknown name.
Mapping parseMapping(std::string_view name);

/// Nearer surfaces have the larger depth: clear to 0, compare GREATER_OR_EQUAL.
constexpr bool isReversed(Mapping mapping) {
    return mapping == Mapping::reversed || mapping == Mapping::anchoredReversed;
}
constexpr bool isLog(Mapping mapping) {
    return mapping == Mapping::log || mapping == Mapping::logFragment;
}
constexpr bool isAnchored(Mapping mapping) {
    return mapping == Mapping::anchored || mapping == Mapping::anchoredReversed;
}

/// A mapping over one range, [n, f] or [n, infinity).
struct DepthRange {
    Mapping mapping = Mapping::standard;
    double nearView = 0.0;
    /// Empty for reversed without a far plane, the industry's form; every other mapping needs one.
    std::optional<double> farView;
};

/// The range that cascade `index` clips and bins against: its own, its far plane pushed a little into the
/// next cascade where that one touches it. Without that, view distances that round across the shared plane
/// would leave cracks (thesis chapter 3). How far depends on what rounds:
/// - linear mappings: float32 view distances, 1e-6 of the far plane (1 unit at 10^6, the thesis' own overlap
/// there);
/// - log: the bend of a logarithm interpolated linearly, 1e-4 of the far plane;
/// - anchored: float32 distances to the anchor plane, 1e-4 of the cascade's thickness.
Cascade clipRange(Mapping mapping, const Cascades& cascades, std::size_t index);

/// Where the last reversed cascade's depth ends: at infinity, which costs a float buffer nothing, or at its
/// far plane, without which a thin cascade would use a sliver of the depth range.
enum class FarEnd : std::uint8_t { open, closed };

/// The depth range of cascade `index` in a split: its clip range, open to infinity for the last reversed one
/// unless told otherwise.
DepthRange depthRange(Mapping mapping, const Cascades& cascades, std::size_t index,
                      FarEnd farEnd = FarEnd::open);

/// Depth of a point at view distance w, w within the range.
double zNdcAt(const DepthRange& range, double distanceView);

/// How much depth changes per unit of view distance at w, as a positive number.
double depthSlope(const DepthRange& range, double distanceView);

/// Inverse of zNdcAt().
double distanceViewAt(const DepthRange& range, double zNdc);

/// What a vertex shader needs: with d = w - anchorView, clip z = scale * d + offset for the linear mappings,
/// and clip z = w * ln(d * scale) * offset for the logarithmic ones; clip w is w.
struct ClipTerms {
    double anchorView = 0.0;
    double scale = 0.0;
    double offset = 0.0;
};

ClipTerms clipTerms(const DepthRange& range);

} // namespace cdr::depth
