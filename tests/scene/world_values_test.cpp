#include "../support/refusal.h"

#include <cdr/scene/world/world.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace cdr::scene {

namespace {

/// Why a new world does not take it; "taken" where it does.
template <typename Add>
std::string refusalToAdd(const Add& add) {
    World world;
    return cdr::test::inputErrorOf([&] { add(world); }, "taken");
}

TEST(WorldValues, ACutoffIsAnAlphaAboveZero) {
    Texture texture{.name = "leaf", .pixels = image::ImageRgba8(1, 1, {1, 2, 3, 255})};
    const auto refusalOf = [&](float cutoff) {
        texture.cutoff = cutoff;
        return refusalToAdd([&](World& world) { world.addTexture(texture); });
    };
    EXPECT_EQ(refusalOf(1.0f), "taken");
    EXPECT_EQ(refusalOf(0.0f), "the new texture: its cutoff must lie in (0, 1], not 0");
    for (const float cutoff : {-0.5f, 1.5f, NAN}) {
        EXPECT_NE(refusalOf(cutoff), "taken") << cutoff;
    }
}

TEST(WorldValues, HalfSidesOfABoxAreFiniteAndNotNegative) {
    Mesh mesh = makeBox({1.0f, 0.0f, 1.0f});
    EXPECT_EQ(refusalToAdd([&](World& world) { world.addMesh(mesh); }), "taken");
    for (const float half : {-1.0f, NAN, INFINITY}) {
        mesh.boxHalfSides->y = half;
        EXPECT_EQ(refusalToAdd([&](World& world) { world.addMesh(mesh); }),
                  "the new mesh: the half sides of its box must be finite and 0 or more");
    }
}

TEST(WorldValues, VerticesLieWithinTheBoundingRadiusAtAnySize) {
    for (const float half : {1e-23f, 1.0f, 5e19f}) {
        Mesh mesh = makeBox(glm::vec3(half));
        EXPECT_EQ(refusalToAdd([&](World& world) { world.addMesh(mesh); }), "taken") << half;
        mesh.boundingRadius = half;
        EXPECT_NE(refusalToAdd([&](World& world) { world.addMesh(mesh); }), "taken") << half;
    }
}

TEST(WorldValues, ErrorsOfDetailAreFiniteAndNotNegative) {
    const Mesh box = makeBox(glm::vec3(1.0f));
    const auto ofLevel = [&](float error) {
        Mesh mesh = box;
        mesh.levels = {{.indices = {0, 1, 2}, .error = 0.5f}, {.indices = {0, 1, 2}, .error = error}};
        return refusalToAdd([&](World& world) { world.addMesh(mesh); });
    };
    const auto ofGroup = [&](float error) {
        Mesh mesh = box;
        mesh.clusters = {.indices = box.indices,
                         .clusters = {{.firstIndex = 0, .indexCount = 36}},
                         .groups = {{.error = 0.5f}, {.error = error}}};
        return refusalToAdd([&](World& world) { world.addMesh(mesh); });
    };
    EXPECT_EQ(ofLevel(0.0f), "taken");
    EXPECT_EQ(ofGroup(0.0f), "taken");
    EXPECT_EQ(ofLevel(-0.5f),
              "the new mesh: the error of a level of detail must be finite and 0 or more, not -0.5");
    EXPECT_EQ(ofGroup(-0.5f),
              "the new mesh: the error of a group of clusters must be finite and 0 or more, not -0.5");
    for (const float error : {NAN, INFINITY, -INFINITY}) {
        EXPECT_NE(ofLevel(error), "taken") << error;
        EXPECT_NE(ofGroup(error), "taken") << error;
    }
}

TEST(WorldValues, SpheresAndConesOfClustersAreFiniteAndNotNegative) {
    const Mesh box = makeBox(glm::vec3(1.0f));
    const auto refusalOf = [&](const MeshCluster& cluster, const ClusterGroup& group) {
        Mesh mesh = box;
        mesh.clusters = {.indices = box.indices, .clusters = {cluster}, .groups = {group}};
        return refusalToAdd([&](World& world) { world.addMesh(mesh); });
    };
    const MeshCluster sound{.firstIndex = 0,
                            .indexCount = 36,
                            .bounds = {.radius = 2.0f},
                            .coneAxis = {0.0f, 0.6f, 0.8f},
                            .coneCutoff = 0.5f};
    EXPECT_EQ(refusalOf(sound, {.bounds = {.radius = 2.0f}}), "taken");
    EXPECT_EQ(refusalOf({.firstIndex = 0, .indexCount = 36}, {}), "taken"); // faces all ways
    for (const ClusterSphere& sphere :
         {ClusterSphere{.radius = -1.0f}, ClusterSphere{.radius = NAN}, ClusterSphere{.radius = INFINITY},
          ClusterSphere{.centre = {0.0f, NAN, 0.0f}}, ClusterSphere{.centre = {0.0f, 0.0f, -INFINITY}}}) {
        MeshCluster cluster = sound;
        cluster.bounds = sphere;
        EXPECT_EQ(refusalOf(cluster, {}),
                  "the new mesh: the sphere of a cluster must be finite and its radius 0 or more");
        EXPECT_EQ(refusalOf(sound, {.bounds = sphere}),
                  "the new mesh: the sphere of a group of clusters must be finite and its radius 0 or more");
    }
    const auto refusalOfCone = [&](const glm::vec3& axis, float cutoff) {
        MeshCluster cluster = sound;
        cluster.coneAxis = axis;
        cluster.coneCutoff = cutoff;
        return refusalOf(cluster, {});
    };
    const std::string cone =
        "the new mesh: the cone of a cluster must have an axis of length 1 and a cutoff in [0, 1]";
    for (const float bad : {NAN, INFINITY, 2.0f}) {
        EXPECT_EQ(refusalOfCone({0.0f, bad, 0.0f}, 0.5f), cone) << bad;
        EXPECT_EQ(refusalOfCone({0.0f, 1.0f, 0.0f}, bad), cone) << bad;
        EXPECT_EQ(refusalOfCone({0.0f, 1.0f, 0.0f}, -bad), cone) << bad;
    }
}

/// Colours are not bounded: textures multiply them.
TEST(WorldValues, TheAlphaOfABaseColourIsAShare) {
    const auto refusalOf = [](const glm::vec4& color) {
        return refusalToAdd([&](World& world) { world.addMaterial({.baseColorFactor = color}); });
    };
    EXPECT_EQ(refusalOf({2.0f, 1.5f, 0.0f, 1.0f}), "taken");
    EXPECT_EQ(refusalOf({1.0f, 1.0f, 1.0f, 0.0f}), "taken");
    EXPECT_EQ(refusalOf({1.0f, 1.0f, 1.0f, 1.5f}),
              "the material: the alpha of its base colour must lie in [0, 1], not 1.5");
    EXPECT_NE(refusalOf({1.0f, 1.0f, 1.0f, -0.5f}), "taken");
}

/// The radius of a removed instance is kNoRadius, which says that there is none.
TEST(WorldValues, RadiiOfInstancesAreFiniteAndNotNegative) {
    World world;
    const InstanceOptions box{.mesh = world.addMesh(makeBox(glm::vec3(1.0f))),
                              .material = world.addMaterial({.name = "white"})};
    world.addInstance(box);
    world.removeInstance(world.addInstance(box));
    const auto refusalWith = [&](float radius) {
        Scene scene = world.scene();
        scene.instances.radius[0] = radius;
        return cdr::test::inputErrorOf([&] { World{std::move(scene)}; }, "taken");
    };
    for (const float radius : {0.0f, 2.0f, kNoRadius}) {
        EXPECT_EQ(refusalWith(radius), "taken") << radius;
    }
    EXPECT_EQ(refusalWith(-1.0f), "instance 0: its radius must be finite and 0 or more, not -1");
    for (const float radius : {NAN, INFINITY, -INFINITY}) {
        EXPECT_NE(refusalWith(radius), "taken") << radius;
    }
}

} // namespace

} // namespace cdr::scene
