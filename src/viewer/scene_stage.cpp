#include "scene_stage.h"

#include <chrono>
#include <utility>

namespace cdr::viewer {

namespace {

bool isSameTechnique(const depth::Technique& a, const depth::Technique& b) {
    return a.mapping == b.mapping && a.split == b.split && a.format == b.format;
}

bool fits(const render::RenderOptions& made, const render::RenderOptions& wanted) {
    return made.width == wanted.width && made.height == wanted.height &&
           isSameTechnique(made.technique, wanted.technique) && made.targets == wanted.targets &&
           made.threads == wanted.threads && made.submission == wanted.submission &&
           made.batching == wanted.batching && made.trace == wanted.trace;
}

} // namespace

render::Frame SideRenderer::render(const gpu::Device& device, const scene::Scene& scene,
                                   const render::GpuScene& onDevice, const render::RenderOptions& options,
                                   const scene::Camera& camera, render::FrameCopy copy) {
    if (m_renderer == nullptr || !fits(m_renderer->options(), options)) {
        m_renderer.reset(); // its memory goes before that of the next is asked for
        m_renderer = std::make_unique<render::Renderer>(device, scene, onDevice, options);
    }
    return m_renderer->render(camera, copy);
}

void SceneStage::open(const RenderRequest& request) {
    if (m_scene != nullptr && request.scene == m_sceneName) {
        return;
    }
    auto opened = std::make_shared<const scene::OpenedScene>(scene::openScene(request.scene, request.seed));
    auto next = std::make_unique<OnStage>(
        OnStage{opened, render::GpuScene(m_device, opened->staged.scene)});
    for (SideRenderer& side : m_sides) {
        side.drop();
    }
    m_scene = std::move(next);
    m_sceneName = request.scene;
}

RenderResult SceneStage::answer(const RenderRequest& request) {
    open(request);
    const auto begin = std::chrono::steady_clock::now();
    const scene::StagedScene& staged = m_scene->opened->staged;
    const scene::Camera camera = request.camera ? *request.camera : staged.path.at(0);
    RenderResult result{.serial = request.serial, .sceneName = m_sceneName, .scene = m_scene->opened};
    for (std::size_t i = 0; i < request.sides.size(); ++i) {
        auto frame = std::make_shared<render::Frame>(
            m_sides.at(i).render(m_device, staged.scene, m_scene->onDevice, request.sides[i], camera,
                                 render::FrameCopy::everything));
        SideResult& side = result.sides.emplace_back();
        side.options = request.sides[i];
        side.picture = std::shared_ptr<const image::ImageRgba8>(frame, &frame->color);
        side.frame = std::move(frame);
    }
    for (std::size_t i = request.sides.size(); i < m_sides.size(); ++i) {
        m_sides[i].drop();
    }
    result.frameMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

} // namespace cdr::viewer
