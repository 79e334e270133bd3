#include "side_renderer.h"

namespace cdr::viewer {

namespace {

bool fits(const render::RenderOptions& made, const render::RenderOptions& wanted) {
    return made.width == wanted.width && made.height == wanted.height && made.technique == wanted.technique &&
           made.targets == wanted.targets && made.threads == wanted.threads &&
           made.submission == wanted.submission && made.batching == wanted.batching &&
           made.detail.mode == wanted.detail.mode && made.translucency.method == wanted.translucency.method &&
           made.effects == wanted.effects && made.focus == wanted.focus;
}

} // namespace

render::Frame SideRenderer::render(const SceneOnDevice& set, render::RenderOptions options,
                                   const scene::Camera& camera, render::FrameCopy copy, bool forgets) {
    if (m_renderer == nullptr || !fits(m_renderer->options(), options)) {
        m_renderer.reset(); // its memory goes before that of the next is asked for
        m_trace = std::make_unique<host::Trace>(options.threads);
        options.trace = m_trace.get();
        m_renderer = std::make_unique<render::Renderer>(set.device, set.scene, set.onDevice, options);
    }
    if (forgets) {
        m_renderer->forgetFrames();
    }
    m_trace->forget();
    m_trace->beginFrame("frame");
    return m_renderer->render(camera, copy);
}

} // namespace cdr::viewer
