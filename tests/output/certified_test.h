#pragma once

#include "../support/shared_device.h"

#include <cdr/measure/certify/certifier.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/renderer.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <output/certified_frame.h>

#include <cstddef>
#include <cstdint>

namespace cdr::test {

/// Pixels, edges included, whose object is not the true one.
inline std::uint64_t wrongIn(const render::Frame& frame, const measure::TruthImage& truth) {
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        wrong += truth.pixels[i].id != frame.gbuffer.pixels[i].id() ? 1 : 0;
    }
    return wrong;
}

/// Certifies frames that the device draws.
class CertifiedTest : public DeviceTest {
  protected:
    render::Frame draw(const scene::Scene& scene, const scene::Camera& camera,
                       const render::RenderOptions& options) {
        const render::GpuScene onDevice(device(), scene);
        return render::Renderer(device(), scene, onDevice, options).render(camera);
    }

    measure::Certificate certificateOf(const render::Frame& frame, const render::RenderOptions& options,
                                       const measure::Certifier& certifier, platform::WorkerPool& workers) {
        return certifier.certify(output::drawnFrame(frame, options, device().info().subPixelBits), workers);
    }

    /// Repairs a frame by its certificate. @return wrongIn() then, by the truth of a scene.
    std::uint64_t wrongAfterRepair(render::Frame& frame, const measure::Certificate& certificate,
                                   const scene::Scene& scene, const scene::Camera& camera) {
        output::putRight(frame, certificate);
        return wrongIn(frame, measure::castTruth(scene, camera, frame.width(), frame.height(), m_workers));
    }

    platform::WorkerPool m_workers{2};
};

} // namespace cdr::test
