#include "drawer.h"

#include <cdr/render/drawn_scene.h>

#include <utility>

namespace cdr::experiments {

Drawer::Drawer(std::unique_ptr<render::Renderer> renderer) : m_by(std::move(renderer)) {}

Drawer::Drawer(const gpu::Device& device, const render::GpuScene& scene, const rivals::Competing& competing,
               const vk::Extent2D& extent, platform::WorkerPool& workers)
    : m_by(std::make_unique<rivals::Contender>(device, render::DrawnScene{scene.scene(), scene.uploaded()},
                                               competing, extent, workers)) {}

DrawnFrame Drawer::render(const scene::Camera& camera) {
    if (const auto* alone = std::get_if<IdsAlone>(&m_by)) {
        rivals::Contender& contender = **alone;
        DrawnFrame drawn;
        drawn.ids = contender.render(camera).ids;
        drawn.cascades = contender.cascades();
        drawn.duplication = contender.duplication();
        return drawn;
    }
    render::Frame frame = renderer().render(camera);
    return {.ids = frame.ids(),
            .color = std::move(frame.color),
            .cascades = frame.cascades.size(),
            .duplication = frame.stats.duplication};
}

render::FrameStats Drawer::draw(const scene::Camera& camera) {
    return std::visit([&](const auto& by) { return by->draw(camera); }, m_by);
}

void Drawer::skip(const scene::Camera& camera) {
    if (shades()) {
        renderer().skip(camera);
    }
}

std::vector<NamedDrawer> makeDrawers(const gpu::Device& device, const render::GpuScene& scene,
                                     render::RenderOptions drawing,
                                     const std::vector<depth::NamedTechnique>& techniques,
                                     const std::vector<rivals::NamedRival>& rivalsBeside,
                                     platform::WorkerPool& workers) {
    std::vector<NamedDrawer> drawers;
    for (const auto& [name, technique] : techniques) {
        drawing.technique = technique;
        drawers.push_back(
            {name, Drawer(std::make_unique<render::Renderer>(device, scene.scene(), scene, drawing))});
    }
    for (const auto& [name, rival] : rivalsBeside) {
        drawers.push_back({name, Drawer(device, scene, rival, {drawing.width, drawing.height}, workers)});
    }
    return drawers;
}

} // namespace cdr::experiments
