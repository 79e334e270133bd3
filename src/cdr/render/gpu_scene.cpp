#include <cdr/render/gpu_scene.h>
#include <cdr/render/uploaded_scene.h>

namespace cdr::render {

GpuScene::GpuScene(const gpu::Device& device, const scene::Scene& scene, std::size_t threads)
    : m_uploaded((scene::requireUsable(scene), std::make_unique<UploadedScene>(device, scene, threads))) {}

GpuScene::GpuScene(const gpu::Device& device, const scene::World& world, std::size_t threads)
    : m_uploaded(std::make_unique<UploadedScene>(device, world, threads)) {}

GpuScene::~GpuScene() = default;
GpuScene::GpuScene(GpuScene&&) noexcept = default;
GpuScene& GpuScene::operator=(GpuScene&&) noexcept = default;

void GpuScene::update() {
    m_uploaded->update();
}

const scene::Scene& GpuScene::scene() const {
    return m_uploaded->scene();
}

bool GpuScene::isLive() const {
    return m_uploaded->isLive();
}

bool GpuScene::isCurrent() const {
    return m_uploaded->isCurrent();
}

std::uint64_t GpuScene::revision() const {
    return m_uploaded->revision();
}

} // namespace cdr::render
