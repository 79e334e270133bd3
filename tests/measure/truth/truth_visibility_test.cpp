#include "../test_scenes.h"

#include <cdr/base/error.h>
#include <cdr/measure/truth/layered_truth.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cdr::test {

namespace {

using measure::TruthPixel;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Two triangles in the plane z = 0, counter-clockwise seen from +z.
scene::Mesh makeSquare() {
    scene::Mesh mesh;
    mesh.name = "square";
    mesh.boundingRadius = 1.5f;
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        mesh.vertices.push_back({.position = glm::vec3(corner, 0.0f)});
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// One square facing the camera at w = 5.
scene::Scene squareScene(const glm::mat3& basis, std::uint32_t material) {
    scene::Scene scene = makeEmptyScene();
    scene.meshes.push_back(makeSquare());
    addObject(scene, 3, {0.0, 0.0, -5.0}, basis, material);
    return scene;
}

const glm::mat3 kTurned(-1, 0, 0, 0, 1, 0, 0, 0, -1);
const glm::mat3 kMirroredX(-1, 0, 0, 0, 1, 0, 0, 0, 1);
const glm::mat3 kMirroredZ(1, 0, 0, 0, 1, 0, 0, 0, -1);

} // namespace

TEST(TruthVisibility, EmptySceneIsBackground) {
    const measure::TruthImage truth = cast(scene::Scene{}, makePlainCamera(), 5, 3);
    EXPECT_EQ(truth, measure::TruthImage(5, 3, {0, 0, kInfinity, kInfinity}));
}

TEST(TruthVisibility, OnePixelLooksAlongTheAxis) {
    scene::Scene scene = makeEmptyScene();
    addObject(scene, kCube, {0.0, 0.0, -10.0});
    addObject(scene, kTriangleCube, {0.0, 0.0, -20.0});
    EXPECT_EQ(castMiddle(scene, makePlainCamera()), (TruthPixel{1, 2, 9.5, 19.5}));
}

TEST(TruthVisibility, OfEqualSurfacesTheLastInTheScenesOrderIsFirst) {
    scene::Scene scene = squareScene(glm::mat3(1.0f), kSingleSided);
    addObject(scene, 3, {0.0, 0.0, -5.0}, glm::mat3(1.0f), kSingleSided);
    addObject(scene, 3, {0.0, 0.0, -5.0}, glm::mat3(1.0f), kSingleSided);
    scene.instances.object = {7, 9, 4};
    EXPECT_EQ(castMiddle(scene, makePlainCamera()), (TruthPixel{5, 10, 5.0, 5.0}));
}

TEST(TruthVisibility, LayersDecideWhichSurfaceIsFirst) {
    scene::Scene scene = squareScene(glm::mat3(1.0f), kSingleSided);
    scene.materials.push_back({.name = "upper", .layer = 0.5f});
    scene.materials.push_back({.name = "lower", .layer = -0.5f});
    addObject(scene, 3, {0.0, 0.0, -5.25}, glm::mat3(1.0f), 2);
    addObject(scene, 3, {0.0, 0.0, -4.75}, glm::mat3(1.0f), 3);
    EXPECT_EQ(castMiddle(scene, makePlainCamera()), (TruthPixel{2, 1, 5.25, 5.0, 0.5f, 0.0f}));
    scene.materials[2].layer = 0.125f;
    EXPECT_EQ(castMiddle(scene, makePlainCamera()), (TruthPixel{1, 2, 5.0, 5.25, 0.0f, 0.125f}));
}

/// Tiles end early where nothing farther can be seen, which a layer may.
TEST(TruthVisibility, LayersReachThroughManyNearerSurfaces) {
    scene::Scene scene = makeEmptyScene();
    scene.meshes.push_back(makeSquare());
    scene.materials.push_back({.name = "upper", .layer = 50.0f});
    for (int i = 0; i < 40; ++i) {
        addObject(scene, 3, {0.0, 0.0, -5.0 - 0.5 * i});
    }
    const std::uint32_t far = addObject(scene, 3, {0.0, 0.0, -30.0}, glm::mat3(1.0f), 2);
    EXPECT_EQ(castMiddle(scene, makePlainCamera()), (TruthPixel{far + 1, 1, 30.0, 5.0, 50.0f, 0.0f}));
}

/// Steep surfaces come early, by their nearest corner, and are met far behind it.
TEST(TruthVisibility, LayersReachBeforeSurfacesThatWereMetFirst) {
    scene::Scene scene = makeEmptyScene();
    scene.meshes.push_back(makeSquare());
    scene.materials.push_back({.name = "upper", .layer = 50.0f});
    const glm::mat3 steep(10.0f, 0.0f, -17.0f, 0.0f, 20.0f, 0.0f, 17.0f, 0.0f, 10.0f);
    addObject(scene, 3, {0.0, 0.0, -20.0}, steep);
    addObject(scene, 3, {0.0, 0.0, -20.5}, steep);
    addObject(scene, 3, {0.0, 0.0, -54.0}, glm::mat3(1.0f), 2);
    const TruthPixel pixel = castMiddle(scene, makePlainCamera());
    EXPECT_EQ(pixel.id, 3u);
    EXPECT_EQ(pixel.secondId, 1u);
}

TEST(TruthVisibility, PixelsRunFromTheTopLeft) {
    scene::Scene scene = makeEmptyScene();
    const double slope = std::tan(30.0 * kDegree);
    addObject(scene, kCube, {-15.0 * slope, 5.0 * slope, -10.0});
    const measure::TruthImage truth = cast(scene, makePlainCamera(), 4, 2);
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        EXPECT_EQ(truth.pixels[i].id, i == 0 ? 1u : 0u) << i;
    }
}

