#include "flat_cull.h"

#include <cdr/depth/make_cascades.h>
#include <cdr/visibility/blended.h>
#include <cdr/visibility/cull.h>
#include <cdr/visibility/cull_cells.h>
#include <scenes/sheets.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace cdr::visibility {

using namespace scene;
using namespace scenes;

namespace {

TEST(Blended, InstancesAreListedInOrder) {
    const Scene scene = makeSheets(7, 40).scene;
    ASSERT_TRUE(hasBlended(scene));
    const std::vector<std::uint32_t> blended = blendedInstances(scene);
    EXPECT_EQ(blended.size(), 40u);
    EXPECT_TRUE(std::is_sorted(blended.begin(), blended.end()));
    for (const std::uint32_t instance : blended) {
        EXPECT_LT(scene.instances.object[instance], 40u); // the sheets come first
    }
}

/// The two halves that a frame draws, against one list of all: every instance once, bits unchanged.
TEST(Blended, AndOpaqueInstancesAreAllThatIsVisible) {
    const SceneSetup setup = makeSheets(7, 1500); // more than one block is tested at a time
    const Camera camera = setup.path.at(0);
    const Frustum frustum = frustumOf(camera, 16.0, 9.0);
    const std::vector<std::uint32_t> blended = blendedInstances(setup.scene);
    const VisibleList all = flatCull(setup.scene.instances, camera, frustum);
    VisibleList translucent;
    cullSpheres(setup.scene.instances, blended, camera, frustum, translucent);
    platform::WorkerPool workers(1);
    InstanceCells cells;
    cells.build(setup.scene, workers);
    VisibleCells opaque;
    cullCells(cells, camera, frustum, workers, opaque);
    EXPECT_GT(opaque.count(), 10u);
    EXPECT_GT(translucent.count, 10u);
    ASSERT_EQ(opaque.count() + translucent.count, all.count);
    std::size_t next = 0;
    for (std::size_t i = 0; i < all.count; ++i) {
        if (std::binary_search(blended.begin(), blended.end(), all.instance[i])) {
            ASSERT_EQ(translucent.instance[next], all.instance[i]);
            EXPECT_EQ(translucent.distanceView[next], all.distanceView[i]);
            EXPECT_EQ(translucent.radius[next], all.radius[i]);
            ++next;
        }
    }
    EXPECT_EQ(next, translucent.count);
}

TEST(Blended, MasksAndOpaqueMaterialsAreNot) {
    Scene scene;
    scene.meshes.push_back(makeSquare(1.0f));
    scene.materials.push_back({.name = "mask", .alphaMode = AlphaMode::mask});
    scene.materials.push_back({.name = "unused", .alphaMode = AlphaMode::blend});
    addInstance(scene, 0, 0, 0, glm::dvec3(0.0), glm::mat3(1.0f));
    EXPECT_FALSE(hasBlended(scene));
    EXPECT_TRUE(blendedInstances(scene).empty());
}

/// Whether a boundary lies between the nearest and the farthest vertex.
bool crosses(const Scene& scene, std::uint32_t i, const Camera& camera, double boundaryView) {
    const Instances& instances = scene.instances;
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
    const std::vector<std::uint32_t> sheets = blendedInstances(setup.scene);
    for (unsigned count = 2; count <= 8; ++count) {
        const depth::Cascades cascades = depth::makeCascades(
            depth::SplitCount{count}, {.nearView = camera.nearView, .farView = camera.farView});
        for (std::size_t boundary = 1; boundary < count; ++boundary) {
            int crossings = 0;
            for (const std::uint32_t sheet : sheets) {
                crossings += crosses(setup.scene, sheet, camera, cascades[boundary].nearView) ? 1 : 0;
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
