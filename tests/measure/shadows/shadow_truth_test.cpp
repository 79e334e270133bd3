#include "../test_scenes.h"

#include <cdr/base/error.h>
#include <cdr/measure/shadows/wrong_shadows.h>
#include <cdr/measure/truth/layered_truth.h>
#include <cdr/measure/truth/truth.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace cdr::test {

namespace {

using measure::Reach;
using measure::ShadowImage;

ShadowImage castShadows(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                        std::uint32_t height, std::size_t threads = 1) {
    platform::WorkerPool workers(threads);
    const measure::TruthCaster shapes(scene, workers);
    return measure::ShadowTruthCaster(scene, shapes.shapes()).cast(camera, width, height, 0, workers);
}

/// A floor 2 below the camera, a cube over it, and a light straight above the cube. So the cube's shadow is its own outline,
/// enlarged by a factor that follows from the light's height.
scene::Scene floorAndCube(double lightUp) {
    scene::Scene scene = makeEmptyScene();
    addObject(scene, kTriangleCube, {0.0, -2.5, -20.0}, glm::mat3(100, 0, 0, 0, 1, 0, 0, 0, 100));
    addObject(scene, kTriangleCube, {0.0, 0.0, -20.0});
    scene.lights.push_back({.position = {0.0, lightUp, -20.0}});
    return scene;
}

TEST(ShadowTruth, ACubesShadowIsWhereGeometryPutsIt) {
    for (const double lightUp : {1.0, 5.0, 1e6}) {
        const scene::Scene scene = floorAndCube(lightUp);
        const scene::Camera camera = makePlainCamera();
        const ShadowImage truth = castShadows(scene, camera, 200, 100);
        const double half = 0.5 * (lightUp + 2.0) / (lightUp - 0.5); // of the shadow on the floor
        const double slope = 2.0 * std::tan(0.5 * camera.fovY) / 100.0;
        std::size_t shadowed = 0;
        for (std::uint32_t y = 0; y < 100; ++y) {
            for (std::uint32_t x = 0; x < 200; ++x) {
                const auto& pixel = truth.at(x, y);
                const double up = (49.5 - y) * slope;
                const double w = -2.0 / up;
                const double right = (x - 99.5) * slope * w;
                if (pixel.id != 1 || up >= 0.0 || std::abs(right) > 49.0) { // the floor has sides too
                    continue;
                }
                const bool isInside = std::abs(right) < half && std::abs(w - 20.0) < half;
                EXPECT_EQ(pixel.reach, isInside ? Reach::shadowed : Reach::reached) << x << " " << y;
                shadowed += isInside;
            }
        }
        EXPECT_GT(shadowed, 3u);
    }
}

/// The left half of the cube is cut away: half of its outline is in light, and the camera sees through it.
TEST(ShadowTruth, WhatAMaskCutsAwayCastsNoShadow) {
    for (const std::uint32_t mesh : {kCube, kTriangleCube}) {
        scene::Scene scene = floorAndCube(1e6);
        scene.textures.push_back({.name = "halves",
                                  .pixels = image::ImageRgba8(2, 1, {255, 255, 255, 255}),
                                  .magFilter = scene::Filter::nearest});
        scene.textures.front().pixels.at(0, 0)[3] = 0;
        scene.materials.push_back({.name = "mask",
                                   .baseColorTexture = 0,
                                   .doubleSided = true,
                                   .alphaMode = scene::AlphaMode::mask,
                                   .alphaCutoff = 0.5f});
        scene.instances.material[1] = static_cast<std::uint32_t>(scene.materials.size()) - 1;
        scene.instances.mesh[1] = mesh;
        for (scene::Vertex& vertex : scene.meshes[mesh].vertices) {
            vertex.uv = glm::vec2(vertex.position) + 0.5f; // sides that face the light, too
        }
        const ShadowImage truth = castShadows(scene, makePlainCamera(), 800, 400);
        std::array<std::size_t, 2> shadowed{}; // left, right
        std::size_t cube = 0;
        std::size_t doubtful = 0;
        for (std::uint32_t y = 0; y < 400; ++y) {
            for (std::uint32_t x = 0; x < 800; ++x) {
                const measure::ShadowPixel& pixel = truth.at(x, y);
                doubtful += pixel.isDoubtful;
                cube += pixel.id == 2 && x < 399;
                if (pixel.id == 1 && pixel.reach == Reach::shadowed && !pixel.isDoubtful) {
                    ++shadowed.at(x < 400 ? 0 : 1);
                }
            }
        }
        EXPECT_EQ(shadowed[0], 0u) << mesh;
        EXPECT_GT(shadowed[1], 10u) << mesh;
        EXPECT_EQ(cube, 0u) << mesh;
        EXPECT_GT(doubtful, 0u) << mesh;
        EXPECT_LT(doubtful, 100u) << mesh;
    }
}

TEST(ShadowTruth, BackgroundAndWhatFacesAwayAreSaid) {
    const ShadowImage truth = castShadows(floorAndCube(5.0), makePlainCamera(), 201, 101);
    EXPECT_EQ(truth.at(100, 0).reach, Reach::nothing);
    EXPECT_EQ(truth.at(100, 0).id, 0u);
    EXPECT_EQ(truth.at(100, 50).reach, Reach::away); // the cube's front, which lies along the light
    EXPECT_EQ(truth.at(100, 50).id, 2u);
}

TEST(ShadowTruth, OutsideItsConeOrRangeALightIsAway) {
    scene::Scene scene = floorAndCube(5.0);
    const scene::Camera camera = makePlainCamera();
    const ShadowImage whole = castShadows(scene, camera, 200, 100);
    const auto count = [](const ShadowImage& truth, Reach reach) {
        return std::count_if(truth.pixels.begin(), truth.pixels.end(),
                             [reach](const measure::ShadowPixel& pixel) { return pixel.reach == reach; });
    };
    EXPECT_GT(count(whole, Reach::reached), 1000);
    scene.lights.front().cone =
        scene::LightCone{.direction = {0.0, -1.0, 0.0}, .outer = std::atan(4.0 / 7.0)};
    const ShadowImage spot = castShadows(scene, camera, 200, 100);
    EXPECT_EQ(count(spot, Reach::shadowed),
              count(whole, Reach::shadowed)); // all of the shadow is in the cone
    EXPECT_LT(count(spot, Reach::reached), count(whole, Reach::reached) / 4);
    EXPECT_GT(count(spot, Reach::reached), 0);
    scene.lights.front().cone.reset();
    scene.lights.front().range = 6.9; // of 7 to the floor
    const ShadowImage near = castShadows(scene, camera, 200, 100);
    EXPECT_EQ(count(near, Reach::shadowed), 0);
}

TEST(ShadowTruth, FarFromTheOriginItIsTheSame) {
    const scene::Scene near = floorAndCube(5.0);
    const glm::dvec3 shift(0x1p30, -0x1p29, 0x1p31);
    scene::Scene far = near;
    for (std::size_t i = 0; i < far.instances.size(); ++i) {
        far.instances.x[i] += shift.x;
        far.instances.y[i] += shift.y;
        far.instances.z[i] += shift.z;
    }
    far.lights.front().position += shift;
    scene::Camera camera = makePlainCamera();
    const ShadowImage wanted = castShadows(near, camera, 160, 90);
    camera.position += shift;
    EXPECT_EQ(castShadows(far, camera, 160, 90).pixels, wanted.pixels);
}

TEST(ShadowTruth, IdsAreThoseOfTheTruthAndThreadsChangeNothing) {
    const glm::dvec3 middle(10.0, 20.0, 30.0);
    scene::Scene scene = makeRandomScene(5, 200, 10.0, middle);
    scene.lights.push_back({.position = middle + glm::dvec3(3.0, 8.0, 1.0)});
    std::mt19937_64 random(3);
    const scene::Camera camera = makeCameraAround(random, middle, 20.0, 12.0);
    const ShadowImage truth = castShadows(scene, camera, 160, 90);
    const measure::TruthImage ids = cast(scene, camera, 160, 90);
    std::size_t shadowed = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        EXPECT_EQ(truth.pixels[i].id, ids.pixels[i].id);
        shadowed += truth.pixels[i].reach == Reach::shadowed;
    }
    EXPECT_GT(shadowed, 100u);
    EXPECT_EQ(castShadows(scene, camera, 160, 90, 4).pixels, truth.pixels);
}

