#include "../support/refusal.h"

#include <cdr/base/error.h>
#include <cdr/scene/scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <string>

namespace cdr::scene {

namespace {

std::string refusalOfMesh(Scene& scene, std::uint32_t mesh) {
    return cdr::test::inputErrorOf(
        [&] {
            addInstance(scene, mesh, 0, 0, {0.0, 0.0, -5.0}, glm::mat3(1.0f));
        },
        "added");
}

/// An instance takes its radius from its mesh, so the mesh comes first.
TEST(AddInstance, RefusesAMeshThatIsNotThere) {
    Scene scene;
    EXPECT_EQ(
        refusalOfMesh(scene, 0),
        "scene: mesh 0 of an instance is not there, the scene has 0; add meshes before their instances");
    scene.meshes.push_back(makeBox(glm::vec3(1.0f)));
    EXPECT_EQ(refusalOfMesh(scene, 0), "added");
    EXPECT_NE(refusalOfMesh(scene, 1), "added");
    const Instances& instances = scene.instances;
    for (const std::size_t count : {instances.x.size(), instances.y.size(), instances.z.size(),
                                    instances.radius.size(), instances.basis.size(), instances.mesh.size(),
                                    instances.material.size(), instances.object.size()}) {
        EXPECT_EQ(count, 1u) << "a refused one leaves nothing behind";
    }
    scene.instances.mesh[0] = 7;
    EXPECT_THROW(placeInstance(scene, 0, {0.0, 0.0, 0.0}, glm::mat3(1.0f)), base::InputError);
}

/// Squares of the least of these are 0 in float32.
TEST(AddInstance, GivesARadiusThatHoldsTheMeshAtAnyScale) {
    for (const float half : {1e-5f, 1.0f, 1e10f}) {
        for (const float scale : {1e-30f, 2e-23f, 1.2e-22f, 3e-22f, 1e-15f, 1.0f, 1e15f}) {
            Scene scene;
            scene.meshes.push_back(makeBox(glm::vec3(half)));
            addInstance(scene, 0, 0, 0, {0.0, 0.0, -5.0}, glm::mat3(scale));
            const double needed = std::sqrt(3.0) * static_cast<double>(half) * static_cast<double>(scale);
            EXPECT_GE(scene.instances.radius[0] / needed, 1.0) << half << ' ' << scale;
            EXPECT_LT(scene.instances.radius[0] / needed, 1.0001) << half << ' ' << scale;
        }
    }
}

TEST(MakeBox, HasARadiusThatHoldsItsCornersAtAnySize) {
    for (const float half : {1e-25f, 1.0f, 5e19f}) {
        const double needed = std::sqrt(3.0) * static_cast<double>(half);
        EXPECT_NEAR(makeBox(glm::vec3(half)).boundingRadius / needed, 1.0, 1e-7) << half;
    }
}

TEST(DirectionalLight, ShinesAlikeAllOverItsSphere) {
    const glm::dvec3 centre(4e6, -2e6, 1e6);
    const glm::vec3 color(0.5f, 2.0f, 1.0f);
    for (const double radius : {1e-3, 1.0, 5e7}) {
        for (const double length : {1e-300, 1.0, 1e300}) {
            const PointLight light =
                directionalLight(glm::dvec3(0.6, -0.8, 0.0) * length, color, centre, radius);
            EXPECT_EQ(light.color, color);
            EXPECT_FALSE(isShaped(light));
            for (const glm::dvec3& beside : {glm::dvec3(0.0), glm::dvec3(0.8, 0.6, 0.0),
                                             glm::dvec3(0.6, -0.8, 0.0), glm::dvec3(0.0, 0.0, -1.0)}) {
                const glm::dvec3 way = (centre + beside * radius) - light.position;
                const double distance = glm::length(way);
                EXPECT_LT(glm::distance(way / distance, glm::dvec3(0.6, -0.8, 0.0)), 1.1e-6);
                const double share = 1.0 / (1.0 + std::pow(distance / light.halfDistance, 2.0));
                EXPECT_GT(share, 1.0 - 1.1e-6);
            }
        }
    }
}

TEST(DirectionalLight, RefusesWhatHasNoLengthOrIsNotFinite) {
    const glm::dvec3 down(0.0, -1.0, 0.0);
    const auto refuses = [](const glm::dvec3& direction, const glm::vec3& color, const glm::dvec3& centre,
                            double radius) {
        return cdr::test::inputErrorOf([&] { directionalLight(direction, color, centre, radius); },
                                       "taken") != "taken";
    };
    const glm::vec3 white(1.0f);
    const glm::dvec3 origin(0.0);
    EXPECT_FALSE(refuses(down, white, origin, 1.0));
    for (const double bad : std::initializer_list<double>{NAN, INFINITY, -INFINITY}) {
        EXPECT_TRUE(refuses({bad, -1.0, 0.0}, white, origin, 1.0));
        EXPECT_TRUE(refuses({0.0, -1.0, bad}, white, origin, 1.0));
        EXPECT_TRUE(refuses(down, {1.0f, 1.0f, static_cast<float>(bad)}, origin, 1.0));
        EXPECT_TRUE(refuses(down, white, {0.0, bad, 0.0}, 1.0));
        EXPECT_TRUE(refuses(down, white, origin, bad));
    }
    EXPECT_TRUE(refuses(origin, white, origin, 1.0));
    for (const double radius : {0.0, -1.0, 1e303}) {
        EXPECT_TRUE(refuses(down, white, origin, radius));
    }
}

} // namespace

} // namespace cdr::scene
