#include <cdr/render/frame/frame_output.h>
#include <cdr/render/frame/frame_runner.h>
#include <cdr/render/renderer.h>

namespace cdr::render {

Renderer::Renderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
                   const RenderOptions& options)
    : m_frames(std::make_unique<FrameRunner>(device, SceneFollower(device, scene, gpuScene), options)) {}

Renderer::Renderer(const gpu::Device& device, GpuScene& live, const RenderOptions& options)
    : m_frames(std::make_unique<FrameRunner>(device, SceneFollower(device, live), options)) {}

Renderer::~Renderer() = default;

Frame Renderer::render(const scene::Camera& camera, FrameCopy copy) {
    FrameSlot& slot = m_frames->run(camera, {.copy = copy, .awaited = Awaited::yes});
    m_frames->waitFor(slot);
    return fetch(m_frames->passes(), slot);
}

void Renderer::skip(const scene::Camera& camera) {
    m_frames->skip(camera);
}

void Renderer::forgetFrames() {
    m_frames->decider().forgetFrames();
}

FrameStats Renderer::draw(const scene::Camera& camera) {
    FrameSlot& slot = m_frames->run(camera, {.awaited = Awaited::yes});
    m_frames->waitFor(slot);
    return slot.stats;
}

void Renderer::submit(const scene::Camera& camera, const FrameSync& sync) {
    m_frames->run(camera, {.sync = sync});
}

void Renderer::record(const scene::Camera& camera, const HostFrame& frame) {
    m_frames->slots().keepRecorded(); // the frame before was submitted
    m_frames->requireRecordable(frame);
    m_frames->run(camera, {.host = &frame});
}

void Renderer::dropRecorded() {
    m_frames->dropRecorded();
}

void Renderer::finish() {
    m_frames->finish();
}

Surfaces Renderer::surfaces() const {
    m_frames->nameSurfaces();
    return surfacesOf(m_frames->passes(), m_frames->slots().last());
}

FrameStats Renderer::lastStats() const {
    return m_frames->slots().lastStats();
}

void Renderer::resize(std::uint32_t width, std::uint32_t height) {
    m_frames->take(m_frames->resized(width, height));
}

const RenderOptions& Renderer::options() const {
    return m_frames->options();
}

} // namespace cdr::render