/// A second floor and a second cube at the places of the first, and a third floor below that a layer lifts. No ray of this
/// size passes an edge exactly.
TEST(ShadowTruth, OfFacesAtOnePlaceIdsAreThoseOfTheTruthToo) {
    scene::Scene scene = floorAndCube(5.0);
    const glm::mat3 wide = scene.instances.basis[0];
    const auto lifted = static_cast<std::uint32_t>(scene.materials.size());
    const auto expectIdsOfTheTruth = [&](std::uint32_t shown, std::uint32_t hidden) {
        const ShadowImage truth = castShadows(scene, makePlainCamera(), 160, 91);
        const measure::TruthImage ids = cast(scene, makePlainCamera(), 160, 91);
        std::size_t pixels = 0;
        for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
            EXPECT_EQ(truth.pixels[i].id, ids.pixels[i].id) << i;
            EXPECT_NE(truth.pixels[i].id, hidden) << i;
            pixels += truth.pixels[i].id == shown;
        }
        EXPECT_GT(pixels, 10u);
    };
    addObject(scene, kTriangleCube, scene.instances.position(1));
    expectIdsOfTheTruth(3, 2);
    addObject(scene, kTriangleCube, scene.instances.position(0), wide);
    expectIdsOfTheTruth(4, 1);
    scene.materials.push_back({.name = "lifted", .layer = 0.25f});
    addObject(scene, kTriangleCube, scene.instances.position(0) - glm::dvec3(0.0, 0.001, 0.0), wide, lifted);
    expectIdsOfTheTruth(5, 4);
    scene.materials[lifted].layer = -0.25f;
    expectIdsOfTheTruth(4, 5);
}

