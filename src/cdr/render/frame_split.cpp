#include <cdr/render/frame_split.h>

namespace cdr::render {

depth::Cascades FrameSplit::cut(const scene::Camera& camera, const scene::Frustum& frustum,
                                std::span<const visibility::VisibleCells* const> visible,
                                std::span<const depth::Interval> occupied) {
    m_intervals.clear();
    if (needsVisible()) {
        for (const visibility::VisibleCells* seen : visible) {
            visibility::appendIntervals(*seen, m_intervals);
        }
    }
    m_intervals.insert(m_intervals.end(), occupied.begin(), occupied.end());
    depth::Cascades made =
        depth::makeCascades(m_technique.split, {.nearView = camera.nearView,
                                                .farView = camera.farView,
                                                .model = {m_technique.mapping, m_technique.format},
                                                .footprintSlope = frustum.footprintSlope,
                                                .visible = m_intervals,
                                                .previous = m_previous});
    m_previous = made;
    return made;
}

} // namespace cdr::render
