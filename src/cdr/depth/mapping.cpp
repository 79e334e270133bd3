#include <cdr/base/enum_names.h>
#include <cdr/depth/mapping.h>

#include <algorithm>
#include <cmath>

namespace cdr::depth {

namespace {

constexpr auto kRows = std::to_array<base::ExplainedName>(
    {{"standard",
      "Ordinary perspective depth. It works on all hardware, but spends nearly all of its precision just "
      "in front of the camera."},
     {"reversed",
      "Near over distance, stored in a float. The steps of the float compensate the perspective, so the "
      "relative precision is the same everywhere. Most engines ship it. It ends where float32 positions "
      "do, at about a ten-millionth of the distance."},
     {"log", "The logarithm of the distance, set at each vertex. The relative precision is the same in any "
             "format, but triangles that are long for their distance are wrong between their vertices."},
     {"log-fragment",
      "The logarithm of the distance, set at each pixel. It is right on every triangle, but early depth "
      "tests are lost."},
     {"anchored",
      "Depth from the cascade's near plane, whose distance the CPU subtracts in float64. So float32 rounds "
      "the distance to that plane and not to the camera. It resolves micrometres up to 10^11 units. It "
      "takes one subtraction per object and cascade, and cascades must be thin."},
     {"anchored-reversed",
      "The same from the cascade's far plane, and finest at its far end. It is for detail on a backdrop or "
      "on the ground below. With a float buffer it needs fewer cascades to hold one step over a wide "
      "range."}});

constexpr base::EnumNames<Mapping, kMappings.size()> kNames{"depth mapping", base::namesOf(kRows)};

} // namespace

std::string_view nameOf(Mapping mapping) {
    return kNames.nameOf(mapping);
}

std::string_view explanationOf(Mapping mapping) {
    return kRows.at(static_cast<std::size_t>(mapping)).explanation;
}

Mapping parseMapping(std::string_view name) {
    return kNames.parse(name);
}

base::Result<Mapping> tryParseMapping(std::string_view name) {
    return kNames.tryParse(name);
}

namespace {

/// How far a cascade reaches into the next one.
double overlapView(Mapping mapping, const Cascade& cascade, const Cascade& next) {
    if (isLog(mapping)) {
        return 1e-4 * cascade.farView;
    }
    const double linearView = 1e-6 * cascade.farView;
    const double depthView = cascade.farView - cascade.nearView;
    const double sharedView =
        isAnchored(mapping) ? std::clamp(linearView, 1e-4 * depthView, 1e-2 * depthView) : linearView;
    // The next one's anchor is its far plane, so it rounds where they meet by its thickness.
    return mapping == Mapping::anchoredReversed ? std::max(sharedView, 1e-6 * (next.farView - next.nearView))
                                                : sharedView;
}

} // namespace

Cascade clipRange(Mapping mapping, const Cascades& cascades, std::size_t index) {
    Cascade range = cascades[index];
    if (index + 1 < cascades.size() && cascades[index + 1].nearView == range.farView) {
        const Cascade& next = cascades[index + 1];
        range.farView = std::min(range.farView + overlapView(mapping, range, next), next.farView);
    }
    return range;
}

DepthRange depthRange(Mapping mapping, const Cascades& cascades, std::size_t index, FarEnd farEnd) {
    return depthRange(mapping, clipRange(mapping, cascades, index),
                      index + 1 == cascades.size() ? farEnd : FarEnd::closed);
}

DepthRange depthRange(Mapping mapping, const Cascade& clip, FarEnd farEnd) {
    const bool open = mapping == Mapping::reversed && farEnd == FarEnd::open;
    return {.mapping = mapping,
            .nearView = clip.nearView,
            .farView = open ? std::nullopt : std::optional(clip.farView)};
}

double zNdcAt(const DepthRange& range, double distanceView) {
    const ClipTerms terms = clipTerms(range);
    const double offsetView = distanceView - terms.anchorView;
    if (isLog(range.mapping)) {
        return std::log(offsetView * terms.scale) * terms.offset;
    }
    return (terms.scale * offsetView + terms.offset) / distanceView;
}

double depthSlope(const DepthRange& range, double distanceView) {
    const double n = range.nearView;
    if (isLog(range.mapping)) {
        return 1.0 / (distanceView * std::log(*range.farView / n));
    }
    // Every linear mapping falls off as this scale over w.
    const double scale = range.farView ? *range.farView * n / (*range.farView - n) : n;
    return scale / (distanceView * distanceView);
}

double distanceViewAt(const DepthRange& range, double zNdc) {
    const double n = range.nearView;
    if (isLog(range.mapping)) {
        return n * std::exp(zNdc * std::log(*range.farView / n));
    }
    if (!range.farView) {
        return n / zNdc;
    }
    const double f = *range.farView;
    // 1/w is a blend of 1/n and 1/f. Reversed depths near 0 keep all their bits.
    return n * f / (isReversed(range.mapping) ? n + zNdc * (f - n) : f * (1.0 - zNdc) + n * zNdc);
}

ClipTerms clipTerms(const DepthRange& range) {
    const double n = range.nearView;
    if (!range.farView) {
        return {.anchorView = 0.0, .scale = 0.0, .offset = n};
    }
    const double f = *range.farView;
    const double depth = f - n;
    switch (range.mapping) {
    case Mapping::standard:
        return {.anchorView = 0.0, .scale = f / depth, .offset = -f * n / depth};
    case Mapping::reversed:
        return {.anchorView = 0.0, .scale = -n / depth, .offset = n * f / depth};
    case Mapping::log:
    case Mapping::logFragment:
        return {.anchorView = 0.0, .scale = 1.0 / n, .offset = 1.0 / std::log(f / n)};
    case Mapping::anchored:
        return {.anchorView = n, .scale = f / depth, .offset = 0.0};
    case Mapping::anchoredReversed:
        return {.anchorView = f, .scale = -n / depth, .offset = 0.0};
    }
    base::raise<base::RunError>("depth mapping out of range");
}

} // namespace cdr::depth
