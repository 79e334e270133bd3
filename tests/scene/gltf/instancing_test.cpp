#include "fixture.h"

#include <cdr/scene/gltf/open_gltf.h>

#include <cmath>
#include <ctime>
#include <string>

namespace cdr::scene::test {
namespace {

using GltfInstancing = GltfFolder;

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

/// The square of 2 by 4, copied to three places.
Document copied() {
    Document document = square();
    const int translation =
        document.addAccessor(std::vector<float>{0, 0, 0, 10, 0, 0, 0, 20, 0}, "VEC3", kFloat);
    const float half = std::sqrt(0.5f); // the last one is turned by 90 degrees about z
    const int rotation =
        document.addAccessor(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, half, half}, "VEC4", kFloat);
    const int scale = document.addAccessor(std::vector<float>{1, 1, 1, 2, 2, 2, 1, 1, 1}, "VEC3", kFloat);
    json& node = document.root["nodes"][0];
    node["name"] = "tile";
    node["translation"] = {100, 0, 0};
    node["extensions"][kInstancing]["attributes"] = {
        {"TRANSLATION", translation}, {"ROTATION", rotation}, {"SCALE", scale}};
    document.root["extensionsUsed"] = {kInstancing};
    document.root["extensionsRequired"] = {kInstancing};
    return document;
}

json& attributesOf(Document& document) {
    return document.root["nodes"][0]["extensions"][kInstancing]["attributes"];
}

TEST_F(GltfInstancing, EachCopyIsAnObject) {
    const GltfImport import = load(copied());
    EXPECT_TRUE(import.ignored.empty());
    const Instances& instances = import.scene.instances;
    ASSERT_EQ(instances.size(), 3u);
    EXPECT_EQ(import.scene.meshes.size(), 1u);
    EXPECT_EQ(import.scene.objectNames, (std::vector<std::string>{"tile 0", "tile 1", "tile 2"}));
    EXPECT_EQ(instances.object, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(instances.position(0), glm::dvec3(101, 2, 0)); // of the square's centre
    EXPECT_EQ(instances.position(1), glm::dvec3(112, 4, 0));
    EXPECT_NEAR(instances.x[2], 98.0, 1e-6);
    EXPECT_NEAR(instances.y[2], 21.0, 1e-6);
    EXPECT_EQ(instances.basis[1], glm::mat3(2.0f));
    EXPECT_NEAR(instances.basis[2][0].y, 1.0f, 1e-6f);
}

TEST_F(GltfInstancing, AttributesMayBeMissing) {
    Document document = copied();
    attributesOf(document).erase("ROTATION");
    attributesOf(document).erase("TRANSLATION");
    EXPECT_EQ(load(document).scene.instances.basis[1], glm::mat3(2.0f));
    attributesOf(document)["_ID"] = document.addAccessor(std::vector<float>{7, 8, 9}, "SCALAR", kFloat);
    attributesOf(document).erase("SCALE");
    EXPECT_EQ(load(document).scene.instances.size(), 3u);
    attributesOf(document).erase("_ID");
    expectSays(refusal(document), "has no attributes");
}

TEST_F(GltfInstancing, UnsoundOnesAreRefused) {
    const auto with = [&](const char* name, const json& value) {
        Document document = copied();
        attributesOf(document)[name] = value;
        return refusal(document);
    };
    expectSays(with("SCALE", 99), "accessor 99 does not exist");
    expectSays(with("SCALE", "x"), "'SCALE' is \"x\"");
    Document document = copied();
    attributesOf(document)["SCALE"] = document.addAccessor(std::vector<float>{1, 1, 1}, "VEC3", kFloat);
    expectSays(refusal(document), "have 3 and 1 elements");
    document = copied();
    attributesOf(document)["SCALE"] = attributesOf(document)["ROTATION"];
    expectSays(refusal(document), "SCALE of EXT_mesh_gpu_instancing has 4 components");
    document = copied();
    document.root["nodes"][0]["extensions"][kInstancing] = {{"attributes", 5}};
    EXPECT_NE(refusal(document), "loaded");
    document = copied();
    attributesOf(document)["ROTATION"] = document.addAccessor(std::vector<float>(12, 0.0f), "VEC4", kFloat);
    expectSays(refusal(document), "the rotation of its copy 0 has no direction");
    document = copied();
    attributesOf(document)["TRANSLATION"] =
        document.addAccessor(std::vector<float>{0, 0, 0, 0, 0, 0, NAN, 0, 0}, "VEC3", kFloat);
    expectSays(refusal(document), "the place of its copy 2 is not finite");
}

/// A few bytes can name many copies: elements without bytes are zeros.
TEST_F(GltfInstancing, CopiesAreBoundedBeforeTheyAreMade) {
    Document document = copied();
    for (const auto& [name, index] : attributesOf(document).items()) {
        json& accessor = document.root["accessors"][index.get<std::size_t>()];
        accessor.erase("bufferView");
        accessor["count"] = 10'000'000;
    }
    GltfLimits limits;
    limits.maxBytes = 1u << 20;
    expectSays(refusal(document, limits), "the import would take");
    limits = {};
    limits.maxTriangles = 5; // three copies of two triangles
    expectSays(refusal(copied(), limits), "repeats counted");
}

TEST_F(GltfInstancing, NoneAreNone) {
    Document document = copied();
    for (const auto& [name, index] : attributesOf(document).items()) {
        document.root["accessors"][index.get<std::size_t>()]["count"] = 0;
    }
    EXPECT_EQ(load(document).scene.instances.size(), 0u);
}

TEST_F(GltfInstancing, CopiesGoWithTheirNode) {
    Document document = copied();
    giveMove(document, 0, {0, 2}, {0, 0, 0, 0, 0, 50});
    GltfChoice choice;
    choice.seconds = 2.0;
    const Scene scene = openGltf(write("a.glb", document.glb()), choice).setup.scene;
    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(scene.instances.position(1), glm::dvec3(12, 4, 50));
    EXPECT_EQ(scene.instances.basis[1], glm::mat3(2.0f));
    EXPECT_NEAR(scene.instances.basis[2][0].y, 1.0f, 1e-6f);
}

/// All copies have the mesh's shape, each where it stands.
TEST_F(GltfInstancing, CopiesOfWhatDeformsShareTheirMesh) {
    Document document = copied();
    document.primitive()["targets"] = {
        {{"POSITION", document.addAccessor(std::vector<float>(12, 1.0f), "VEC3", kFloat)}}};
    document.root["meshes"][0]["weights"] = {1.0};
    document.root["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 500}}});
    document.root["scenes"][0]["nodes"].push_back(1);
    const GltfImport import = load(document);
    EXPECT_TRUE(import.ignored.empty());
    const Scene& scene = import.scene;
    ASSERT_EQ(scene.instances.size(), 4u);
    EXPECT_EQ(scene.instances.object, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(scene.instances.mesh, (std::vector<std::uint32_t>{0, 0, 0, 1}));
    const auto cornerOf = [&](std::size_t instance) {
        return scene.instances.position(instance) +
               glm::dmat3(scene.instances.basis[instance]) *
                   glm::dvec3(scene.meshes[scene.instances.mesh[instance]].vertices[2].position);
    };
    EXPECT_EQ(cornerOf(0), glm::dvec3(103, 5, 1));
    EXPECT_EQ(cornerOf(1), glm::dvec3(116, 10, 2));
    EXPECT_NEAR(cornerOf(2).x, 95.0, 1e-5);
    EXPECT_NEAR(cornerOf(2).y, 23.0, 1e-5);
    EXPECT_EQ(cornerOf(3), glm::dvec3(3, 5, 501));
}

TEST_F(GltfInstancing, CopiesOfASkinAreNoted) {
    Document document = copied();
    document.primitive()["attributes"]["JOINTS_0"] =
        document.addAccessor(std::vector<std::uint8_t>(16, 0), "VEC4", kUByte);
    document.setFloats("WEIGHTS_0", "VEC4", std::vector<float>(16, 0.25f));
    document.root["skins"] = {{{"joints", {0}}}};
    document.root["nodes"][0]["skin"] = 0;
    const GltfImport import = load(document);
    EXPECT_TRUE(
        anySays(import.ignored, "copies of a mesh with a skin are not drawn: no node places its joints"));
    EXPECT_EQ(import.scene.instances.size(), 0u);
}

/// Each copy asks whether the primitive has joints. Counting them each time took minutes.
TEST_F(GltfInstancing, CopiesTakeNoTimeByTheJointsOfTheirMesh) {
    Document document = copied();
    document.root["skins"] = {{{"joints", {0}}}};
    document.root["nodes"][0]["skin"] = 0;
    const int joints = document.addAccessor(std::vector<std::uint8_t>(16, 0), "VEC4", kUByte);
    const int weights = document.addAccessor(std::vector<float>(16, 0.25f), "VEC4", kFloat);
    for (int set = 0; set < 2000; ++set) {
        document.primitive()["attributes"]["JOINTS_" + std::to_string(set)] = joints;
        document.primitive()["attributes"]["WEIGHTS_" + std::to_string(set)] = weights;
    }
    attributesOf(document).erase("ROTATION");
    attributesOf(document).erase("SCALE");
    json& places = document.root["accessors"][attributesOf(document)["TRANSLATION"].get<std::size_t>()];
    places.erase("bufferView"); // so all are zeros
    places["count"] = 50'000;
    const std::clock_t start = std::clock();
    EXPECT_TRUE(anySays(load(document).ignored, "copies of a mesh with a skin are not drawn"));
    EXPECT_LT(std::clock() - start, 10 * CLOCKS_PER_SEC);
}

} // namespace
} // namespace cdr::scene::test
