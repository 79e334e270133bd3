#include "side_renderer.h"

namespace cdr::viewer {

render::Frame SideRenderer::render(const SceneOnDevice& set, render::RenderOptions options,
                                   const scene::Camera& camera, render::FrameCopy copy, bool forgets) {
    if (m_renderer == nullptr || m_asked != options) {
        m_renderer.reset(); // its memory goes before that of the next is asked for
        m_asked = options;
        m_trace = std::make_unique<host::Trace>(options.threads);
        options.trace = m_trace.get();
        m_renderer = set.onDevice.isLive()
                         ? std::make_unique<render::Renderer>(set.device, set.onDevice, options)
                         : std::make_unique<render::Renderer>(set.device, set.scene, set.onDevice, options);
    }
    if (forgets) {
        m_renderer->forgetFrames();
    }
    m_trace->forget();
    m_trace->beginFrame("frame");
    return m_renderer->render(camera, copy);
}

} // namespace cdr::viewer
