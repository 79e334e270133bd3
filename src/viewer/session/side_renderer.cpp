#include "side_renderer.h"

namespace cdr::viewer {

void SideRenderer::drop() {
    m_renderer.reset();
    m_views.reset();
}

void SideRenderer::make(const SceneOnDevice& set, const render::RenderOptions& options, std::size_t views) {
    const bool isLive = set.onDevice.isLive();
    if (views == 1 && isLive) {
        m_renderer = std::make_unique<render::Renderer>(set.device, set.onDevice, options);
    } else if (views == 1) {
        m_renderer = std::make_unique<render::Renderer>(set.device, set.scene, set.onDevice, options);
    } else if (isLive) {
        m_views = std::make_unique<render::ViewsRenderer>(set.device, set.onDevice, options, views);
    } else {
        m_views =
            std::make_unique<render::ViewsRenderer>(set.device, set.scene, set.onDevice, options, views);
    }
}

render::Frame SideRenderer::render(const SceneOnDevice& set, render::RenderOptions options,
                                   const experiments::ViewsPlan& plan, const scene::Camera& camera,
                                   render::FrameCopy copy, bool forgets) {
    const std::size_t views = plan.count();
    const bool isMade = m_renderer != nullptr || m_views != nullptr;
    if (!isMade || m_asked != options || m_viewsAsked != views) {
        drop(); // its memory goes before that of the next is asked for
        m_asked = options;
        m_viewsAsked = views;
        m_trace = std::make_unique<host::Trace>(options.threads);
        options.trace = m_trace.get();
        make(set, options, views);
    }
    m_trace->forget();
    m_trace->beginFrame("frame");
    if (m_views == nullptr) {
        if (forgets) {
            m_renderer->forgetFrames();
        }
        return m_renderer->render(camera, copy);
    }
    if (forgets) {
        m_views->forgetFrames();
    }
    return plan.join(m_views->render(plan.camerasOf(camera), copy), camera);
}

} // namespace cdr::viewer
