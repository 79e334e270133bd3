#include "draco_fixture.h"

#include <array>
#include <cmath>

namespace cdr::scene::test {
namespace {

using GltfDraco = GltfFolder;

constexpr int kSequential = draco::MESH_SEQUENTIAL_ENCODING;
constexpr int kEdgebreaker = draco::MESH_EDGEBREAKER_ENCODING;

/// A bumpy cloth with all that a vertex may have. Its texture is cut down the middle, where vertices lie on each other.
Document cloth() {
    constexpr int kColumns = 8;
    constexpr int kRows = 9;
    std::vector<float> positions;
    std::vector<float> normals;
    std::vector<float> tangents;
    std::vector<float> uv;
    std::vector<std::uint16_t> secondUv;
    std::vector<std::uint8_t> colors;
    std::vector<std::uint16_t> indices;
    for (const int half : {0, 1}) {
        for (int row = 0; row < kRows; ++row) {
            for (int column = 0; column <= kColumns; ++column) {
                const auto x = static_cast<float>(column + half * kColumns);
                const auto y = static_cast<float>(row);
                positions.insert(positions.end(), {x, y, std::sin(0.7f * x) * std::cos(0.5f * y)});
                const glm::vec3 tangent =
                    glm::normalize(glm::vec3(1.0f, 0.0f, 0.7f * std::cos(0.7f * x) * std::cos(0.5f * y)));
                const glm::vec3 along =
                    glm::normalize(glm::vec3(0.0f, 1.0f, -0.5f * std::sin(0.7f * x) * std::sin(0.5f * y)));
                const glm::vec3 normal = glm::normalize(glm::cross(tangent, along));
                normals.insert(normals.end(), {normal.x, normal.y, normal.z});
                tangents.insert(tangents.end(), {tangent.x, tangent.y, tangent.z, half == 0 ? 1.0f : -1.0f});
                uv.insert(uv.end(), {static_cast<float>(column) / kColumns, y / kRows});
                secondUv.insert(secondUv.end(), {static_cast<std::uint16_t>(4000.0f * x),
                                                 static_cast<std::uint16_t>(7000.0f * y)});
                colors.insert(colors.end(), {static_cast<std::uint8_t>(15.0f * x),
                                             static_cast<std::uint8_t>(28.0f * y), 200, 255});
            }
        }
        for (int row = 0; row + 1 < kRows; ++row) {
            for (int column = 0; column < kColumns; ++column) {
                const int corner = half * kRows * (kColumns + 1) + row * (kColumns + 1) + column;
                for (const int offset : {0, 1, kColumns + 2, 0, kColumns + 2, kColumns + 1}) {
                    indices.push_back(static_cast<std::uint16_t>(corner + offset));
                }
            }
        }
    }
    Document document;
    const json attributes = {{"POSITION", document.addAccessor(positions, "VEC3", kFloat)},
                             {"NORMAL", document.addAccessor(normals, "VEC3", kFloat)},
                             {"TANGENT", document.addAccessor(tangents, "VEC4", kFloat)},
                             {"TEXCOORD_0", document.addAccessor(uv, "VEC2", kFloat)},
                             {"TEXCOORD_1", document.addAccessor(secondUv, "VEC2", kUShort)},
                             {"COLOR_0", document.addAccessor(colors, "VEC4", kUByte)}};
    const int list = document.addAccessor(indices, "SCALAR", kUShort);
    document.root["accessors"][4]["normalized"] = true;
    document.root["accessors"][5]["normalized"] = true;
    document.root["meshes"] = {
        {{"primitives", {{{"attributes", attributes}, {"indices", list}, {"material", 0}}}}}};
    document.root["nodes"] = {{{"mesh", 0}}};
    document.root["scenes"] = {{{"nodes", {0}}}};
    document.root["scene"] = 0;
    giveNormalTexture(document);
    document.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                   {"normalTexture", {{"index", 0}}},
                                   {"occlusionTexture", {{"index", 0}, {"texCoord", 1}}}}};
    return document;
}

/// Corners of triangles, with what each vertex has.
struct Corner {
    glm::dvec3 position;
    Vertex vertex;
    VertexDetail detail;
};

std::vector<std::array<Corner, 3>> trianglesOf(const Scene& scene) {
    const Mesh& mesh = scene.meshes.at(scene.instances.mesh.at(0));
    std::vector<std::array<Corner, 3>> triangles(mesh.indices.size() / 3);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t index = mesh.indices[i];
        const Vertex& vertex = mesh.vertices[index];
        triangles[i / 3][i % 3] = {scene.instances.position(0) + glm::dvec3(vertex.position), vertex,
                                   mesh.details.empty() ? VertexDetail{} : mesh.details[index]};
    }
    return triangles;
}

