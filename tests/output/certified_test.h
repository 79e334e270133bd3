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

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace cdr::test {

/// Pixels, edges included, whose object is not the true one.
inline std::uint64_t wrongIn(const render::Frame& frame, const measure::TruthImage& truth) {
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        wrong += truth.pixels[i].id != frame.gbuffer.pixels[i].id() ? 1 : 0;
    }
    return wrong;
}

/// Repairs a frame by its certificate, and expects of each repaired pixel what its repair has.
inline void repairFrame(render::Frame& frame, const measure::Certificate& certificate) {
    output::putRight(frame, certificate);
    for (const measure::PixelRepair& repair : certificate.repairs) {
        SCOPED_TRACE(std::to_string(repair.x) + " " + std::to_string(repair.y));
        EXPECT_EQ(frame.color.at(repair.x, repair.y), repair.color);
        const std::optional<render::Pick> pick = frame.pick(repair.x, repair.y);
        ASSERT_EQ(pick.has_value(), repair.id != 0);
        if (pick) {
            EXPECT_EQ(pick->object + 1, repair.id);
            const double anchorView = frame.anchorsView[frame.cascade(repair.x, repair.y)];
            const double step =
                0x1p-24 * std::abs(repair.distanceView - anchorView) + 0x1p-50 * repair.distanceView;
            EXPECT_NEAR(pick->distanceView, repair.distanceView, step);
            EXPECT_LT(glm::distance(pick->normal, repair.normal), 1e-4); // 16 bits a component
        }
    }
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
        repairFrame(frame, certificate);
        return wrongIn(frame, measure::castTruth(scene, camera, frame.width(), frame.height(), m_workers));
    }

    platform::WorkerPool m_workers{2};
};

} // namespace cdr::test
