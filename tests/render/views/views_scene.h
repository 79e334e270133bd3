#pragma once

#include "../fixture.h"

#include <cdr/scene/stereo_rig.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace cdr::render_test {

inline constexpr std::uint32_t kViewsWidth = 128;
inline constexpr std::uint32_t kViewsHeight = 72;

/// Boxes near and far, some of them at the edges of one eye's picture only. The floor below reaches beyond near and far. So
/// any camera fits the same cascades to it.
inline scene::Scene floorAndBoxes() {
    scene::Scene scene = boxScene();
    addBox(scene, glm::dvec3(0.0, -5'001.0, 0.0), glm::mat3(10'000.0f));
    for (int ring = 0; ring < 6; ++ring) {
        const double w = 3.0 * std::pow(2.5, ring);
        for (int column = -4; column <= 4; ++column) {
            addBox(scene, glm::dvec3(0.26 * column * w, 0.05 * w * (ring % 3), -w),
                   glm::mat3(static_cast<float>(0.1 * w)));
        }
    }
    for (int column = -60; column <= 60; ++column) { // so close that some are in one eye's view alone
        addBox(scene, glm::dvec3(0.1 * column, 0.3, -3.0), glm::mat3(0.05f));
    }
    return scene;
}

inline scene::StereoRig rigOf(scene::StereoMode mode) {
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 500.0};
    return {.centre = scene::lookAlong(camera, {0.3, 0.4, 1.0}, {0.1, -0.05, -1.0}),
            .eyeDistance = 0.9,
            .convergence = 8.0,
            .mode = mode};
}

/// Its cameras, once it has moved ahead.
inline std::vector<scene::Camera> bothEyes(scene::StereoMode mode = scene::StereoMode::parallel,
                                           double ahead = 0.0) {
    scene::StereoRig rig = rigOf(mode);
    rig.centre.position -= ahead * rig.centre.back;
    const auto eyes = eyesOf(rig);
    return {eyes.begin(), eyes.end()};
}

} // namespace cdr::render_test
