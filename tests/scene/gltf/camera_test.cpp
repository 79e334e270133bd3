#include "../../support/refusal.h"
#include "fixture.h"

#include <cdr/scene/gltf/open_gltf.h>

#include <cmath>

namespace cdr::scene::test {
namespace {

/// A square, and before it a node that turns half round y, stretches, and carries a camera.
Document withCamera() {
    Document document = square();
    document.root["cameras"] = {
        {{"type", "perspective"},
         {"name", "eye"},
         {"perspective", {{"yfov", 0.5}, {"znear", 0.25}, {"zfar", 100.0}, {"aspectRatio", 2.0}}}},
        {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.5}}}},
        {{"type", "orthographic"},
         {"orthographic", {{"xmag", 1.0}, {"ymag", 2.0}, {"znear", 0.0}, {"zfar", 1.0}}}}};
    document.root["nodes"] = {{{"mesh", 0}},
                              {{"translation", {1, 2, 1e6}}, {"children", {2}}, {"rotation", {0, 1, 0, 0}}},
                              {{"camera", 0}, {"scale", {2, 3, -4}}, {"translation", {0, 0, 0.125}}},
                              {{"camera", 2}},
                              {{"camera", 1}, {"name", "second"}},
                              {{"camera", 1}, {"name", "elsewhere"}}};
    document.root["scenes"] = {{{"nodes", {0, 1, 3, 4}}}, {{"nodes", {0, 5}}}};
    return document;
}

TEST_F(GltfFolder, CamerasStandWhereTheirNodesPutThem) {
    const GltfImport result = load(withCamera());
    ASSERT_EQ(result.cameras.size(), 3u);
    const Camera& camera = result.cameras[0].camera;
    EXPECT_EQ(result.cameras[0].name, "eye");
    EXPECT_NEAR(camera.position.x, 1.0, 1e-9);
    EXPECT_NEAR(camera.position.z, 1e6 - 0.125, 1e-9);
    EXPECT_EQ(camera.fovY, 0.5);
    EXPECT_EQ(camera.nearView, 0.25);
    EXPECT_EQ(camera.farView, 100.0);
    // Half a turn, then mirrored by the scale: it looks down -z, and what spans its view is orthonormal.
    EXPECT_NEAR(camera.back.z, 1.0, 1e-12);
    EXPECT_NEAR(camera.up.y, 1.0, 1e-12);
    EXPECT_NEAR(glm::distance(camera.right, glm::cross(camera.up, camera.back)), 0.0, 1e-12);
    EXPECT_EQ(result.cameras[1].name, "second");
    EXPECT_EQ(result.cameras[1].camera.farView, 0.5 * kGltfFarRatio); // no zfar: infinitely far
    EXPECT_FALSE(result.cameras[1].orthographic);
    ASSERT_TRUE(result.cameras[2].orthographic);
    EXPECT_EQ(result.cameras[2].orthographic->halfHeight, 2.0);
    EXPECT_FALSE(anySays(result.ignored, "eye"));
}

TEST_F(GltfFolder, AnotherSceneOfTheFileIsChosen) {
    const std::filesystem::path path = write("a.glb", withCamera().glb());
    const GltfImport second = loadGltf(path, {}, 1);
    ASSERT_EQ(second.cameras.size(), 1u);
    EXPECT_EQ(second.cameras[0].name, "elsewhere");
    EXPECT_EQ(second.scene.instances.size(), 1u);
    expectSays(cdr::test::inputErrorOf([&] { loadGltf(path, {}, 2); }, "loaded"),
               "scene 2 does not exist, the file has 2");
}

TEST_F(GltfFolder, StagingLooksThroughTheCameraThatIsChosen) {
    const std::filesystem::path path = write("a.glb", withCamera().glb());
    const OpenedScene framed = openGltf(path);
    EXPECT_TRUE(anySays(framed.notes, "3 cameras, which --camera 0 to 2 looks through"));
    EXPECT_NE(framed.setup.path.at(0).fovY, 0.5);
    const OpenedScene seen = openGltf(path, {.scene = {}, .camera = 0});
    EXPECT_EQ(seen.setup.path.at(0).fovY, 0.5);
    EXPECT_EQ(seen.setup.scene.lights.size(), 2u);
    EXPECT_FALSE(anySays(seen.notes, "--camera"));
    expectSays(cdr::test::inputErrorOf([&] { openGltf(path, {.scene = {}, .camera = 3}); }, "opened"),
               "camera 3 does not exist, the scene has 3: 0 'eye', 1 'second', 2 ''");
}

