#include "scene_renderer.h"

#include "render_failure.h"

#include <cdr/base/error.h>
#include <cdr/gpu/memory.h>
#include <cdr/image/beside.h>
#include <viewer/state/view_picture.h>

#include <options/deform_choice.h>

#include <utility>

namespace cdr::viewer {

namespace {

options::ViewsPlan planOf(const RenderRequest& request, const render::RenderOptions& options) {
    return {request.settings.views, options.width, options.height};
}

/// Whether what was made for one mode is enough for another.
bool suffices(visibility::DetailMode made, visibility::DetailMode needed) {
    using visibility::DetailMode;
    return needed == DetailMode::none || (made != DetailMode::none && (made == DetailMode::perCluster) ==
                                                                          (needed == DetailMode::perCluster));
}

/// Whether a scene that was opened with some settings shows what others ask for, but for the layers of its materials.
bool isOpenedAlike(const ViewSettings& opened, const ViewSettings& asked) {
    return asked.scene == opened.scene && asked.openings == opened.openings && asked.seed == opened.seed &&
           asked.colours == opened.colours && asked.choice == opened.choice &&
           asked.deform == opened.deform && suffices(opened.drawing.detail.mode, asked.drawing.detail.mode);
}

/// Of a scene in which something moves, or whose materials have other layers than its own; else null.
std::unique_ptr<scenes::MovingScene> worldOf(const scene::SceneSetup& setup,
                                             const std::vector<scenes::LayerChoice>& layers,
                                             scenes::Deform deform) {
    if (!setup.motion && layers.empty()) {
        return nullptr;
    }
    const std::vector<float> ofMaterials = scenes::layersOf(setup.scene, layers);
    auto world = std::make_unique<scenes::MovingScene>(setup.scene, setup.motion, deform);
    world->setLayers(ofMaterials);
    return world;
}

FramesBefore framesBefore(const RenderRequest& request) {
    return request.isAtRest ? FramesBefore::forgotten : FramesBefore::kept;
}

} // namespace

scene::OpenedScene SceneRenderer::openNamed(const ViewSettings& settings) const {
    return scenes::openScene(settings.scene, settings.seed,
                             scenes::shownChoice(settings.scene, settings.choice),
                             [&](std::size_t done, std::size_t all) {
                                 m_tell({.file = settings.scene, .done = done, .all = all});
                             });
}

void SceneRenderer::open(const ViewSettings& settings) {
    if (m_scene != nullptr && isOpenedAlike(m_scene->settings, settings)) {
        followLayers(settings);
        return;
    }
    auto opened = std::make_shared<scene::OpenedScene>(openNamed(settings));
    scenes::paint(opened->setup.scene, settings.scene, settings.colours);
    platform::WorkerPool workers(settings.drawing.threads);
    visibility::prepareDetail(opened->setup.scene, settings.drawing.detail.mode, workers);
    const scene::SceneSetup& setup = opened->setup;
    auto moving = worldOf(setup, settings.layers, deformer(setup.motion, settings));
    render::GpuScene onDevice = moving != nullptr ? render::GpuScene(m_device, moving->world())
                                                  : render::GpuScene(m_device, setup.scene);
    auto next = std::make_unique<OpenScene>(
        OpenScene{.settings = settings,
                  .opened = opened,
                  .obstacles = std::make_shared<const Obstacles>(setup.scene, workers),
                  .moving = std::move(moving),
                  .onDevice = std::move(onDevice)});
    dropRenderers();
    m_scene = std::move(next);
}

scenes::Deform SceneRenderer::deformer(const scene::SceneMotion& motion, const ViewSettings& settings) const {
    if (motion.meshes.empty()) {
        return scenes::Deform::cpu;
    }
    return options::deformOn(m_device.info(), settings.deform, options::VertexReaders::drawing);
}

void SceneRenderer::followLayers(const ViewSettings& settings) {
    const std::vector<scenes::LayerChoice>& layers = settings.layers;
    if (layers == m_scene->settings.layers) {
        return;
    }
    const scene::SceneSetup& setup = m_scene->opened->setup;
    if (m_scene->moving != nullptr) {
        m_scene->moving->setLayers(scenes::layersOf(setup.scene, layers));
        clearFlips();
    } else {
        auto world = worldOf(setup, layers, deformer(setup.motion, settings));
        dropRenderers(); // their memory goes before more is asked for
        render::GpuScene onDevice(m_device, world->world());
        m_scene->moving = std::move(world);
        m_scene->onDevice = std::move(onDevice);
    }
    m_scene->settings.layers = layers;
}

void SceneRenderer::dropRenderers() {
    for (SideRenderer& side : m_sides) {
        side.drop();
    }
    m_reference.drop();
    clearFlips();
}

void SceneRenderer::clearFlips() {
    for (FlipWindow& flips : m_flips) {
        flips.clear();
    }
}

SceneOnDevice SceneRenderer::set() {
    return {.device = m_device, .scene = m_scene->opened->setup.scene, .onDevice = m_scene->onDevice};
}

SideResult SceneRenderer::renderSide(const RenderRequest& request, std::size_t side,
                                     const scene::Camera& camera) {
    const bool readsSurfaces = request.wantsSurfaces || request.settings.view != ViewKind::shaded;
    SideResult result{};
    result.options = renderOptions(request.settings, side, request.extent);
    result.frame = std::make_shared<const render::Frame>(m_sides.at(side).render(
        set(), result.options, planOf(request, result.options), camera,
        readsSurfaces ? render::FrameCopy::everything : render::FrameCopy::color, framesBefore(request)));
    result.timeline = timelineOf(m_sides.at(side).trace());
    return result;
}

render::Frame SceneRenderer::renderReference(const RenderRequest& request, const scene::Camera& camera) {
    render::RenderOptions options = renderOptions(request.settings, 0, request.extent);
    options.technique = referenceTechnique();
    return m_reference.render(set(), options, planOf(request, options), camera, render::FrameCopy::everything,
                              framesBefore(request));
}

/// A count that is only beside the picture must not cost the picture.
std::optional<render::Frame> SceneRenderer::renderReferenceIfItFits(const RenderRequest& request,
                                                                    const scene::Camera& camera) {
    try {
        return renderReference(request, camera);
    } catch (...) {
        explainFailure(); // no memory for its images, say
    }
    m_reference.drop();
    return std::nullopt;
}

void SceneRenderer::paint(ViewKind view, std::size_t side, const render::Frame* reference,
                          SideResult& result) {
    const render::Frame& frame = *result.frame;
    if (reference != nullptr && view != ViewKind::wrong) {
        result.wrong = countWrong(frame, *reference);
    }
    if (view == ViewKind::shaded) {
        result.picture = std::shared_ptr<const image::ImageRgba8>(result.frame, &frame.color);
        return;
    }
    auto picture = std::make_shared<image::ImageRgba8>();
    if (view == ViewKind::wrong) {
        result.wrong = paintWrong(frame, *reference, *picture);
    } else if (view == ViewKind::flips) {
        FlipWindow& flips = m_flips.at(side);
        flips.add(frame, *reference, std::chrono::duration<double>(Clock::now() - m_start).count());
        flips.paint(frame, *picture);
        result.flipsNow = flips.flipsNow();
        result.flippedPixels = flips.pixelsInWindow();
    } else {
        paintView(frame, view, *picture);
    }
    result.picture = std::move(picture);
}

void SceneRenderer::move(const RenderRequest& request, platform::WorkerPool& workers) {
    if (m_scene->moving == nullptr) {
        return;
    }
    const scene::World& world = m_scene->moving->world();
    const std::span<const std::uint32_t> meshes = m_scene->moving->deformedMeshes();
    if (m_scene->moving->show(request.frame, workers)) {
        m_scene->areObstaclesBent = world.posedMeshes().empty(); // else the scene lacks their vertices
        m_scene->obstacles = std::make_shared<const Obstacles>(m_scene->obstacles->moved(
            world.scene(), m_scene->areObstaclesBent ? meshes : meshes.first(0), workers));
    }
    if (request.isSteered && !m_scene->areObstaclesBent) {
        m_scene->obstacles = std::make_shared<const Obstacles>(m_scene->obstacles->bent(
            meshes, m_scene->opened->setup.motion.vertices(request.frame, workers), workers));
        m_scene->areObstaclesBent = true;
    }
}

RenderResult SceneRenderer::answer(const RenderRequest& request, const std::stop_token& stop) {
    open(request.settings);
    const auto begin = Clock::now();
    const auto millisecondsSince = [](Clock::time_point from) {
        return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
    };
    RenderResult result{.serial = request.serial,
                        .sceneName = m_scene->settings.scene,
                        .settings = request.settings,
                        .scene = m_scene->opened};
    result.frame = request.frame;
    platform::WorkerPool workers(request.settings.drawing.threads);
    move(request, workers);
    result.obstacles = m_scene->obstacles;
    result.camera = request.camera ? *request.camera : m_scene->opened->setup.path.at(0);
    const std::size_t sides = request.settings.second ? 2 : 1;
    for (std::size_t side = 0; side < sides; ++side) {
        if (stop.stop_requested()) {
            return {.serial = request.serial, .failure = RenderFailure{.message = "stopped", .error = {}}};
        }
        result.sides.push_back(renderSide(request, side, result.camera));
    }
    if (sides < m_sides.size()) {
        m_sides.back().drop();
    }
    if (request.settings.view != ViewKind::flips) {
        clearFlips();
    }
    std::optional<render::Frame> reference;
    if (needsReference(request.settings.view)) {
        reference = renderReference(request, result.camera);
    } else if (request.countsWrong) {
        reference = renderReferenceIfItFits(request, result.camera);
    }
    const auto painted = Clock::now();
    for (std::size_t side = 0; side < sides; ++side) {
        paint(request.settings.view, side, reference ? &*reference : nullptr, result.sides[side]);
        if (planOf(request, result.sides[side].options).isAnaglyph()) {
            result.sides[side].picture =
                std::make_shared<const image::ImageRgba8>(image::anaglyphOf(*result.sides[side].picture));
        }
    }
    result.compositeMs = millisecondsSince(painted);
    result.frameMs = millisecondsSince(begin);
    result.freeDeviceBytes = gpu::freeDeviceBytes(m_device);
    return result;
}

} // namespace cdr::viewer
