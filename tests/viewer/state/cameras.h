#pragma once

#include <cdr/scene/camera.h>
#include <viewer/state/camera/camera_input.h>

#include <gtest/gtest.h>

#include <cmath>

namespace cdr::viewer_test {

inline void expectSame(const scene::Camera& a, const scene::Camera& b) {
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.right, b.right);
    EXPECT_EQ(a.up, b.up);
    EXPECT_EQ(a.back, b.back);
    EXPECT_EQ(a.fovY, b.fovY);
}

/// Orthonormal, and with the horizon level.
inline void expectLevel(const scene::Camera& camera) {
    EXPECT_NEAR(glm::length(camera.back), 1.0, 1e-14);
    EXPECT_NEAR(glm::length(camera.right), 1.0, 1e-14);
    EXPECT_NEAR(glm::length(camera.up), 1.0, 1e-14);
    EXPECT_NEAR(glm::dot(camera.back, camera.right), 0.0, 1e-14);
    EXPECT_NEAR(camera.right.y, 0.0, 1e-14);
    EXPECT_GE(camera.up.y, 0.0);
}

/// Where a point is seen: pixels from the picture's top left corner.
inline glm::dvec2 pixelOf(const scene::Camera& camera, const glm::dvec3& world,
                          const viewer::PictureExtent& extent) {
    const glm::dvec3 view = camera.toView(world);
    const double perSlope = 0.5 * extent.height / std::tan(0.5 * camera.fovY);
    return {0.5 * extent.width + perSlope * view.x / -view.z,
            0.5 * extent.height - perSlope * view.y / -view.z};
}

inline scene::Camera cameraWith(double fovDegrees, const glm::dvec3& eye, const glm::dvec3& target) {
    return scene::lookAt({.fovY = scene::radiansOf(fovDegrees), .nearView = 0.001, .farView = 1e9}, eye,
                         target);
}

} // namespace cdr::viewer_test
