#include <cdr/render/frame_split.h>

#include <algorithm>
#include <iterator>

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
    // What no camera sees must not make cascades finer: the thinnest interval decides how fine they are.
    std::ranges::copy_if(occupied, std::back_inserter(m_intervals), [&](const depth::Interval& interval) {
        return interval.farView >= camera.nearView && interval.nearView <= camera.farView;
    });
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
