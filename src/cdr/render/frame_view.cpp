#include <cdr/depth/view_constants.h>
#include <cdr/render/frame_view.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <type_traits>

namespace cdr::render {

namespace {

template <typename Part>
auto ofEach(const std::vector<CascadeView>& cascades, const Part& part) {
    std::vector<std::invoke_result_t<Part, const CascadeView&>> values;
    values.reserve(cascades.size());
    std::transform(cascades.begin(), cascades.end(), std::back_inserter(values), part);
    return values;
}

} // namespace

depth::Cascades FrameView::ranges() const {
    return ofEach(cascades, [](const CascadeView& cascade) { return cascade.range; });
}

depth::Cascades FrameView::clipRanges() const {
    return ofEach(cascades, [](const CascadeView& cascade) { return cascade.clipRange; });
}

std::vector<double> FrameView::anchorsView() const {
    return ofEach(cascades, [](const CascadeView& cascade) { return cascade.terms.anchorView; });
}

std::vector<CascadeView> cascadeViews(depth::Mapping mapping, const depth::Cascades& ranges,
                                      const depth::Cascades& drawn, depth::FarEnd farEnd,
                                      vk::Extent2D extent) {
    std::vector<CascadeView> views;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const depth::Cascade clipRange = depth::clipRange(mapping, drawn, i);
        const depth::FarEnd end = i + 1 == ranges.size() ? farEnd : depth::FarEnd::closed;
        views.push_back({.range = ranges[i],
                         .clipRange = clipRange,
                         .terms = depth::clipTerms(depth::depthRange(mapping, clipRange, end)),
                         .extent = extent});
    }
    return views;
}

glm::vec2 clipLensShift(const scene::Frustum& frustum) {
    return glm::vec2(frustum.centre / glm::dvec2(frustum.tanX, -frustum.tanY));
}

depth::CascadeConstants makeCascadeConstants(const FrameView& view, std::size_t cascade) {
    const CascadeView& made = view.cascades[cascade];
    const depth::ClipTerms& terms = made.terms;
    const depth::FloatPair anchor = depth::floatPair(terms.anchorView);
    return {.anchorView = anchor.value,
            .scale = static_cast<float>(terms.scale),
            .offset = static_cast<float>(terms.offset),
            .anchorRest = anchor.rest,
            .nearAhead = static_cast<float>(made.clipRange.nearView - terms.anchorView),
            .farAhead = static_cast<float>(made.clipRange.farView - terms.anchorView),
            .projectionX = static_cast<float>(1.0 / view.frustum.tanX),
            .projectionY = static_cast<float>(-1.0 / view.frustum.tanY)};
}

shaders::CascadePush makeCascadePush(const FrameView& view, std::size_t cascade) {
    const depth::CascadeConstants constants = makeCascadeConstants(view, cascade);
    const DepthSlice& slice = view.cascades[cascade].slice;
    const glm::vec2 lens = clipLensShift(view.frustum);
    return {.anchorView = constants.anchorView,
            .depthScale = constants.scale,
            .depthOffset = constants.offset,
            .nearAhead = constants.nearAhead,
            .farAhead = constants.farAhead,
            .projectionX = constants.projectionX,
            .projectionY = constants.projectionY,
            .cascade = static_cast<std::uint32_t>(cascade),
            .minDepth = slice.min,
            .maxDepth = slice.max,
            .layerOffset = 0.0f,
            .layerRank = 0.0f,
            .lensX = lens.x,
            .lensY = lens.y};
}

} // namespace cdr::render