TEST(TruthVisibility, NearAndFarAreInclusive) {
    for (const std::uint32_t mesh : {kCube, kTriangleCube}) {
        scene::Scene scene = makeEmptyScene();
        addObject(scene, mesh, {0.0, 0.0, -10.0});
        scene::Camera camera = makePlainCamera();
        camera.nearView = 9.5;
        EXPECT_EQ(castMiddle(scene, camera).id, 1u);
        camera.nearView = std::nextafter(9.5, 10.0);
        EXPECT_EQ(castMiddle(scene, camera).id, 0u) << "the back face is not seen";
        camera.nearView = 1.0;
        camera.farView = 9.5;
        EXPECT_EQ(castMiddle(scene, camera).id, 1u);
        camera.farView = std::nextafter(9.5, 9.0);
        EXPECT_EQ(castMiddle(scene, camera).id, 0u);
    }
}

TEST(TruthVisibility, BehindAnInvisibleFaceTheNextOneCounts) {
    for (const std::uint32_t mesh : {kCube, kTriangleCube}) {
        scene::Scene scene = makeEmptyScene();
        addObject(scene, mesh, {0.0, 0.0, -10.0}, glm::mat3(1.0f), kDoubleSided);
        scene::Camera camera = makePlainCamera();
        camera.nearView = 10.0;
        EXPECT_EQ(castMiddle(scene, camera), (TruthPixel{1, 0, 10.5, kInfinity}));
        camera.farView = 10.25;
        EXPECT_EQ(castMiddle(scene, camera).id, 0u);
    }
}

TEST(TruthVisibility, NothingBehindTheCamera) {
    scene::Scene scene = makeEmptyScene();
    addObject(scene, kCube, {0.0, 0.0, 10.0}, glm::mat3(1.0f), kDoubleSided);
    addObject(scene, kIcosphere, {0.0, 0.0, 20.0}, glm::mat3(1.0f), kDoubleSided);
    EXPECT_EQ(castMiddle(scene, makePlainCamera()).id, 0u);
}

TEST(TruthVisibility, CameraInsideABoxSeesItsInsideOnlyDoubleSided) {
    for (const std::uint32_t mesh : {kCube, kTriangleCube}) {
        scene::Scene scene = makeEmptyScene();
        addObject(scene, mesh, {0.0, 0.0, 0.0}, glm::mat3(8.0f), kSingleSided);
        addObject(scene, mesh, {0.0, 0.0, 0.0}, glm::mat3(6.0f), kDoubleSided);
        const measure::TruthImage truth = cast(scene, makePlainCamera(), 32, 18);
        for (const TruthPixel& pixel : truth.pixels) {
            EXPECT_EQ(pixel.id, 2u);
            EXPECT_EQ(pixel.secondId, 0u);
            EXPECT_NEAR(pixel.distanceView, 3.0, 0.9);
        }
    }
}

