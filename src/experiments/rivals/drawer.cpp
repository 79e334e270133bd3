#include "drawer.h"

#include <utility>

namespace cdr::experiments {

Drawer::Drawer(std::unique_ptr<render::Renderer> renderer) : m_renderer(std::move(renderer)) {}

Drawer::Drawer(const gpu::Device& device, const render::DrawnScene& scene, const rivals::Competing& competing,
               const vk::Extent2D& extent, host::WorkerPool& workers)
    : m_contender(std::make_unique<rivals::Contender>(device, scene, competing, extent, workers)) {}

DrawnFrame Drawer::render(const scene::Camera& camera) {
    if (!shades()) {
        DrawnFrame drawn;
        drawn.ids = m_contender->render(camera).ids;
        drawn.cascades = m_contender->cascades();
        drawn.duplication = m_contender->duplication();
        return drawn;
    }
    render::Frame frame = m_renderer->render(camera);
    return {.ids = frame.ids(),
            .color = std::move(frame.color),
            .cascades = frame.cascades.size(),
            .duplication = frame.stats.duplication};
}

render::FrameStats Drawer::draw(const scene::Camera& camera) {
    return shades() ? m_renderer->draw(camera) : m_contender->draw(camera);
}

void Drawer::skip(const scene::Camera& camera) {
    if (shades()) {
        m_renderer->skip(camera);
    }
}

} // namespace cdr::experiments