TEST(ShadowTruth, ALightThatIsNotThereIsRefused) {
    const scene::Scene scene = makeEmptyScene();
    EXPECT_THROW(castShadows(scene, makePlainCamera(), 8, 8), base::InputError);
}

TEST(ShadowTruth, InstancesThatReferToNothingAreRefused) {
    platform::WorkerPool workers(1);
    const scene::Scene good = floorAndCube(5.0);
    const measure::TruthCaster shapes(good, workers);
    for (auto member : {&scene::Instances::material, &scene::Instances::mesh}) {
        scene::Scene bad = good;
        (bad.instances.*member)[1] = 3; // of 2 materials and 3 meshes
        EXPECT_THROW(measure::ShadowTruthCaster(bad, shapes.shapes()), base::InputError);
        EXPECT_THROW(measure::castLayers(bad, makePlainCamera(), 8, 8, workers, measure::Lights::castShadows),
                     base::InputError);
    }
}

TEST(WrongShadows, InnerPixelsAndEdgesAreCountedApart) {
    ShadowImage truth(7, 5);
    for (auto& pixel : truth.pixels) {
        pixel = {.id = 1, .reach = Reach::reached};
    }
    truth.at(5, 2).reach = Reach::shadowed;
    truth.at(0, 0).reach = Reach::away;
    image::ImageRgba8 reached(7, 5);
    for (image::Rgba8& pixel : reached.pixels) {
        pixel = {0, 0, 255, 0};
    }
    reached.at(2, 2)[2] = 0; // inner
    reached.at(0, 0)[2] = 0; // faces away: does not count
    const measure::WrongShadows wrong = measure::countWrongShadows({reached, 2}, truth);
    EXPECT_EQ(wrong.pixels,
              8u); // of 15 that have eight neighbours, less 6 around the shadow and 1 beside what faces away
    EXPECT_EQ(wrong.wrong, 1u);
    EXPECT_EQ(wrong.edgeWrong, 1u);
    EXPECT_EQ(wrong.shadowed, 0u);
    EXPECT_EQ(wrong.fraction(), 1.0 / 8.0);
    EXPECT_EQ(measure::WrongShadows{}.fraction(), std::nullopt);
    const image::ImageRgba8 map =
        measure::shadowHeatMap({reached, 2}, truth, image::ImageRgba8(7, 5, {40, 200, 90, 255}));
    EXPECT_EQ(map.at(2, 2), (image::Rgba8{0, 114, 255, 255}));
    EXPECT_EQ(map.at(5, 2), (image::Rgba8{255, 165, 0, 255}));
    EXPECT_EQ(map.at(3, 2), (image::Rgba8{78, 78, 78, 255})) << "half the luma";
    EXPECT_THROW(measure::countWrongShadows({image::ImageRgba8(3, 3), 0}, truth), base::InputError);
    EXPECT_THROW(measure::shadowHeatMap({reached, 2}, truth, image::ImageRgba8(7, 4)), base::InputError);
}

} // namespace

} // namespace cdr::test