TEST(TruthVisibility, BackFacesOfSingleSidedMaterialsAreInvisible) {
    const scene::Camera camera = makePlainCamera();
    EXPECT_EQ(castMiddle(squareScene(glm::mat3(1.0f), kSingleSided), camera).id, 1u);
    EXPECT_EQ(castMiddle(squareScene(kTurned, kSingleSided), camera).id, 0u);
    EXPECT_EQ(castMiddle(squareScene(kTurned, kDoubleSided), camera).id, 1u);
}

TEST(TruthVisibility, MirroringKeepsTheObjectsFrontInFront) {
    const scene::Camera camera = makePlainCamera();
    EXPECT_EQ(castMiddle(squareScene(kMirroredX, kSingleSided), camera).id, 1u);
    EXPECT_EQ(castMiddle(squareScene(kMirroredZ, kSingleSided), camera).id, 0u) << "its front looks away";
    for (const std::uint32_t mesh : {kCube, kTriangleCube}) {
        scene::Scene scene = makeEmptyScene();
        addObject(scene, mesh, {0.0, 0.0, -10.0}, kMirroredX);
        EXPECT_EQ(castMiddle(scene, camera), (TruthPixel{1, 0, 9.5, kInfinity}));
    }
}

TEST(TruthVisibility, SecondIsOfAnotherObject) {
    scene::Scene scene = makeEmptyScene();
    for (const double z : {-14.0, -10.0, -12.0}) {
        scene::addInstance(scene, kCube, kSingleSided, 0, {0.0, 0.0, z}, glm::mat3(1.0f));
    }
    EXPECT_EQ(castMiddle(scene, makePlainCamera()), (TruthPixel{1, 0, 9.5, kInfinity}));
    scene::addInstance(scene, kCube, kSingleSided, 7, {0.0, 0.0, -30.0}, glm::mat3(1.0f));
    EXPECT_EQ(castMiddle(scene, makePlainCamera()), (TruthPixel{1, 8, 9.5, 29.5}));
    scene::addInstance(scene, kCube, kSingleSided, 7, {0.0, 0.0, -8.0}, glm::mat3(1.0f));
    EXPECT_EQ(castMiddle(scene, makePlainCamera()), (TruthPixel{8, 1, 7.5, 9.5}));
}

TEST(TruthVisibility, ObjectsInTheWayOfEarlyEndsStillCount) {
    // Tilted plates begin nearer than the two upright ones but are met behind them.
    const float c = 0.70710678f;
    const glm::mat3 tilted = glm::mat3(1, 0, 0, 0, c, c, 0, -c, c) * glm::mat3(8, 0, 0, 0, 8, 0, 0, 0, 1e-3f);
    const glm::mat3 plate(8, 0, 0, 0, 8, 0, 0, 0, 0.5f);
    for (int plates = 0; plates < 20; ++plates) {
        scene::Scene scene = makeEmptyScene();
        addObject(scene, kCube, {0.0, 0.0, -10.75}, plate);
        addObject(scene, kCube, {0.0, 0.0, -10.25}, plate);
        for (int i = 0; i < plates; ++i) {
            addObject(scene, kCube, {0.0, 0.0, -11.0 - 0.01 * i}, tilted);
        }
        EXPECT_EQ(castMiddle(scene, makePlainCamera()), (TruthPixel{2, 1, 10.0, 10.5})) << plates;
    }
}

TEST(TruthVisibility, GroundUnderTheCameraReachesTheHorizon) {
    for (const std::uint32_t mesh : {kCube, kTriangleCube}) {
        scene::Scene scene = makeEmptyScene();
        const glm::mat3 plate(1e6f, 0, 0, 0, 1, 0, 0, 0, 1e6f);
        addObject(scene, mesh, {0.0, -2.5, 0.0}, plate);
        scene::Camera camera = makePlainCamera();
        camera.farView = 1e6;
        const measure::TruthImage truth = cast(scene, camera, 40, 30);
        for (std::uint32_t y = 0; y < 30; ++y) {
            for (std::uint32_t x = 0; x < 40; ++x) {
                EXPECT_EQ(truth.at(x, y).id, y < 15 ? 0u : 1u) << x << ' ' << y;
            }
        }
    }
}