/// Where a picture 1080 pixels high shows a point, in pixels from its middle.
glm::dvec2 pixelOf(const Camera& camera, const glm::dvec3& world) {
    const double scale = 540.0 / std::tan(0.5 * camera.fovY) / camera.viewDistance(world);
    const glm::dvec3 view = camera.toView(world);
    return scale * glm::dvec2(view);
}

/// Two squares of half a unit, one 30 times as far away as the other.
Document withBoxCamera() {
    Document document = square();
    document.root["cameras"] = {
        {{"type", "orthographic"},
         {"name", "plan"},
         {"orthographic", {{"xmag", 3.0}, {"ymag", 3.0}, {"znear", 0.5}, {"zfar", 1000.0}}}}};
    document.root["nodes"] = {{{"mesh", 0}, {"translation", {0, 0, -1}}},
                              {{"mesh", 0}, {"translation", {0, 0, -30}}},
                              {{"camera", 0}}};
    document.root["scenes"] = {{{"nodes", {0, 1, 2}}}};
    return document;
}

TEST_F(GltfFolder, OrthographicCamerasShowNearAndFarThingsEquallyLarge) {
    const OpenedScene opened = openGltf(write("a.glb", withBoxCamera().glb()), {.scene = {}, .camera = 0});
    EXPECT_TRUE(anySays(opened.notes, "the orthographic camera 'plan', which is drawn in perspective"));
    const Camera camera = opened.setup.path.at(0);
    requireUsable(camera);
    const double perUnit = 540.0 / 3.0;
    for (const double z : {-1.0, -10.0, -30.0}) {
        for (const glm::dvec2 corner : {glm::dvec2(0.5, 0.25), glm::dvec2(-5.0, 3.0)}) {
            const glm::dvec2 off = pixelOf(camera, glm::dvec3(corner, z)) - perUnit * corner;
            EXPECT_LT(glm::length(off), 0.5) << z;
        }
    }
    EXPECT_NEAR(camera.viewDistance({0, 0, -0.5}), camera.nearView, 1e-9 * camera.nearView);
    EXPECT_NEAR(camera.viewDistance({0, 0, -1000.0}), camera.farView, 1e-9 * camera.farView);
}

/// How small the field of view is depends on the scene, so they are cameras of the file.
TEST_F(GltfFolder, OrthographicCamerasThatNoPictureHasAreRefused) {
    Document document = withBoxCamera();
    document.root["cameras"][0]["orthographic"]["ymag"] = 1e-40;
    const std::filesystem::path path = write("a.glb", document.glb());
    const std::string refusal =
        cdr::test::inputErrorOf([&] { openGltf(path, {.scene = {}, .camera = 0}); }, "opened");
    EXPECT_TRUE(refusal.starts_with(path.string() + ": field of view must be at least")) << refusal;
    EXPECT_TRUE(anySays(openGltf(path).notes, "its camera"));
}

TEST_F(GltfFolder, OrthographicCamerasMove) {
    Document document = withBoxCamera();
    giveMove(document, 2, {0, 1}, {0, 0, 0, 1, 2, 0});
    const OpenedScene opened =
        openGltf(write("a.glb", document.glb()), {.scene = {}, .camera = 0, .framesPerSecond = 1.0});
    ASSERT_GE(opened.setup.path.frames, 2u);
    for (const double z : {-1.0, -30.0}) {
        const glm::dvec2 seen = pixelOf(opened.setup.path.at(1), {1.5, 2.25, z});
        EXPECT_LT(glm::distance(seen, 540.0 / 3.0 * glm::dvec2(0.5, 0.25)), 0.5) << z;
    }
}

