#include "../../support/refusal.h"
#include "fixture.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace cdr::scene::test {
namespace {

using Gltf = GltfFolder;

/// World positions of the corners of a scene's first instance, triangle by triangle.
std::vector<glm::dvec3> worldCorners(const Scene& scene, std::size_t instance = 0) {
    const Instances& instances = scene.instances;
    const Mesh& mesh = scene.meshes.at(instances.mesh.at(instance));
    std::vector<glm::dvec3> corners;
    for (const std::uint32_t index : mesh.indices) {
        corners.push_back(instances.position(instance) + glm::dmat3(instances.basis[instance]) *
                                                             glm::dvec3(mesh.vertices.at(index).position));
    }
    return corners;
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
    EXPECT_NEAR(glm::length(a - b), 0.0, tolerance) << a.x << " " << a.y << " " << a.z;
}

TEST_F(Gltf, TriangleWithoutNormalsGetsFlatOnes) {
    const GltfImport result = load(triangle());
    ASSERT_EQ(result.scene.meshes.size(), 1u);
    ASSERT_EQ(result.scene.instances.size(), 1u);
    EXPECT_TRUE(result.ignored.empty());
    const Mesh& mesh = result.scene.meshes[0];
    ASSERT_EQ(mesh.vertices.size(), 3u);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2}));
    for (const Vertex& vertex : mesh.vertices) {
        EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
        EXPECT_EQ(vertex.uv, glm::vec2(0));
        EXPECT_EQ(vertex.color, glm::u8vec4(255));
    }
    expectNear(worldCorners(result.scene)[2], {2, 4, 0});
}

TEST_F(Gltf, FlatNormalsUnshareVertices) {
    Document document = square();
    document.primitive()["attributes"].erase("NORMAL");
    const Scene scene = load(document).scene;
    EXPECT_EQ(scene.meshes[0].vertices.size(), 6u);
    expectNear(worldCorners(scene)[5], {0, 4, 0});
}

TEST_F(Gltf, MeshIsStoredAboutItsCentre) {
    const Scene scene = load(square()).scene;
    const Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(mesh.vertices[0].position, glm::vec3(-1, -2, 0));
    EXPECT_NEAR(mesh.boundingRadius, std::sqrt(5.0f), 1e-6f);
    EXPECT_GE(static_cast<double>(mesh.boundingRadius), std::sqrt(5.0));
    expectNear(scene.instances.position(0), {1, 2, 0}, 0.0);
}

TEST_F(Gltf, OnlyVerticesThatAreDrawnCount) {
    Document document = square();
    std::vector<float> positions = corners(true);
    positions.insert(positions.end(), {1e6f, 0, 0});
    document.setFloats("POSITION", "VEC3", positions);
    document.setFloats("NORMAL", "VEC3", std::vector<float>(15, 1.0f));
    const Mesh mesh = load(document).scene.meshes.at(0);
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_LT(mesh.boundingRadius, 3.0f);
}

TEST_F(Gltf, PrimitivesMayShareOneLargeVertexBuffer) {
    Document document = square();
    json second = document.primitive();
    second["indices"] = document.addAccessor(std::vector<std::uint8_t>{1, 2, 3}, "SCALAR", kUByte);
    document.root["meshes"][0]["primitives"].push_back(second);
    const Scene scene = load(document).scene;
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.meshes[1].vertices.size(), 3u);
    expectNear(worldCorners(scene, 1)[0], {2, 0, 0});
    EXPECT_EQ(scene.instances.object, (std::vector<std::uint32_t>{0, 1})) << "each primitive is an object";
}

TEST_F(Gltf, FarVerticesKeepTheirPrecision) {
    Document document = triangle();
    document.setFloats("POSITION", "VEC3", {1e6f, 0, 0, 1e6f + 2, 0, 0, 1e6f + 2, 4, 0});
    document.root["nodes"][0]["translation"] = {1e9, 0, 0.001};
    const Scene scene = load(document).scene;
    EXPECT_EQ(scene.meshes[0].vertices[0].position, glm::vec3(-1, -2, 0));
    expectNear(scene.instances.position(0), {1e9 + 1e6 + 1, 2, 0.001}, 0.0);
}

