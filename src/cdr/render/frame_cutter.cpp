#include <cdr/render/frame_cutter.h>

#include <array>
#include <optional>

namespace cdr::render {

namespace {

/// As few pixels as cover a picture when none is wider or higher than `scale` of the picture's.
vk::Extent2D shrunk(vk::Extent2D extent, std::uint32_t scale) {
    return {(extent.width + scale - 1) / scale, (extent.height + scale - 1) / scale};
}

} // namespace

FrameCutter::FrameCutter(const RenderOptions& options, const Targets& targets)
    : m_targets(targets),
      m_mapping(options.technique.mapping),
      m_detail(options.detail),
      m_focus(options.focus),
      m_part(options.part),
      m_extent{options.width, options.height},
      m_split(options.technique) {}

FrameView FrameCutter::look(const scene::Camera& camera) const {
    const scene::Frustum frustum = scene::frustumOf(camera, m_extent.width, m_extent.height);
    return {.camera = camera, .frustum = frustum, .levels = visibility::levelRule(m_detail, frustum)};
}

void FrameCutter::cut(FrameView& view, const visibility::VisibleCells& visible,
                      std::span<const depth::Interval> occupied) {
    take(view, m_split.cut(view.camera, view.frustum, std::array{&visible}, occupied));
}

void FrameCutter::take(FrameView& view, const depth::Cascades& ranges) const {
    std::optional<FocusLens> lens;
    if (m_focus.isOn()) {
        lens.emplace(m_focus, view.frustum.tanY, m_extent.height);
    }
    const depth::Cascades drawn = lens && m_focus.blend ? lens->overlapping(ranges) : ranges;
    view.drawn = m_part.of(ranges.size());
    view.cascades = cascadeViews(m_mapping, ranges, drawn, m_split.farEnd(), m_extent);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        view.cascades[i].slice = m_targets.depthSlice(i, ranges.size());
        if (lens) {
            view.cascades[i].extent = shrunk(m_extent, lens->scaleOf(ranges[i]));
        }
    }
}

} // namespace cdr::render