TEST_F(GltfFolder, CamerasThatANodeFlattensAreSaid) {
    Document document = withCamera();
    document.root["nodes"][2]["scale"] = {1, 0, 1};
    const GltfImport result = load(document);
    EXPECT_EQ(result.cameras.size(), 2u);
    EXPECT_TRUE(
        anySays(result.ignored, "node 2: a camera is not used, because its transform is not invertible"));
}

/// A file is of use without a camera that no picture can be taken with.
TEST_F(GltfFolder, CamerasThatNoPictureHasAreSaid) {
    for (const json& lens : {json{{"yfov", 3.5}, {"znear", 1.0}}, json{{"yfov", 1.0}, {"znear", 1e305}},
                             json{{"yfov", 1e-35}, {"znear", 1.0}}}) {
        Document document = withCamera();
        document.root["cameras"][0]["perspective"] = lens;
        const GltfImport result = load(document);
        ASSERT_EQ(result.cameras.size(), 2u) << lens;
        EXPECT_EQ(result.cameras[0].name, "second");
        EXPECT_TRUE(anySays(result.ignored, "camera 0 'eye': not used, because pictures have no such"))
            << lens;
    }
}

/// glTF says that a magnification should not be negative, and not that it must not.
TEST_F(GltfFolder, NegativeMagnificationsCountAsPositive) {
    Document document = withCamera();
    document.root["cameras"][2]["orthographic"]["ymag"] = -2.0;
    const GltfImport result = load(document);
    ASSERT_EQ(result.cameras.size(), 3u);
    EXPECT_EQ(result.cameras[2].orthographic->halfHeight, 2.0);
}

TEST_F(GltfFolder, CamerasThatNoNodeOfTheSceneHasAreNotChecked) {
    Document document = withCamera();
    document.root["cameras"].push_back({{"type", "fisheye"}});
    document.root["cameras"].push_back(nullptr);
    document.root["nodes"][5]["camera"] = 3;
    EXPECT_EQ(load(document).cameras.size(), 3u);
    document.root["scene"] = 1;
    expectSays(refusal(document), "camera 3 '': type 'fisheye' does not exist");
}

TEST_F(GltfFolder, UnsoundCamerasAreRefused) {
    const auto withLens = [&](const json& perspective) {
        Document document = withCamera();
        document.root["cameras"][0]["perspective"] = perspective;
        return refusal(document);
    };
    expectSays(withLens({{"yfov", 0.0}, {"znear", 1.0}}), "camera 0 'eye': its yfov is 0.0");
    expectSays(withLens({{"yfov", 1.0}, {"znear", 0.0}}), "its znear is 0.0");
    expectSays(withLens({{"yfov", 1.0}, {"znear", "near"}}), "its znear is \"near\"");
    expectSays(withLens({{"yfov", 1.0}, {"znear", 2.0}, {"zfar", 2.0}}), "a znear that lies before its zfar");
    expectSays(withLens({{"znear", 2.0}}), "needs a yfov");
    expectSays(withLens(nullptr), "'perspective' is not an object");
    const auto withBox = [&](const json& orthographic) {
        Document document = withCamera();
        document.root["cameras"][2]["orthographic"] = orthographic;
        return refusal(document);
    };
    expectSays(withBox({{"ymag", 0.0}, {"znear", 0.0}, {"zfar", 1.0}}), "camera 2 '': its ymag is 0.0");
    expectSays(withBox({{"ymag", "2"}, {"znear", 0.0}, {"zfar", 1.0}}), "'ymag' is not a number");
    expectSays(withBox({{"ymag", 1.0}, {"znear", -1.0}, {"zfar", 1.0}}), "a znear of at least 0");
    expectSays(withBox({{"ymag", 1.0}, {"znear", 1.0}, {"zfar", 1.0}}), "lies before its zfar");
    expectSays(withBox({{"ymag", 1.0}, {"zfar", 1.0}}), "needs a ymag, and a znear");
    expectSays(withBox(nullptr), "'orthographic' is not an object");
    expectRefused(withCamera(), "/cameras/1/type", "fisheye", "type 'fisheye' does not exist");
    expectRefused(withCamera(), "/nodes/3/camera", 7, "camera 7 does not exist, the file has 3");
}

} // namespace
} // namespace cdr::scene::test
