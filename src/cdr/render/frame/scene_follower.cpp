#include <cdr/base/error.h>
#include <cdr/render/choose_facets.h>
#include <cdr/render/frame/scene_follower.h>
#include <cdr/render/submit/draw_path_factory.h>

namespace cdr::render {

namespace {

void requireOn(const gpu::Device& device, const GpuScene& gpuScene) {
    if (gpuScene.uploaded().device().handle() != device.handle()) {
        throw base::InputError("the GpuScene is on another device than the renderer");
    }
}

const UploadedScene& fixed(const gpu::Device& device, const GpuScene& gpuScene, const scene::Scene& scene) {
    if (gpuScene.isLive()) {
        throw base::InputError(
            "the scene of a world changes: give its GpuScene to the renderer without its scene");
    }
    if (&gpuScene.scene() != &scene) {
        throw base::InputError("the GpuScene was made of another scene than the renderer is to draw");
    }
    requireOn(device, gpuScene);
    return gpuScene.uploaded();
}

const UploadedScene& updated(const gpu::Device& device, GpuScene& live) {
    requireOn(device, live);
    live.update();
    return live.uploaded();
}

} // namespace

SceneFollower::SceneFollower(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene)
    : m_live(nullptr),
      m_drawn{.scene = scene, .uploaded = fixed(device, gpuScene, scene)},
      m_revision(gpuScene.revision()) {}

SceneFollower::SceneFollower(const gpu::Device& device, GpuScene& live)
    : m_live(&live),
      m_drawn{.scene = live.scene(), .uploaded = updated(device, live)},
      m_revision(live.revision()) {}

void SceneFollower::keepLastVertices() {
    if (m_live != nullptr) {
        m_lastVertices = m_live->uploaded().keepLastVertices();
    }
}

void SceneFollower::update() {
    if (m_live != nullptr) {
        m_live->update();
    }
}

void SceneFollower::followFacets(DrawPathFactory& paths, const RenderOptions& options) {
    // Lights change without a new revision, and whether facets can be lit while they are drawn depends on them.
    const bool mayHaveChanged = isChanged() || options.surface == SurfacePath::lit;
    if (!mayHaveChanged || paths.facets() == nullptr) {
        return;
    }
    const FacetsMadeFrom now{m_drawn.uploaded.meshesRevision(), m_drawn.uploaded.kinds().size()};
    if (m_facetsMadeFrom == now) {
        requireFacets(m_drawn, options, *paths.facets());
        return;
    }
    paths.setFacets(*chooseFacets(m_drawn, options));
    m_facetsMadeFrom = now;
}

} // namespace cdr::render
