#include <cdr/render/frame_split.h>

#include <cmath>

namespace cdr::render {

const depth::Cascades& FrameSplit::fit(const depth::SplitFitted& split, const scene::Camera& camera,
                                       const visibility::VisibleList& visible) {
    m_intervals.resize(visible.count);
    for (std::size_t i = 0; i < visible.count; ++i) {
        const auto radius = static_cast<double>(visible.radius[i]);
        m_intervals[i] = {visible.distanceView[i] - radius, visible.distanceView[i] + radius};
    }
    const depth::FitView view{.model = {m_technique.mapping, m_technique.format},
                              .nearView = camera.nearView,
                              .farView = camera.farView,
                              .footprintSlope = 2.0 * std::tan(0.5 * camera.fovY) / m_height};
    m_fitted = depth::fitCascades(split, view, m_intervals, m_fitted);
    return m_fitted;
}

depth::Cascades FrameSplit::cut(const scene::Camera& camera, const visibility::VisibleList& visible) {
    if (const auto* fitted = std::get_if<depth::SplitFitted>(&m_technique.split)) {
        return fit(*fitted, camera, visible);
    }
    if (const auto* minimax = std::get_if<depth::SplitMinimax>(&m_technique.split)) {
        return depth::minimaxCascades(*minimax, {m_technique.mapping, m_technique.format}, camera.nearView,
                                      camera.farView);
    }
    return depth::makeCascades(m_technique.split, camera.nearView, camera.farView);
}

} // namespace cdr::render
