#include <cdr/base/error.h>
#include <cdr/platform/stopwatch.h>
#include <cdr/render/draw_source.h>
#include <cdr/render/output/readback.h>

#include <rivals/atomic_pass.h>
#include <rivals/contender.h>
#include <rivals/depth_test_pass.h>

namespace cdr::rivals {

namespace {

const render::DrawnScene& requireComparable(const render::DrawnScene& scene) {
    for (const render::DrawKind& kind : scene.uploaded.kinds()) {
        if ((kind.variant & (render::kLayeredVariant | render::kMaskedVariant)) != 0) {
            throw base::InputError(
                "rivals draw ids and distances alone: a scene must have neither layer offsets nor masked materials");
        }
    }
    return scene;
}

/// Rivals do not cut the view.
depth::Technique cutOf(const Competing& competing) {
    const auto* technique = std::get_if<depth::Technique>(&competing);
    return technique != nullptr ? *technique : depth::Technique{.mapping = depth::Mapping::reversed};
}

std::unique_ptr<VisibilityPass> makePass(const gpu::Device& device, const Competing& competing,
                                         vk::Extent2D extent) {
    if (const auto* rival = std::get_if<Rival>(&competing)) {
        return std::make_unique<AtomicPass>(device, *rival, extent);
    }
    return std::make_unique<DepthTestPass>(device, std::get<depth::Technique>(competing), extent);
}

} // namespace

Contender::Contender(const gpu::Device& device, const render::DrawnScene& scene, const Competing& competing,
                     vk::Extent2D extent, platform::WorkerPool& workers)
    : m_device(device),
      m_draws(device, requireComparable(scene), cutOf(competing), extent, workers),
      m_pass(makePass(device, competing, extent)),
      m_pool(device, vk::CommandBufferLevel::ePrimary, "contender"),
      m_done(vk::Device(device.handle()).createFenceUnique({})) {}

FramePixels Contender::render(const scene::Camera& camera) {
    run(camera, Copy::surfaces);
    return m_pass->fetch(m_draws.view());
}

render::FrameStats Contender::run(const scene::Camera& camera, Copy copy) {
    render::FrameStats stats;
    m_draws.prepare(camera, stats);
    platform::Stopwatch watch;
    m_pool.reset();
    const vk::CommandBuffer commands = m_pool.next();
    commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    m_pass->record(commands, m_draws);
    if (copy == Copy::surfaces) {
        m_pass->recordReadback(commands);
        render::recordHostBarrier(commands);
    }
    commands.end();
    stats.times.recordMs = watch.lap();
    gpu::submit(m_device, {&commands, 1}, *m_done);
    gpu::waitAndReset(m_device, *m_done);
    stats.times.executeMs = watch.lap();
    return stats;
}

} // namespace cdr::rivals
