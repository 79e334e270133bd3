#include "views_drawer.h"

namespace cdr::options {

namespace {

using One = std::unique_ptr<render::Renderer>;
using Several = std::unique_ptr<render::ViewsRenderer>;

std::variant<One, Several> makeRenderer(const gpu::Device& device, const scene::Scene& scene,
                                        render::GpuScene& onDevice, const render::RenderOptions& options,
                                        std::size_t views) {
    if (views == 1) {
        return onDevice.isLive() ? std::make_unique<render::Renderer>(device, onDevice, options)
                                 : std::make_unique<render::Renderer>(device, scene, onDevice, options);
    }
    return onDevice.isLive()
               ? std::make_unique<render::ViewsRenderer>(device, onDevice, options, views)
               : std::make_unique<render::ViewsRenderer>(device, scene, onDevice, options, views);
}

} // namespace

ViewsDrawer::ViewsDrawer(const gpu::Device& device, const scene::Scene& scene, render::GpuScene& onDevice,
                         const render::RenderOptions& options, std::size_t views)
    : m_renderer(makeRenderer(device, scene, onDevice, options, views)) {}

render::Frame ViewsDrawer::render(const ViewsPlan& plan, const scene::Camera& camera,
                                  render::FrameCopy copy) {
    if (const auto* several = std::get_if<Several>(&m_renderer)) {
        return plan.join((*several)->render(plan.camerasOf(camera), copy), camera);
    }
    return std::get<One>(m_renderer)->render(camera, copy);
}

void ViewsDrawer::skip(const ViewsPlan& plan, const scene::Camera& camera) {
    if (const auto* several = std::get_if<Several>(&m_renderer)) {
        (*several)->skip(plan.camerasOf(camera));
    } else {
        std::get<One>(m_renderer)->skip(camera);
    }
}

void ViewsDrawer::forgetFrames() {
    std::visit([](const auto& renderer) { renderer->forgetFrames(); }, m_renderer);
}

} // namespace cdr::options