TEST(TruthVisibility, PlanetFromOrbit) {
    constexpr double kRadius = 6.4e6;
    constexpr double kAltitude = 4.2e5;
    scene::Scene scene = makeEmptyScene();
    scene.meshes.push_back(makeIcosphere(5));
    addObject(scene, 3, {0.0, 0.0, -(kRadius + kAltitude)}, glm::mat3(static_cast<float>(kRadius)));
    scene::Camera camera = makePlainCamera();
    camera.farView = 1e8;
    const measure::TruthImage truth = cast(scene, camera, 33, 33);
    for (const TruthPixel& pixel : truth.pixels) {
        EXPECT_EQ(pixel.id, 1u);
    }
    EXPECT_GE(truth.at(16, 16).distanceView, kAltitude * (1.0 - 1e-9));
    EXPECT_LT(truth.at(16, 16).distanceView, kAltitude + kRadius * 1e-3) << "facets lie below the sphere";
}

TEST(TruthVisibility, TheBoundingRadiusDoesNotMatter) {
    const scene::Camera camera = makePlainCamera();
    scene::Scene scene = makeRandomScene(3, 60, 20.0, {0.0, 0.0, -20.0});
    const measure::TruthImage expected = cast(scene, camera, 64, 36);
    for (const float radius : {0.0f, 1e30f, std::numeric_limits<float>::infinity()}) {
        scene.instances.radius.assign(scene.instances.size(), radius);
        EXPECT_EQ(cast(scene, camera, 64, 36), expected) << radius;
    }
}

TEST(TruthVisibility, FlatAndEmptyObjectsAreInvisible) {
    scene::Scene scene = makeEmptyScene();
    scene.meshes.emplace_back();
    addObject(scene, 3, {0.0, 0.0, -4.0});
    addObject(scene, kCube, {0.0, 0.0, -5.0}, glm::mat3(0.0f));
    addObject(scene, kCube, {0.0, 0.0, -6.0}, glm::mat3(1, 0, 0, 0, 1, 0, 1, 1, 0));
    addObject(scene, kCube, {0.0, 0.0, -7.0}, glm::mat3(1, 0, 0, 0, 1, 0, 1, 1, 1e-20f));
    addObject(scene, kCube, {0.0, 0.0, -10.0});
    EXPECT_EQ(castMiddle(scene, makePlainCamera()), (TruthPixel{5, 0, 9.5, kInfinity}));
}

TEST(TruthInput, IsRefusedWithAReason) {
    const scene::Camera camera = makePlainCamera();
    const scene::Scene good = squareScene(glm::mat3(1.0f), kSingleSided);
    EXPECT_THROW(cast(good, camera, 0, 4), base::InputError);
    EXPECT_THROW(cast(good, camera, 4, 0), base::InputError);
    constexpr std::uint32_t kWide = std::uint32_t{1} << 31; // 2^64 bytes or some times as many
    EXPECT_THROW(cast(good, camera, kWide, kWide), base::RunError);
    platform::WorkerPool workers(1);
    EXPECT_THROW(measure::castLayers(good, camera, kWide, kWide, workers), base::RunError);
    scene::Camera blind = camera;
    blind.nearView = 0.0;
    EXPECT_THROW(cast(good, blind, 4, 4), base::InputError);
    const auto expectRefused = [&](auto&& spoil) {
        scene::Scene bad = good;
        spoil(bad);
        EXPECT_THROW(cast(bad, camera, 4, 4), base::InputError);
    };
    expectRefused([](scene::Scene& s) { s.instances.mesh[0] = 99; });
    expectRefused([](scene::Scene& s) { s.instances.material[0] = 99; });
    expectRefused([](scene::Scene& s) { s.instances.object[0] = scene::kMaxObjects + 1; });
    expectRefused([](scene::Scene& s) { s.instances.x[0] = std::nan(""); });
    expectRefused([](scene::Scene& s) { s.meshes[3].indices[4] = 4; });
    expectRefused([](scene::Scene& s) { s.meshes[3].vertices[0].position.y = INFINITY; });
}

} // namespace cdr::test