TEST_F(Gltf, IndicesOfAllSizes) {
    Document document = square();
    const auto expectSquare = [&](int accessor) {
        document.primitive()["indices"] = accessor;
        const Scene scene = load(document).scene;
        expectNear(worldCorners(scene).at(5), {0, 4, 0});
    };
    expectSquare(document.addAccessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, "SCALAR", kUByte));
    expectSquare(document.addAccessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, "SCALAR", kUShort));
    expectSquare(document.addAccessor(std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}, "SCALAR", kUInt));
}

TEST_F(Gltf, StripsAndFansFaceTheSameWay) {
    Document document = square();
    document.primitive()["mode"] = kStrip;
    document.primitive()["indices"] =
        document.addAccessor(std::vector<std::uint8_t>{0, 1, 3, 2}, "SCALAR", kUByte);
    const auto expectFronts = [&] {
        const std::vector<glm::dvec3> corners = worldCorners(load(document).scene);
        ASSERT_EQ(corners.size(), 6u);
        double area = 0.0;
        for (std::size_t i = 0; i < 6; i += 3) {
            const double z = glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]).z;
            EXPECT_GT(z, 0.0);
            area += z / 2.0;
        }
        EXPECT_DOUBLE_EQ(area, 8.0);
    };
    expectFronts();
    document.primitive()["mode"] = kFan;
    document.primitive()["indices"] =
        document.addAccessor(std::vector<std::uint8_t>{0, 1, 2, 3}, "SCALAR", kUByte);
    expectFronts();
    document.primitive().erase("indices");
    expectFronts();
}

TEST_F(Gltf, ModesThatDoNotExistAreRefused) {
    expectRefused(square(), "/meshes/0/primitives/0/mode", 7, "mode 7 does not exist");
}

TEST_F(Gltf, IndicesThatAreNoAccessorAreRefused) {
    for (const json& unsound :
         {json::object(), json{{"bufferView", 0}}, json::array(), json("0"), json(-1)}) {
        expectRefused(square(), "/meshes/0/primitives/0/indices", unsound, "'indices' is ");
    }
}

TEST_F(Gltf, RestOfATriangleListIsDropped) {
    Document document = square();
    document.primitive()["indices"] =
        document.addAccessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2}, "SCALAR", kUByte);
    EXPECT_EQ(load(document).scene.meshes[0].indices.size(), 3u);
    document.primitive()["indices"] = document.addAccessor(std::vector<std::uint8_t>{0, 1}, "SCALAR", kUByte);
    const GltfImport result = load(document);
    EXPECT_EQ(result.scene.instances.size(), 0u);
    EXPECT_EQ(result.scene.objectNames.size(), 1u) << "an object keeps its number even when nothing is drawn";
    EXPECT_TRUE(anySays(result.ignored, "has no triangles"));
}

