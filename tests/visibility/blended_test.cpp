#include <cdr/depth/make_cascades.h>
#include <cdr/visibility/blended.h>
#include <cdr/visibility/cull.h>
#include <scenes/sheets.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace cdr::visibility {

using namespace scene;
using namespace scenes;

namespace {

TEST(Blended, InstancesAreSplitByMaterial) {
    const SceneSetup setup = makeSheets(7, 40);
    const Scene& scene = setup.scene;
    ASSERT_TRUE(hasBlended(scene));
    const BlendedInstances blended = blendedInstances(scene);
    EXPECT_EQ(blended.instances.size(), 40u);
    EXPECT_TRUE(std::is_sorted(blended.source.begin(), blended.source.end()));
    for (std::size_t i = 0; i < blended.instances.size(); ++i) {
        EXPECT_LT(blended.instances.object[i], 40u);
        EXPECT_EQ(blended.instances.object[i], scene.instances.object[blended.source[i]]);
        EXPECT_EQ(blended.instances.position(i), scene.instances.position(blended.source[i]));
    }
    const Instances opaque = withoutBlended(scene);
    ASSERT_EQ(opaque.size(), scene.instances.size());
    host::WorkerPool workers(1);
    VisibleList visible;
    cullSpheres(opaque, setup.path.at(0), 16.0 / 9.0, workers, visible);
    EXPECT_GT(visible.count, 10u);
    for (std::size_t i = 0; i < visible.count; ++i) {
        EXPECT_GE(opaque.object[visible.instance[i]], 40u); // of the opaque ones
    }
}

TEST(Blended, MasksAndOpaqueMaterialsAreNot) {
    Scene scene;
    scene.meshes.push_back(makeSquare(1.0f));
    scene.materials.push_back({.name = "mask", .alphaMode = AlphaMode::mask});
    scene.materials.push_back({.name = "unused", .alphaMode = AlphaMode::blend});
    addInstance(scene, 0, 0, 0, glm::dvec3(0.0), glm::mat3(1.0f));
    EXPECT_FALSE(hasBlended(scene));
    EXPECT_EQ(blendedInstances(scene).instances.size(), 0u);
}

/// Whether a boundary lies between the nearest and the farthest vertex.
bool crosses(const Scene& scene, const Instances& instances, std::size_t i, const Camera& camera,
             double boundaryView) {
    bool isBefore = false;
    bool isBeyond = false;
    for (const Vertex& vertex : scene.meshes[instances.mesh[i]].vertices) {
        const glm::dvec3 offset = glm::dmat3(instances.basis[i]) * glm::dvec3(vertex.position);
        const double w = camera.viewDistance(instances.position(i) + offset);
        isBefore |= w < boundaryView;
        isBeyond |= w > boundaryView;
    }
    return isBefore && isBeyond;
}

/// What the experiments rest on: sheets cross every boundary of 2 to 8 even cascades.
TEST(Sheets, CrossEveryBoundary) {
    const SceneSetup setup = makeSheets(2013);
    const Camera camera = setup.path.at(0);
    const Instances sheets = blendedInstances(setup.scene).instances;
    for (unsigned count = 2; count <= 8; ++count) {
        const depth::Cascades cascades = depth::makeCascades(
            depth::SplitCount{count}, {.nearView = camera.nearView, .farView = camera.farView});
        for (std::size_t boundary = 1; boundary < count; ++boundary) {
            int crossings = 0;
            for (std::size_t i = 0; i < sheets.size(); ++i) {
                crossings += crosses(setup.scene, sheets, i, camera, cascades[boundary].nearView) ? 1 : 0;
            }
            EXPECT_GE(crossings, 2) << count << " cascades, boundary " << boundary;
        }
    }
}

TEST(Sheets, AreOfEveryKindAndTheSameForASeed) {
    const Scene scene = makeSheets(2013).scene;
    const auto has = [&](auto predicate) {
        return std::any_of(scene.instances.material.begin(), scene.instances.material.end(),
                           [&](std::uint32_t material) { return predicate(scene.materials[material]); });
    };
    EXPECT_TRUE(has([](const Material& m) { return m.baseColorTexture.has_value(); }));
    EXPECT_TRUE(has([](const Material& m) { return m.unlit && m.alphaMode == AlphaMode::blend; }));
    EXPECT_TRUE(has([](const Material& m) { return !m.doubleSided && m.alphaMode == AlphaMode::blend; }));
    EXPECT_TRUE(has([](const Material& m) { return m.alphaMode == AlphaMode::opaque; }));
    EXPECT_EQ(makeSheets(2013).scene.instances.x, scene.instances.x);
    EXPECT_NE(makeSheets(2014).scene.instances.x, scene.instances.x);
}

} // namespace

} // namespace cdr::visibility
