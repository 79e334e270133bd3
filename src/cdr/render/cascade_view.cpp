#include <cdr/render/cascade_view.h>

#include <algorithm>
#include <iterator>

namespace cdr::render {

namespace {

/// As few pixels as cover the picture, none wider or higher than `scale` of the picture's.
vk::Extent2D shrunk(vk::Extent2D extent, std::uint32_t scale) {
    return {(extent.width + scale - 1) / scale, (extent.height + scale - 1) / scale};
}

template <typename Value, typename Member>
std::vector<Value> collect(std::span<const CascadeView> views, Member member) {
    std::vector<Value> values;
    values.reserve(views.size());
    std::transform(views.begin(), views.end(), std::back_inserter(values), member);
    return values;
}

} // namespace

std::vector<CascadeView> makeCascadeViews(const depth::Cascades& split, const CascadeViewOptions& options) {
    const depth::Cascades drawn =
        options.lens && options.overlaps ? options.lens->overlapping(split) : split;
    std::vector<CascadeView> views;
    views.reserve(split.size());
    for (std::size_t i = 0; i < split.size(); ++i) {
        const depth::FarEnd farEnd = i + 1 == split.size() ? options.farEnd : depth::FarEnd::closed;
        const depth::Cascade clipRange = depth::clipRange(options.mapping, drawn, i);
        const std::uint32_t scale = options.lens ? options.lens->scaleOf(split[i]) : 1;
        views.push_back({.range = split[i],
                         .clipRange = clipRange,
                         .terms = depth::clipTerms(depth::depthRange(options.mapping, clipRange, farEnd)),
                         .slice = {},
                         .extent = shrunk(options.extent, scale)});
    }
    return views;
}

depth::Cascades rangesOf(std::span<const CascadeView> views) {
    return collect<depth::Cascade>(views, [](const CascadeView& view) { return view.range; });
}

depth::Cascades clipRangesOf(std::span<const CascadeView> views) {
    return collect<depth::Cascade>(views, [](const CascadeView& view) { return view.clipRange; });
}

std::vector<double> anchorsOf(std::span<const CascadeView> views) {
    return collect<double>(views, [](const CascadeView& view) { return view.terms.anchorView; });
}

shaders::CascadePush makeCascadePush(const CascadeView& view, const scene::Frustum& frustum,
                                     std::size_t cascade) {
    return {.anchorView = static_cast<float>(view.terms.anchorView),
            .depthScale = static_cast<float>(view.terms.scale),
            .depthOffset = static_cast<float>(view.terms.offset),
            .nearAhead = static_cast<float>(view.clipRange.nearView - view.terms.anchorView),
            .farAhead = static_cast<float>(view.clipRange.farView - view.terms.anchorView),
            .projectionX = static_cast<float>(1.0 / frustum.tanX),
            .projectionY = static_cast<float>(-1.0 / frustum.tanY),
            .cascade = static_cast<std::uint32_t>(cascade),
            .minDepth = view.slice.min,
            .maxDepth = view.slice.max};
}

} // namespace cdr::render