TEST_F(Gltf, NormalsAreMadeUnitLength) {
    Document document = square();
    document.setFloats("NORMAL", "VEC3", {0, 9, 0, 0, 0, 0, std::nanf(""), 0, 0, 0, 0, -2});
    const GltfImport result = load(document);
    EXPECT_EQ(result.scene.meshes[0].vertices[0].normal, glm::vec3(0, 1, 0));
    EXPECT_EQ(result.scene.meshes[0].vertices[1].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(result.scene.meshes[0].vertices[2].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(result.scene.meshes[0].vertices[3].normal, glm::vec3(0, 0, -1));
    EXPECT_TRUE(anySays(result.ignored, "a normal has no direction"));
}

TEST_F(Gltf, ColoursOfAllTypes) {
    Document document = square();
    const auto colour = [&](int accessor) {
        document.primitive()["attributes"]["COLOR_0"] = accessor;
        return load(document).scene.meshes[0].vertices[1].color;
    };
    EXPECT_EQ(colour(document.addAccessor(std::vector<float>{1, 1, 1, 0.5f, -3, 7, 1, 1, 1, 1, 1, 1}, "VEC3",
                                          kFloat)),
              glm::u8vec4(128, 0, 255, 255));
    const int bytes = document.addAccessor(
        std::vector<std::uint8_t>{9, 9, 9, 9, 10, 20, 30, 40, 9, 9, 9, 9, 9, 9, 9, 9}, "VEC4", kUByte);
    document.root["accessors"].back()["normalized"] = true;
    EXPECT_EQ(colour(bytes), glm::u8vec4(10, 20, 30, 40));
    const int shorts = document.addAccessor(
        std::vector<std::uint16_t>{0, 0, 0, 65535, 32768, 257, 0, 0, 0, 0, 0, 0}, "VEC3", kUShort);
    document.root["accessors"].back()["normalized"] = true;
    EXPECT_EQ(colour(shorts), glm::u8vec4(255, 128, 1, 255));
}

TEST_F(Gltf, QuantizedPositionsAndUvs) {
    Document document = square();
    document.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    document.primitive()["attributes"]["POSITION"] = document.addAccessor(
        std::vector<std::int16_t>{0, 0, 0, 200, 0, 0, 200, 400, 0, 0, 400, 0}, "VEC3", kShort);
    const int uv =
        document.addAccessor(std::vector<std::int8_t>{0, 0, 127, -127, -128, 64, 0, 0}, "VEC2", kByte);
    document.root["accessors"].back()["normalized"] = true;
    document.primitive()["attributes"]["TEXCOORD_0"] = uv;
    const Scene scene = load(document).scene;
    expectNear(worldCorners(scene)[2], {200, 400, 0});
    EXPECT_EQ(scene.meshes[0].vertices[1].uv, glm::vec2(1, -1));
    EXPECT_EQ(scene.meshes[0].vertices[2].uv.x, -1.0f);
}

TEST_F(Gltf, InterleavedAttributesAtAnyAlignment) {
    Document document = triangle();
    // 2 bytes in front, then 12 of position and 4 of something else, so that floats lie at odd addresses.
    Bytes bytes(2);
    const std::vector<float> positions = corners(false);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto* first = reinterpret_cast<const std::uint8_t*>(&positions[3 * i]);
        bytes.insert(bytes.end(), first, first + 12);
        bytes.insert(bytes.end(), {0xff, 0xff, 0xff, 0xff});
    }
    const int view = document.addView(bytes);
    document.root["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 16;
    document.root["accessors"][0]["bufferView"] = view;
    document.root["accessors"][0]["byteOffset"] = 2;
    expectNear(worldCorners(load(document).scene)[2], {2, 4, 0});
    document.root["accessors"][0]["byteOffset"] = 7;
    expectSays(refusal(document), "do not fit its buffer view");
}

TEST_F(Gltf, SparseAccessors) {
    Document document = square();
    json& accessor = document.root["accessors"][0];
    accessor["sparse"] = {
        {"count", 2},
        {"indices",
         {{"bufferView", document.addView(std::vector<std::uint16_t>{1, 2})}, {"componentType", kUShort}}},
        {"values", {{"bufferView", document.addView(std::vector<float>{8, 0, 0, 8, 4, 0})}}}};
    expectNear(worldCorners(load(document).scene)[1], {8, 0, 0});
    expectNear(worldCorners(load(document).scene)[0], {0, 0, 0});
    // Without a buffer view the rest is zero.
    document.root["accessors"][0].erase("bufferView");
    expectNear(worldCorners(load(document).scene)[5], {0, 0, 0});
}

/// A list is looked through once, and its end is compared with each accessor's.
TEST_F(Gltf, SparseAccessorsThatShareAListAreEachChecked) {
    Document document = square();
    json& accessors = document.root["accessors"];
    const json list = {{"bufferView", document.addView(std::vector<std::uint16_t>{1, 3})},
                       {"componentType", kUShort}};
    const json values = {{"bufferView", document.addView(std::vector<float>(6, 5.0f))}};
    const json sparse = {{"count", 2}, {"indices", list}, {"values", values}};
    accessors[0]["sparse"] = sparse;
    json other = accessors[0];
    other["count"] = 3;
    accessors.push_back(other);
    json& primitives = document.root["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives[1]["attributes"] = {{"POSITION", accessors.size() - 1}};
    expectSays(refusal(document), "do not increase or exceed its 3");
    accessors.back()["count"] = 4;
    expectNear(worldCorners(load(document).scene)[1], {5, 5, 5});
}

TEST_F(Gltf, UnsoundSparseAccessorsAreRefused) {
    const auto tryIndices = [&](const std::vector<std::uint16_t>& indices, int count) {
        Document document = square();
        document.root["accessors"][0]["sparse"] = {
            {"count", count},
            {"indices", {{"bufferView", document.addView(indices)}, {"componentType", kUShort}}},
            {"values", {{"bufferView", document.addView(std::vector<float>(6))}}}};
        return refusal(document);
    };
    expectSays(tryIndices({2, 1}, 2), "do not increase");
    expectSays(tryIndices({1, 4}, 2), "do not increase or exceed its 4");
    expectSays(tryIndices({0, 1, 2}, 3), "do not fit its buffer view");
    expectSays(tryIndices({0, 1}, 5), "its sparse part has 5 elements of 4");
    expectSays(tryIndices({0, 1}, 0), "its sparse part has 0 elements");
}

/// Lists that begin at different bytes are each read, so that few bytes could be read for hours.
TEST_F(Gltf, SparseListsThatOverlapAreBounded) {
    constexpr int kCount = 1 << 20;
    constexpr int kLists = 130;
    std::vector<std::uint32_t> indices(kCount + kLists);
    std::iota(indices.begin(), indices.end(), 0u);
    Document document = square();
    const int view = document.addView(indices);
    const int values = document.addView(std::vector<std::uint8_t>(kCount));
    json& primitives = document.root["meshes"][0]["primitives"];
    for (int i = 0; i < kLists; ++i) {
        primitives.push_back(primitives[0]);
        primitives.back()["indices"] = document.root["accessors"].size();
        document.root["accessors"].push_back(
            {{"componentType", kUByte},
             {"count", kCount + kLists},
             {"type", "SCALAR"},
             {"sparse",
              {{"count", kCount},
               {"indices", {{"bufferView", view}, {"byteOffset", 4 * i}, {"componentType", kUInt}}},
               {"values", {{"bufferView", values}}}}}});
    }
    const Bytes file = document.glb();
    expectSays(cdr::test::inputErrorOf([&] { loadGltf(std::as_bytes(std::span(file)), "a.glb"); }, "loaded"),
               "its sparse indices and those of accessors before it are over the limit of 134217728");
}

TEST_F(Gltf, PositionsThatAreNotFiniteAreRefused) {
    for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
        Document document = triangle();
        document.setFloats("POSITION", "VEC3", {0, 0, 0, 1, bad, 0, 0, 1, 0});
        expectSays(refusal(document), "the position of vertex 1 is not finite");
    }
}

TEST_F(Gltf, ExtentOverWhatIsDrawnIsRefused) {
    for (const float big : {1e25f, std::numeric_limits<float>::max()}) {
        Document document = triangle();
        document.setFloats("POSITION", "VEC3", {-big, -big, -big, big, big, big, 0, 1, 0});
        expectSays(refusal(document), "mesh 0 '' primitive 0: its bounding radius must lie in [0, 1e20]");
    }
}

TEST_F(Gltf, PrimitiveWithoutExtentIsNotDrawn) {
    Document document = triangle();
    document.setFloats("POSITION", "VEC3", std::vector<float>(9, 5.0f));
    const GltfImport result = load(document);
    EXPECT_EQ(result.scene.instances.size(), 0u);
    EXPECT_TRUE(anySays(result.ignored, "has no extent"));
}

/// glTF advises not to draw such a primitive, and the others of a file are of use.
TEST_F(Gltf, PrimitiveWithoutPositionsIsNotDrawn) {
    Document document = square();
    json& primitives = document.root["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives[1]["attributes"].erase("POSITION");
    const GltfImport result = load(document);
    EXPECT_EQ(result.scene.instances.object, (std::vector<std::uint32_t>{0}));
    EXPECT_TRUE(anySays(result.ignored, "primitive 1: not drawn, because it has no positions"));
    // An extension may have them.
    primitives[1]["extensions"] = {{"EXT_packed", json::object()}};
    EXPECT_TRUE(anySays(load(document).ignored, "no positions of it can be read"));
}

TEST_F(Gltf, UnsoundAttributesAreRefused) {
    Document document = square();
    document.setFloats("NORMAL", "VEC3", std::vector<float>(9, 1.0f));
    expectSays(refusal(document), "an attribute has 3 elements for 4 positions");

    document = square();
    document.setFloats("POSITION", "VEC2", std::vector<float>(8));
    expectSays(refusal(document), "POSITION has 2 components");

    document = square();
    document.primitive()["indices"] = document.addAccessor(std::vector<float>{0, 1, 2}, "SCALAR", kFloat);
    expectSays(refusal(document), "cannot hold vertex indices");

    document = square();
    document.primitive()["indices"] =
        document.addAccessor(std::vector<std::uint8_t>{0, 1, 4}, "SCALAR", kUByte);
    expectSays(refusal(document), "index 4 exceeds its 4 vertices");

    expectRefused(triangle(), "/accessors/0/componentType", 5127, "component type 5127 does not exist");
}

} // namespace
} // namespace cdr::scene::test