double distanceOf(const std::array<Corner, 3>& a, const std::array<Corner, 3>& b, std::size_t turn) {
    double distance = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
        distance = std::max(distance, glm::distance(a[c].position, b[(c + turn) % 3].position));
    }
    return distance;
}

/// Expects the same triangles, in any order and from any corner on, to within what quantisation makes of them.
void expectSameTriangles(const Scene& found, const Scene& wanted, const DracoOptions& options) {
    constexpr float kExtent = 17.0f; // of the positions
    // Components are rounded by themselves; a tangent and a normal are made of length one again.
    const float tolerance = dracoTolerance(options) + 1e-6f;
    const auto rest = trianglesOf(wanted);
    const auto triangles = trianglesOf(found);
    ASSERT_EQ(triangles.size(), rest.size());
    for (const auto& triangle : triangles) {
        double least = 1e9;
        const std::array<Corner, 3>* match = nullptr;
        std::size_t turn = 0;
        for (const auto& candidate : rest) {
            for (std::size_t t = 0; t < 3; ++t) {
                if (const double distance = distanceOf(triangle, candidate, t); distance < least) {
                    least = distance;
                    match = &candidate;
                    turn = t;
                }
            }
        }
        ASSERT_LT(least, kExtent * tolerance);
        for (std::size_t c = 0; c < 3; ++c) {
            const Corner& is = triangle[c];
            const Corner& was = (*match)[(c + turn) % 3];
            ASSERT_LT(glm::distance(is.vertex.uv, was.vertex.uv), 2.0f * tolerance);
            ASSERT_LT(glm::distance(is.detail.uv, was.detail.uv), 1e-6f) << "an integer is kept";
            ASSERT_EQ(is.vertex.color, was.vertex.color);
            ASSERT_LT(glm::distance(is.vertex.normal, was.vertex.normal), 8.0f * tolerance);
            ASSERT_LT(glm::distance(is.detail.tangent, was.detail.tangent), 8.0f * tolerance);
        }
    }
}

TEST_F(GltfDraco, GivesTheMeshThatWasCompressed) {
    const Scene wanted = load(cloth()).scene;
    ASSERT_FALSE(wanted.meshes.at(0).details.empty());
    for (const int speed : {0, 3, 5, 7, 10}) {
        for (const int bits : {0, 12, 16}) {
            for (const DracoOptions& options :
                 {DracoOptions{.method = kSequential, .speed = speed, .bits = bits},
                  DracoOptions{.method = kEdgebreaker,
                  .submethod = draco::MESH_EDGEBREAKER_STANDARD_ENCODING,
                  .speed = speed,
                  .bits = bits},
                  DracoOptions{.method = kEdgebreaker,
                  .submethod = draco::MESH_EDGEBREAKER_VALENCE_ENCODING,
                  .speed = speed,
                  .bits = bits}}) {
                SCOPED_TRACE(testing::Message()
                             << "method " << options.method << ", submethod "
                             << options.submethod.value_or(-1) << ", speed " << speed << ", bits " << bits);
                const GltfImport import = load(compressed(cloth(), options));
                EXPECT_TRUE(import.ignored.empty());
                expectSameTriangles(import.scene, wanted, options);
            }
        }
    }
}

TEST_F(GltfDraco, MetadataIsPassedOver) {
    const Scene wanted = load(cloth()).scene;
    for (const int method : {kSequential, kEdgebreaker}) {
        const DracoOptions options{.method = method, .metadata = true};
        const Document document = compressed(cloth(), options);
        EXPECT_NE(std::search(document.bin.begin(), document.bin.end(), "innermost", "innermost" + 9),
                  document.bin.end());
        expectSameTriangles(load(document).scene, wanted, options);
    }
}

