#include <cdr/base/enum_names.h>
#include <cdr/depth/mapping.h>

#include <cmath>

namespace cdr::depth {

namespace {

constexpr base::EnumNames<Mapping, kMappings.size()> kNames{
    "depth mapping", {"standard", "reversed", "log", "log-fragment", "anchored", "anchored-reversed"}};

} // namespace

std::string_view nameOf(Mapping mapping) {
    return kNames.nameOf(mapping);
}

Mapping parseMapping(std::string_view name) {
    return kNames.parse(name);
}

base::Result<Mapping> tryParseMapping(std::string_view name) {
    return kNames.tryParse(name);
}

Cascade clipRange(Mapping mapping, const Cascades& cascades, std::size_t index) {
    Cascade range = cascades[index];
    if (index + 1 < cascades.size() && cascades[index + 1].nearView == range.farView) {
        range.farView += isAnchored(mapping) ? 1e-4 * (range.farView - range.nearView)
                         : isLog(mapping)    ? 1e-4 * range.farView
                                             : 1e-6 * range.farView;
    }
    return range;
}

DepthRange depthRange(Mapping mapping, const Cascades& cascades, std::size_t index, FarEnd farEnd) {
    const Cascade clip = clipRange(mapping, cascades, index);
    const bool open = mapping == Mapping::reversed && index + 1 == cascades.size() && farEnd == FarEnd::open;
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
    // Both forms solve 1/w as a blend of 1/n and 1/f.
    const double towardsFar = isReversed(range.mapping) ? 1.0 - zNdc : zNdc;
    return n * f / (f - towardsFar * (f - n));
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
