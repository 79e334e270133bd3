#pragma once

#include <cdr/measure/certify/certifier.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/render/frame.h>
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

/// Repairs a frame by its certificate. @return wrongIn() then, by the truth of a scene.
inline std::uint64_t wrongAfterRepair(render::Frame& frame, const measure::Certificate& certificate,
                                      const scene::Scene& scene, const scene::Camera& camera,
                                      platform::WorkerPool& workers) {
    output::putRight(frame, certificate);
    return wrongIn(frame, measure::castTruth(scene, camera, frame.width(), frame.height(), workers));
}

} // namespace cdr::test