/// A square whose right half follows a second joint, by weights of 16 bits, and that has a morph target.
Document deformed() {
    Document document = square();
    const int weights = document.addAccessor(
        std::vector<std::uint16_t>{16384, 49151, 0, 0, 65535, 0, 0, 0, 65535, 0, 0, 0, 65535, 0, 0, 0},
        "VEC4", kUShort);
    document.root["accessors"].back()["normalized"] = true;
    const int target =
        document.addAccessor(std::vector<float>{0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4}, "VEC3", kFloat);
    document.primitive()["targets"] = {{{"POSITION", target}}};
    document.root["meshes"][0]["weights"] = {0.5};
    giveSkin(document, {0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, weights,
             {{{"mesh", 0}, {"skin", 0}}, {{"name", "low"}}, {{"name", "high"}, {"translation", {0, 1, 0}}}});
    return document;
}

TEST_F(GltfDraco, JointsWeightsAndMorphTargetsComeThrough) {
    const DracoOptions options{.method = kSequential, .bits = 0};
    const GltfImport wanted = load(deformed());
    const GltfImport found = load(compressed(deformed(), options));
    ASSERT_NE(found.animation, nullptr);
    EXPECT_EQ(found.ignored, wanted.ignored);
    EXPECT_GT(trianglesOf(wanted.scene)[0][0].position.z, 0.4);
    EXPECT_EQ(trianglesOf(wanted.scene)[0][0].position.y, trianglesOf(found.scene)[0][0].position.y);
    expectSameTriangles(found.scene, wanted.scene, options);
}

TEST_F(GltfDraco, AnAttributeBesideTheStreamIsReadToo) {
    Document document = compressed(square(), {.method = kSequential, .bits = 0});
    document.setFloats("COLOR_0", "VEC3", {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1});
    const Scene scene = load(document).scene;
    EXPECT_EQ(trianglesOf(scene)[0][1].vertex.color, glm::u8vec4(0, 255, 0, 255));
}

TEST_F(GltfDraco, TwoPrimitivesHaveStreamsOfTheirOwn) {
    Document document = compressed(square(), {});
    const json first = document.primitive();
    json second = square().primitive();
    Document other = square();
    second["attributes"]["POSITION"] =
        document.addAccessor(std::vector<float>{0, 0, 9, 2, 0, 9, 2, 4, 9, 0, 4, 9}, "VEC3", kFloat);
    second["attributes"].erase("NORMAL");
    second["indices"] = document.addAccessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, "SCALAR", kUShort);
    const std::unique_ptr<draco::Mesh> mesh = dracoMesh(document, second, 7);
    useDraco(document, second, dracoStream(*mesh, {}), 7);
    document.root["meshes"][0]["primitives"] = {first, second, first};
    const Scene scene = load(document).scene;
    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_NEAR(scene.instances.position(0).z, 0.0, 1e-3);
    EXPECT_NEAR(scene.instances.position(1).z, 9.0, 1e-3);
    EXPECT_NEAR(scene.instances.position(2).z, 0.0, 1e-3);
}

/// What was decoded is freed before the next primitive is, so that more of them take what is kept in the scene alone.
TEST_F(GltfDraco, DecodedPrimitivesAreNotKept) {
    Document document = compressed(cloth(), {.method = kSequential, .bits = 0});
    const json primitive = document.primitive();
    const auto leastLimit = [&](std::size_t primitives) {
        document.root["meshes"][0]["primitives"] = std::vector<json>(primitives, primitive);
        std::uint64_t refused = 0;
        GltfLimits limits;
        while (limits.maxBytes - refused > 1) {
            const std::uint64_t middle = refused + (limits.maxBytes - refused) / 2;
            (refusal(document, {.maxBytes = middle}) == "loaded" ? limits.maxBytes : refused) = middle;
        }
        return limits.maxBytes;
    };
    const std::uint64_t difference = leastLimit(9) - leastLimit(1);
    const Scene scene = load(document).scene;
    const Mesh& mesh = scene.meshes.at(0);
    constexpr std::size_t kInstance = 700; // and its name
    EXPECT_LE(difference, 8 * (2 * mesh.vertices.size() * (sizeof(Vertex) + sizeof(VertexDetail)) +
                               mesh.indices.size() * sizeof(std::uint32_t) + kInstance));
}

TEST_F(GltfDraco, WithoutBeingRequiredItIsDecodedWhereNothingElseIs) {
    Document document = compressed(cloth(), {});
    document.root.erase("extensionsRequired");
    const Scene wanted = load(cloth()).scene;
    expectSameTriangles(load(document).scene, wanted, {});
    document.root.erase("extensionsUsed"); // which says nothing about what there is
    expectSameTriangles(load(document).scene, wanted, {});
}

TEST_F(GltfDraco, RequiredItIsDecodedBesideACopy) {
    Document document = compressed(square(), {.method = kSequential});
    const Document plain = square();
    json& accessors = document.root["accessors"];
    for (std::size_t i = 0; i < accessors.size(); ++i) {
        accessors[i]["bufferView"] = plain.root["accessors"][i]["bufferView"];
    }
    EXPECT_EQ(refusal(document), "loaded");
    const json& view = document.root["bufferViews"].back();
    document.bin[view["byteOffset"].get<std::size_t>()] = 'X';
    expectSays(refusal(document), "holds no Draco stream");
    document.root.erase("extensionsRequired");
    EXPECT_EQ(refusal(document), "loaded") << "the copy is read";
}

