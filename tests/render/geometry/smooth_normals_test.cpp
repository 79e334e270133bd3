#include "../fixture.h"

#include <cmath>

namespace cdr::render_test {
namespace {

using SmoothNormalsTest = RenderTest;

/// As truth and importers have it: weights of three unit normals. As octahedra they are of unlike lengths.
TEST_F(SmoothNormalsTest, AreInterpolatedByTheirDirectionsAlone) {
    scene::Scene scene = boxScene();
    const glm::dvec3 leaning = glm::normalize(glm::dvec3(1.0, 1.0, 1.0));
    scene::Mesh& mesh = scene.meshes.front();
    mesh = {};
    mesh.name = "triangle";
    mesh.vertices = {{.position = {-1.0f, -1.0f, 0.0f}, .normal = {0.0f, 0.0f, 1.0f}},
                     {.position = {1.0f, -1.0f, 0.0f}, .normal = leaning},
                     {.position = {-1.0f, 1.0f, 0.0f}, .normal = {0.0f, 0.0f, 1.0f}}};
    mesh.indices = {0, 1, 2};
    mesh.boundingRadius = 1.5f;
    constexpr double kAway = 3.0;
    scene::addInstance(scene, 0, 0, 7, {0.0, 0.0, -kAway}, glm::mat3(1.0f));
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 10.0};
    const render::Frame frame = draw(scene, camera, smallOptions(depth::parseTechnique("anchored"), 160, 90));
    std::size_t pixels = 0;
    for (std::uint32_t y = 0; y < frame.height(); ++y) {
        for (std::uint32_t x = 0; x < frame.width(); ++x) {
            const auto pick = frame.pick(x, y);
            if (!pick) {
                continue;
            }
            ++pixels;
            const double halfView = kAway * std::tan(0.5 * camera.fovY);
            const double right = halfView * (2.0 * (x + 0.5) - 160.0) / 90.0;
            const double second = 0.5 * (right + 1.0);
            const glm::dvec3 expected =
                glm::normalize(second * leaning + (1.0 - second) * glm::dvec3(0.0, 0.0, 1.0));
            EXPECT_GT(glm::dot(glm::dvec3(pick->normal), expected), std::cos(2e-3)) << x << ", " << y;
        }
    }
    EXPECT_GT(pixels, 1000u);
}

} // namespace
} // namespace cdr::render_test
