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
         {"orthographic", {{"xmag", 1.0}, {"ymag", 1.0}, {"znear", 0.1}, {"zfar", 1.0}}}}};
    document.root["nodes"] = {{{"mesh", 0}},
                              {{"translation", {1, 2, 1e6}}, {"children", {2}}, {"rotation", {0, 1, 0, 0}}},
                              {{"camera", 0}, {"scale", {2, 3, -4}}, {"translation", {0, 0, 0.125}}},
                              {{"camera", 1}, {"name", "second"}},
                              {{"camera", 2}},
                              {{"camera", 1}, {"name", "elsewhere"}}};
    document.root["scenes"] = {{{"nodes", {0, 1, 3, 4}}}, {{"nodes", {0, 5}}}};
    return document;
}

TEST_F(GltfFolder, CamerasStandWhereTheirNodesPutThem) {
    const GltfImport result = load(withCamera());
    ASSERT_EQ(result.cameras.size(), 2u);
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
    EXPECT_TRUE(anySays(result.ignored, "camera 2 '': orthographic cameras are not used"));
    EXPECT_FALSE(anySays(result.ignored, "eye"));
}

TEST_F(GltfFolder, AnotherSceneOfTheFileIsChosen) {
    const std::filesystem::path path = write("a.glb", withCamera().glb());
    const GltfImport second = loadGltf(path, {}, 1);
    ASSERT_EQ(second.cameras.size(), 1u);
    EXPECT_EQ(second.cameras[0].name, "elsewhere");
    EXPECT_EQ(second.scene.instances.size(), 1u);
    try {
        loadGltf(path, {}, 2);
        FAIL() << "loaded";
    } catch (const base::InputError& error) {
        expectSays(error.what(), "scene 2 does not exist, the file has 2");
    }
}

TEST_F(GltfFolder, StagingLooksThroughTheCameraThatIsChosen) {
    const std::filesystem::path path = write("a.glb", withCamera().glb());
    const OpenedScene framed = openGltf(path);
    EXPECT_TRUE(anySays(framed.notes, "2 cameras, which --camera 0 to 1 looks through"));
    EXPECT_NE(framed.setup.path.at(0).fovY, 0.5);
    const OpenedScene seen = openGltf(path, {.scene = {}, .camera = 0});
    EXPECT_EQ(seen.setup.path.at(0).fovY, 0.5);
    EXPECT_EQ(seen.setup.scene.lights.size(), 2u);
    EXPECT_FALSE(anySays(seen.notes, "--camera"));
    try {
        openGltf(path, {.scene = {}, .camera = 2});
        FAIL() << "opened";
    } catch (const base::InputError& error) {
        expectSays(error.what(), "camera 2 does not exist, the scene has 2: 0 'eye', 1 'second'");
    }
}

TEST_F(GltfFolder, CamerasThatANodeFlattensAreSaid) {
    Document document = withCamera();
    document.root["nodes"][2]["scale"] = {1, 0, 1};
    const GltfImport result = load(document);
    EXPECT_EQ(result.cameras.size(), 1u);
    EXPECT_TRUE(
        anySays(result.ignored, "node 2: a camera is not used, because its transform is not invertible"));
}

TEST_F(GltfFolder, UnsoundCamerasAreRefused) {
    const auto withLens = [&](const json& perspective) {
        Document document = withCamera();
        document.root["cameras"][0]["perspective"] = perspective;
        return refusal(document);
    };
    expectSays(withLens({{"yfov", 4.0}, {"znear", 1.0}}), "camera 0 'eye': its yfov is 4.0");
    expectSays(withLens({{"yfov", 1.0}, {"znear", 0.0}}), "its znear is 0.0");
    expectSays(withLens({{"yfov", 1.0}, {"znear", "near"}}), "its znear is \"near\"");
    expectSays(withLens({{"yfov", 1.0}, {"znear", 2.0}, {"zfar", 2.0}}), "a znear that lies before its zfar");
    expectSays(withLens({{"znear", 2.0}}), "needs a yfov");
    expectSays(withLens(nullptr), "has no 'perspective' object");
    Document document = withCamera();
    document.root["cameras"][1]["type"] = "fisheye";
    expectSays(refusal(document), "type 'fisheye' does not exist");
    document = withCamera();
    document.root["nodes"][3]["camera"] = 7;
    expectSays(refusal(document), "camera 7 does not exist, the file has 3");
}

} // namespace
} // namespace cdr::scene::test