TEST_F(GltfDraco, AccessorsThatAreNotWhatItHoldsAreRefused) {
    const auto with = [&](const char* name, const char* key, const json& value) {
        Document document = compressed(square(), {.method = kSequential});
        const json& primitive = document.primitive();
        const json& index =
            std::string(name) == "indices" ? primitive["indices"] : primitive["attributes"][name];
        document.root["accessors"][index.get<std::size_t>()][key] = value;
        return refusal(document);
    };
    EXPECT_EQ(
        with("POSITION", "count", 5),
        "mesh 0 '' primitive 0: KHR_draco_mesh_compression holds 4 vertices, and its attributes have 5");
    EXPECT_EQ(
        with("NORMAL", "count", 3),
        "mesh 0 '' primitive 0: KHR_draco_mesh_compression holds NORMAL of 4 elements of 3 components of "
        "type 5126, and accessor 1 has 3 of 3 of type 5126");
    expectSays(with("NORMAL", "type", "VEC4"), "and accessor 1 has 4 of 4 of type 5126");
    expectSays(with("NORMAL", "componentType", kByte), "and accessor 1 has 4 of 3 of type 5120");
    expectSays(with("indices", "count", 9), "holds 2 triangles, and its indices make 3");
    expectSays(with("indices", "count", 5), "its 5 indices make no triangles");
    expectSays(with("indices", "componentType", kFloat), "cannot hold vertex indices");
    const json sparse = {{"count", 1},
                         {"indices", {{"bufferView", 2}, {"componentType", kUShort}}},
                         {"values", {{"bufferView", 0}}}};
    expectSays(with("POSITION", "sparse", sparse),
               "is sparse, and KHR_draco_mesh_compression holds the rest");
}

TEST_F(GltfDraco, IndicesBeyondTheirTypeAreRefused) {
    Document document = compressed(cloth(), {.method = kSequential}); // 162 vertices
    document.root["accessors"][6]["componentType"] = kUByte;
    EXPECT_EQ(refusal(document), "loaded");
    std::vector<float> positions(900, 0.5f);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        positions[i] = static_cast<float>((i * i) % 97);
    }
    std::vector<std::uint16_t> indices(300);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        indices[i] = static_cast<std::uint16_t>(i);
    }
    Document many;
    many.root = triangle().root;
    many.root["accessors"].clear();
    many.root["bufferViews"].clear();
    many.setFloats("POSITION", "VEC3", positions);
    many.primitive()["indices"] = many.addAccessor(indices, "SCALAR", kUShort);
    many = compressed(many, {.method = kSequential});
    EXPECT_EQ(refusal(many), "loaded");
    many.root["accessors"][1]["componentType"] = kUByte;
    expectSays(refusal(many), "holds index 256, over 300 vertices or the component type of accessor 1");
}

TEST_F(GltfDraco, UnsoundExtensionsAreRefused) {
    const auto with = [&](const auto& change) {
        Document document = compressed(square(), {.method = kSequential});
        change(document.primitive());
        return refusal(document);
    };
    const auto extended = [&](const char* key, const json& value) {
        return with([&](json& primitive) { primitive["extensions"][kDraco][key] = value; });
    };
    expectSays(extended("bufferView", 99), "buffer view 99 does not exist");
    for (const json& unsound : {json("x"), json(-1), json(nullptr), json::array()}) {
        EXPECT_NE(extended("bufferView", unsound), "loaded") << unsound;
        EXPECT_NE(extended("attributes", {{"POSITION", unsound}}), "loaded") << unsound;
    }
    for (const json& unsound : {json("x"), json(5)}) {
        EXPECT_NE(extended("attributes", unsound), "loaded") << unsound;
    }
    Document without = compressed(square(), {.method = kSequential});
    without.primitive()["extensions"][kDraco]["attributes"] = json::object();
    EXPECT_TRUE(anySays(load(without).ignored, "no positions of it can be read"));
    EXPECT_EQ(extended("attributes", {{"POSITION", 50}, {"NORMAL", 8}}),
              "mesh 0 '' primitive 0: KHR_draco_mesh_compression holds no attribute 50, which POSITION is");
    expectSays(with([](json& primitive) { primitive["mode"] = kPoints; }),
               "holds what is of mode 0, and only lists of triangles (4) are read");
    expectSays(with([](json& primitive) { primitive["mode"] = kStrip; }), "is of mode 5");
    expectSays(with([](json& primitive) { primitive.erase("indices"); }), "needs indices and positions");
    expectSays(with([](json& primitive) { primitive["attributes"].erase("POSITION"); }), "needs indices");
    EXPECT_EQ(extended("attributes", {{"POSITION", 8}, {"NORMAL", 7}, {"COLOR_9", 77}}), "loaded")
        << "nothing reads COLOR_9";
}

} // namespace
} // namespace cdr::scene::test
