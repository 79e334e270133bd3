#include "side_renderer.h"

namespace cdr::viewer {

render::Frame SideRenderer::render(const SceneOnDevice& set, render::RenderOptions options,
                                   const options::ViewsPlan& plan, const scene::Camera& camera,
                                   render::FrameCopy copy, FramesBefore before) {
    const std::size_t views = plan.count();
    if (m_drawer == nullptr || m_asked != options || m_viewsAsked != views) {
        m_drawer.reset(); // its memory goes before that of the next is asked for
        m_asked = options;
        m_viewsAsked = views;
        m_trace = std::make_unique<platform::Trace>(options.threads);
        options.trace = m_trace.get();
        m_drawer =
            std::make_unique<options::ViewsDrawer>(set.device, set.scene, set.onDevice, options, views);
    }
    if (before == FramesBefore::forgotten) {
        m_drawer->forgetFrames();
    }
    m_trace->forget();
    m_trace->beginFrame("frame");
    return m_drawer->render(plan, camera, copy);
}

} // namespace cdr::viewer
