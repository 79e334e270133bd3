#include "../support/shared_device.h"

#include <experiments/inspect/inspect.h>
#include <experiments/inspect/views.h>

#include <gtest/gtest.h>

#include <optional>
#include <utility>

namespace cdr::experiments_test {

using namespace experiments;

namespace {

using InspectTest = test::DeviceTest;

constexpr float kSlope = 0.6f;

/// Leans to the right.
scene::Mesh leaningSquare(float halfX, float halfY) {
    scene::Mesh mesh;
    for (const glm::vec2 corner : {glm::vec2(-halfX, -halfY), glm::vec2(halfX, -halfY),
                                   glm::vec2(halfX, halfY), glm::vec2(-halfX, halfY)}) {
        mesh.vertices.push_back(
            {.position = {corner.x, corner.y, kSlope * corner.x}, .normal = {0.0f, 0.0f, 1.0f}});
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.boundingRadius = scene::boundingRadiusOf(mesh.vertices);
    return mesh;
}

/// Two leaning squares of different outlines, the smaller one nearer by a gap.
scene::Scene squares(double gap) {
    scene::Scene scene;
    scene.materials.push_back({.name = "plain"});
    scene.meshes = {leaningSquare(9.1f, 11.0f), leaningSquare(16.9f, 15.3f)};
    scene::addInstance(scene, 0, 0, 0, {0.0, 0.0, gap - 37.3}, glm::mat3(1.0f));
    scene::addInstance(scene, 1, 0, 1, {0.0, 0.0, -37.3}, glm::mat3(1.0f));
    return scene;
}

Inspection inspect(const gpu::Device& device, const scene::Scene& scene, const InspectOptions& options) {
    const scene::Camera camera{.fovY = 0.9, .nearView = 0.1, .farView = 400.0};
    return runInspect(device, scene, {camera}, options, [](auto&&...) {});
}

/// Vertices that are rounded to a 16th of a pixel move a slope by far more than a depth is off.
TEST_F(InspectTest, RoundedVerticesCountInHowFarFacesAreToBeMoved) {
    InspectOptions options;
    options.drawing.width = 320;
    options.drawing.height = 180;
    options.drawing.snapBits = 4;
    options.techniques = {depth::namedTechnique("reversed"), depth::namedTechnique("anchored")};
    options.judged = depth::namedTechnique("anchored");
    const Inspection inPlane = inspect(device(), squares(0.0), options);
    ASSERT_GT(inPlane.coplanarPixels, 1000u);
    std::size_t judged = 0;
    for (const InspectedTechnique& technique : inPlane.techniques) {
        if (technique.technique.format != depth::DepthFormat::d32f) {
            continue;
        }
        ++judged;
        const double apart = technique.apart.at({0, 1});
        const Inspection moved = inspect(device(), squares(1.001 * apart), options);
        EXPECT_EQ(moved.coplanarPixels, 0u);
        const Inspection tooNear = inspect(device(), squares(0.19 * apart), options);
        for (std::size_t i = 0; i < moved.techniques.size(); ++i) {
            if (moved.techniques[i].technique == technique.technique) {
                EXPECT_EQ(moved.techniques[i].wrong.wrong, 0u) << technique.name << " " << apart;
                EXPECT_GT(tooNear.techniques[i].wrong.wrong, 100u) << technique.name;
                EXPECT_GT(tooNear.techniques[i].predictedWrong, 100.0) << technique.name;
            }
        }
    }
    EXPECT_EQ(judged, options.techniques.size());
    // Faces that move in their own planes need no more than depth does.
    options.drawing.snapping = render::Snapping::inPlane;
    const Inspection kept = inspect(device(), squares(0.0), options);
    EXPECT_LT(kept.techniques.back().apart.at({0, 1}), 0.1 * inPlane.techniques.back().apart.at({0, 1}));
}

TEST(InspectViews, HaveTheUpThatIsGiven) {
    const scene::Scene scene = squares(1.0);
    const scene::Camera own{.position = {3.0, -60.0, -20.0}};
    const glm::dvec3 z(0.0, 0.0, 1.0);
    const auto level = viewsAround(scene, own, 6, std::nullopt);
    const auto upright = viewsAround(scene, own, 6, z);
    ASSERT_EQ(upright.size(), 6u);
    EXPECT_EQ(upright[0], own);
    for (std::size_t i = 1; i < upright.size(); ++i) {
        EXPECT_NEAR(upright[i].right.z, 0.0, 1e-12) << i;
        EXPECT_GT(upright[i].up.z, 0.0) << i;
        EXPECT_NEAR(level[i].right.y, 0.0, 1e-12) << i;
        EXPECT_EQ(upright[i].position, level[i].position) << i;
        EXPECT_LT(glm::length(upright[i].back - level[i].back), 1e-12) << i;
    }
}

/// The step of 16 bits is twenty times the gap.
TEST_F(InspectTest, APixelInThePlaneOfADecalIsNotWrongToo) {
    InspectOptions options;
    options.drawing.width = 320;
    options.drawing.height = 180;
    options.techniques = {depth::namedTechnique("standard")};
    options.judged = depth::namedTechnique("standard");
    options.judged.technique.format = depth::DepthFormat::d16;
    scene::Scene scene = squares(0.01);
    const Inspection bare = inspect(device(), scene, options);
    EXPECT_EQ(bare.coplanarPixels, 0u);
    EXPECT_GT(bare.techniques[bare.judged].wrong.wrong, 1000u);
    // Over all of the nearer square.
    scene.materials.push_back({.name = "decal", .alphaMode = scene::AlphaMode::blend});
    scene::addInstance(scene, 0, 1, 2, scene.instances.position(0), glm::mat3(1.0f));
    const Inspection covered = inspect(device(), scene, options);
    EXPECT_GT(covered.coplanarPixels, 1000u);
    EXPECT_EQ(covered.techniques[covered.judged].wrong.wrong, 0u);
    EXPECT_EQ(covered.badFraction(), covered.coplanarFraction());
}

} // namespace

} // namespace cdr::experiments_test
