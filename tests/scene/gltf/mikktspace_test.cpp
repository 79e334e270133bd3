#include "fixture.h"

#include <cdr/scene/gltf/materials/mikktspace_tangents.h>
#include <cdr/scene/gltf/materials/tangents.h>
#include <cdr/scene/gltf/mikktspace/module.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <thread>
#include <tuple>

namespace cdr::scene::test {
namespace {

using gltf::TangentCorner;

constexpr std::uint64_t kPlenty = std::uint64_t{1} << 30u;
constexpr auto kFirst = gltf::UvPlaces::Tangents::first;
constexpr const char* kAbsent = "cdr was built without MikkTSpace: third_party/mikktspace.sh fetches it";

class GltfMikkTSpace : public GltfFolder {
  protected:
    void SetUp() override {
        GltfFolder::SetUp();
        if (!gltf::hasMikkTSpace()) {
            GTEST_SKIP() << kAbsent;
        }
    }
};

using CornerAt = std::function<TangentCorner(double, double)>;

/// A grid of `columns` x `rows` cells, indexed, of corners from (0, 0) to (1, 1).
SourceMesh grid(std::uint32_t columns, std::uint32_t rows, const CornerAt& cornerAt) {
    SourceMesh mesh;
    for (std::uint32_t y = 0; y <= rows; ++y) {
        for (std::uint32_t x = 0; x <= columns; ++x) {
            const TangentCorner corner = cornerAt(1.0 * x / columns, 1.0 * y / rows);
            mesh.vertices.push_back({.position = corner.position,
                                     .normal = glm::normalize(corner.normal),
                                     .uv = corner.uv,
                                     .color = glm::u8vec4(255)});
        }
    }
    mesh.details.resize(mesh.vertices.size());
    for (std::uint32_t y = 0; y < rows; ++y) {
        for (std::uint32_t x = 0; x < columns; ++x) {
            const std::uint32_t at = y * (columns + 1) + x;
            mesh.indices.insert(mesh.indices.end(),
                                {at, at + 1, at + columns + 2, at, at + columns + 2, at + columns + 1});
        }
    }
    return mesh;
}

glm::vec2 downwards(double u, double v) {
    return {u, 1.0 - v};
}

SourceMesh plane() {
    return grid(3, 2, [](double x, double y) -> TangentCorner {
        return {{2 * x, y, 0}, {0, 0, 1}, downwards(x, y)};
    });
}

/// Bumps whose texture is stretched and turned.
SourceMesh bumps() {
    return grid(9, 7, [](double x, double y) -> TangentCorner {
        const double a = 5 * x;
        const double b = 4 * y;
        return {{a, b, std::sin(a) * std::cos(b)},
                {-std::cos(a) * std::cos(b), std::sin(a) * std::sin(b), 1},
                downwards(x * x + 0.3 * y, y + 0.2 * x * y)};
    });
}

/// With a seam, where u is 0 and 1, and at each pole triangles without extent.
SourceMesh sphere() {
    return grid(12, 6, [](double x, double y) -> TangentCorner {
        const double along = 2 * std::numbers::pi * (x == 1.0 ? 0.0 : x);
        const bool isPole = y == 0.0 || y == 1.0;
        const double ring = isPole ? 0.0 : std::sin(std::numbers::pi * y);
        const glm::vec3 place(ring * std::cos(along), ring * std::sin(along),
                              -std::cos(std::numbers::pi * y));
        return {place, place, downwards(x, y)};
    });
}

/// Six sides, each with all of the texture.
SourceMesh cube() {
    const Mesh box = makeBox(glm::vec3(1.0f, 2.0f, 3.0f));
    SourceMesh mesh{.name = "", .positions = {}, .vertices = box.vertices, .indices = box.indices};
    mesh.details.resize(mesh.vertices.size());
    for (Vertex& vertex : mesh.vertices) {
        const int axis = vertex.normal.x != 0.0f ? 0 : vertex.normal.y != 0.0f ? 1 : 2;
        vertex.uv = {vertex.position[(axis + 1) % 3], vertex.position[(axis + 2) % 3]};
    }
    return mesh;
}

/// The left half of the texture, and on the right its mirror image.
SourceMesh mirrored() {
    return grid(4, 3, [](double x, double y) -> TangentCorner {
        return {{x, y, 0.1 * x * y}, {-0.1 * y, -0.1 * x, 1}, downwards(std::abs(x - 0.5), y)};
    });
}

/// Triangles about one vertex.
SourceMesh fan(std::uint32_t count) {
    SourceMesh mesh;
    for (std::uint32_t i = 0; i <= count; ++i) {
        const double angle = i * 2 * std::numbers::pi / count;
        const glm::vec2 at = i == 0 ? glm::vec2(0.0f) : glm::vec2(std::cos(angle), std::sin(angle));
        mesh.vertices.push_back({.position = {at, 0.0f}, .normal = {0, 0, 1}, .uv = at, .color = {}});
        if (i > 0) {
            mesh.indices.insert(mesh.indices.end(), {0, i, i % count + 1});
        }
    }
    mesh.details.resize(mesh.vertices.size());
    return mesh;
}

std::vector<TangentCorner> cornersOf(const SourceMesh& mesh) {
    std::vector<TangentCorner> corners;
    for (const std::uint32_t index : mesh.indices) {
        const Vertex& vertex = mesh.vertices[index];
        corners.push_back({vertex.position, vertex.normal, vertex.uv});
    }
    return corners;
}

base::Result<std::vector<glm::vec4>> tangentsOf(const std::vector<TangentCorner>& corners,
                                                const gltf::MikkTSpaceLimits& limits = {.bytes = kPlenty}) {
    return gltf::mikkTSpace(
        corners.size(), [&](std::size_t i) { return corners[i]; }, limits);
}

std::string reasonOf(const base::Result<std::vector<glm::vec4>>& result) {
    return result ? "none" : result.refusal().message;
}

glm::dvec3 inPlane(const glm::dvec3& v, const glm::dvec3& normal) {
    const glm::dvec3 flat = v - normal * glm::dot(normal, v);
    const double length = glm::length(flat);
    return length > 0.0 ? flat / length : glm::dvec3(0.0);
}

/// What MikkTSpace defines, in float64, for vertices whose triangles of one sense are all connected. At equal corners it is a
/// weighted sum of the triangles' directions of u. Each is first turned into the plane of the normal; the weight is the angle
/// in that plane. Zero in triangles without extent.
std::vector<glm::dvec4> referenceOf(const std::vector<TangentCorner>& corners) {
    using Key = std::tuple<float, float, float, float, float, float, float, float, bool>;
    std::map<Key, glm::dvec3> sums;
    std::vector<Key> keys;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const TangentCorner& here = corners[i];
        const TangentCorner& next = corners[i - i % 3 + (i + 1) % 3];
        const TangentCorner& last = corners[i - i % 3 + (i + 2) % 3];
        const glm::dvec3 normal(here.normal);
        const glm::dvec3 side1 = glm::dvec3(next.position) - glm::dvec3(here.position);
        const glm::dvec3 side2 = glm::dvec3(last.position) - glm::dvec3(here.position);
        const glm::dvec2 step1 = glm::dvec2(next.uv) - glm::dvec2(here.uv);
        const glm::dvec2 step2 = glm::dvec2(last.uv) - glm::dvec2(here.uv);
        const double area = step1.x * step2.y - step2.x * step1.y;
        const double angle =
            std::acos(std::clamp(glm::dot(inPlane(side1, normal), inPlane(side2, normal)), -1.0, 1.0));
        keys.emplace_back(here.position.x, here.position.y, here.position.z, here.normal.x, here.normal.y,
                          here.normal.z, here.uv.x, here.uv.y, area < 0.0);
        if (glm::cross(side1, side2) != glm::dvec3(0.0)) {
            const glm::dvec3 tangent = (side1 * step2.y - side2 * step1.y) * (area < 0.0 ? -1.0 : 1.0);
            sums[keys.back()] += angle * inPlane(tangent, normal);
        }
    }
    std::vector<glm::dvec4> tangents;
    for (const Key& key : keys) {
        const glm::dvec3 sum = sums[key];
        tangents.emplace_back(glm::length(sum) > 0.0 ? glm::normalize(sum) : sum,
                              std::get<8>(key) ? 1.0 : -1.0);
    }
    return tangents;
}

/// The largest distance of tangents from the reference, at each corner whose triangle has an extent.
void expectReference(const SourceMesh& source, const char* name) {
    const std::vector<glm::dvec4> expected = referenceOf(cornersOf(source));
    SourceMesh mesh = source;
    ASSERT_EQ(gltf::deriveMikkTSpaceTangents(mesh, kFirst, kPlenty), std::nullopt) << name;
    ASSERT_EQ(mesh.indices.size(), source.indices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const auto position = [&](std::size_t c) { return source.vertices[source.indices[c]].position; };
        const std::size_t t = i - i % 3;
        EXPECT_EQ(mesh.vertices[mesh.indices[i]].position, position(i)) << name << i;
        if (position(t) != position(t + 1) && position(t + 1) != position(t + 2) &&
            position(t + 2) != position(t)) {
            EXPECT_NEAR(glm::distance(glm::dvec4(mesh.details[mesh.indices[i]].tangent), expected[i]), 0.0,
                        2e-6)
                << name << i;
        }
    }
}

TEST_F(GltfMikkTSpace, AgreesWithTheDefinition) {
    expectReference(plane(), "plane");
    expectReference(bumps(), "bumps");
    expectReference(sphere(), "sphere");
    expectReference(cube(), "cube");
    expectReference(mirrored(), "mirrored");
}

TEST_F(GltfMikkTSpace, UGrowsAlongTheTangentAndTheSignIsThatOfGltf) {
    SourceMesh mesh = plane();
    ASSERT_EQ(gltf::deriveMikkTSpaceTangents(mesh, kFirst, kPlenty), std::nullopt);
    ASSERT_EQ(mesh.details.size(), 12u); // nothing was split
    for (const VertexDetail& detail : mesh.details) {
        EXPECT_NEAR(glm::distance(detail.tangent, glm::vec4(1, 0, 0, 1)), 0.0f, 1e-6f);
    }
}

TEST_F(GltfMikkTSpace, OnlyVerticesOfBothSensesBecomeTwo) {
    const SourceMesh before = mirrored();
    SourceMesh mesh = before;
    ASSERT_EQ(gltf::deriveMikkTSpaceTangents(mesh, kFirst, kPlenty), std::nullopt);
    ASSERT_EQ(mesh.vertices.size(), before.vertices.size() + 4);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const float x = mesh.vertices[i].position.x;
        EXPECT_TRUE(i >= before.vertices.size() ? x == 0.5f
                                                : mesh.vertices[i].position == before.vertices[i].position);
    }
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        EXPECT_EQ(mesh.details[mesh.indices[i]].tangent.w, i % 24 < 12 ? -1.0f : 1.0f) << i;
    }
}

TEST_F(GltfMikkTSpace, AFlatTextureGivesAnyDirectionInThePlane) {
    SourceMesh mesh = grid(2, 2, [](double x, double y) -> TangentCorner {
        return {{0, x, y}, {1, 0, 0}, {0.25, 0.5}};
    });
    ASSERT_EQ(gltf::deriveMikkTSpaceTangents(mesh, kFirst, kPlenty), std::nullopt);
    for (const VertexDetail& detail : mesh.details) {
        EXPECT_NEAR(glm::length(glm::vec3(detail.tangent)), 1.0f, 1e-6f);
        EXPECT_NEAR(detail.tangent.x, 0.0f, 1e-6f);
        EXPECT_EQ(std::abs(detail.tangent.w), 1.0f);
    }
}

TEST_F(GltfMikkTSpace, TrianglesWithoutExtentChangeNothing) {
    SourceMesh with = bumps();
    with.indices.insert(with.indices.end(), {0, 0, 1, 5, 5, 5});
    SourceMesh without = bumps();
    ASSERT_EQ(gltf::deriveMikkTSpaceTangents(with, kFirst, kPlenty), std::nullopt);
    ASSERT_EQ(gltf::deriveMikkTSpaceTangents(without, kFirst, kPlenty), std::nullopt);
    ASSERT_EQ(with.details.size(), without.details.size());
    for (std::size_t i = 0; i < with.details.size(); ++i) {
        EXPECT_EQ(with.details[i].tangent, without.details[i].tangent);
    }
    with.indices = {3, 3, 3};
    EXPECT_EQ(gltf::deriveMikkTSpaceTangents(with, kFirst, kPlenty), std::nullopt);
    EXPECT_NEAR(glm::dot(glm::vec3(with.details[3].tangent), with.vertices[3].normal), 0.0f, 1e-6f);
}

TEST_F(GltfMikkTSpace, ManyThreadsAndRepeatsGiveTheSame) {
    const std::vector<TangentCorner> first = cornersOf(bumps());
    const std::vector<TangentCorner> second = cornersOf(sphere());
    const std::vector<glm::vec4> expectedFirst = tangentsOf(first).orThrow();
    const std::vector<glm::vec4> expectedSecond = tangentsOf(second).orThrow();
    const auto repeat = [](const std::vector<TangentCorner>& corners,
                           const std::vector<glm::vec4>& expected) {
        for (int i = 0; i < 50; ++i) {
            const base::Result<std::vector<glm::vec4>> tangents = tangentsOf(corners);
            EXPECT_TRUE(tangents && *tangents == expected) << i;
        }
    };
    std::thread other([&] { repeat(second, expectedSecond); });
    repeat(first, expectedFirst);
    other.join();
}

TEST_F(GltfMikkTSpace, GoesNoFurtherThanItsLimits) {
    const std::vector<TangentCorner> corners = cornersOf(bumps());
    const std::uint64_t bytes = gltf::mikkTSpaceBytes(corners.size());
    EXPECT_TRUE(tangentsOf(corners, {.bytes = bytes}));
    EXPECT_EQ(reasonOf(tangentsOf(corners, {.bytes = bytes - 1})), "MikkTSpace would take too much memory");
    EXPECT_EQ(reasonOf(tangentsOf(corners, {.bytes = bytes, .depth = 10})),
              "MikkTSpace would nest too many calls");
    // All corners at one place stop the module.
    EXPECT_EQ(reasonOf(tangentsOf(std::vector<TangentCorner>(3))), "MikkTSpace failed");
    const auto none = [](std::size_t) { return TangentCorner{}; };
    EXPECT_EQ(reasonOf(gltf::mikkTSpace(3u << 30u, none, {.bytes = ~std::uint64_t{0}})),
              "MikkTSpace would take too much memory");
}

TEST_F(GltfMikkTSpace, AMeshThatItIsNotForStaysAsItWas) {
    const auto expectUnchanged = [](const SourceMesh& source, std::uint64_t bytes, const char* reason) {
        SourceMesh mesh = source;
        EXPECT_EQ(gltf::deriveMikkTSpaceTangents(mesh, kFirst, bytes), reason);
        EXPECT_EQ(mesh.indices, source.indices);
        EXPECT_EQ(mesh.vertices.size(), source.vertices.size());
        EXPECT_EQ(mesh.details.front().tangent, VertexDetail{}.tangent);
    };
    expectUnchanged(plane(), 1'000, "MikkTSpace would take too much memory");
    expectUnchanged(plane(), 1u << 22u, "MikkTSpace would take too much memory");
    expectUnchanged(fan(3'000), kPlenty, "too many triangles meet at a point for MikkTSpace");
    SourceMesh disc = fan(1'000);
    EXPECT_EQ(gltf::deriveMikkTSpaceTangents(disc, kFirst, kPlenty), std::nullopt);
    SourceMesh apart = fan(3'000); // the same, where no two triangles share a vertex
    SourceMesh copies;
    for (const std::uint32_t index : apart.indices) {
        copies.indices.push_back(static_cast<std::uint32_t>(copies.vertices.size()));
        copies.vertices.push_back(apart.vertices[index]);
    }
    copies.details.resize(copies.vertices.size());
    expectUnchanged(copies, kPlenty, "too many triangles meet at a point for MikkTSpace");
    // Seven points and seven triangles, of which any two share one point and no side.
    SourceMesh fano = fan(6);
    for (std::uint32_t i = 0; i < 7; ++i) {
        fano.vertices[i].uv = {0.3f * static_cast<float>(i * i % 5),
                               0.2f * static_cast<float>(i * i * i % 7)};
    }
    fano.indices = {0, 1, 3, 1, 2, 4, 2, 3, 5, 3, 4, 6, 4, 5, 0, 5, 6, 1, 6, 0, 2};
    expectUnchanged(fano, kPlenty, "MikkTSpace would make more than two vertices of one");
}

/// A mesh as a file without tangents, whose material has a normal texture.
Document fileOf(const SourceMesh& mesh) {
    Document document = triangle();
    std::vector<float> positions;
    std::vector<float> normals;
    std::vector<float> uvs;
    for (const Vertex& v : mesh.vertices) {
        positions.insert(positions.end(), {v.position.x, v.position.y, v.position.z});
        normals.insert(normals.end(), {v.normal.x, v.normal.y, v.normal.z});
        uvs.insert(uvs.end(), {v.uv.x, v.uv.y});
    }
    json& primitive = document.primitive();
    primitive["attributes"] = {{"POSITION", document.addAccessor(positions, "VEC3", kFloat)},
                               {"NORMAL", document.addAccessor(normals, "VEC3", kFloat)},
                               {"TEXCOORD_0", document.addAccessor(uvs, "VEC2", kFloat)}};
    primitive["indices"] = document.addAccessor(mesh.indices, "SCALAR", kUInt);
    giveNormalTexture(document);
    return document;
}

TEST_F(GltfMikkTSpace, FilesWithoutTangentsGetThem) {
    SourceMesh expected = bumps();
    ASSERT_EQ(gltf::deriveMikkTSpaceTangents(expected, kFirst, kPlenty), std::nullopt);
    const GltfImport result = load(fileOf(bumps()));
    const Mesh& mesh = result.scene.meshes.at(0);
    EXPECT_TRUE(result.ignored.empty());
    ASSERT_EQ(mesh.indices.size(), expected.indices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        EXPECT_NEAR(glm::distance(mesh.details[mesh.indices[i]].tangent,
                                  expected.details[expected.indices[i]].tangent),
                    0.0f, 1e-6f); // the importer normalises normals again
    }
}

TEST_F(GltfMikkTSpace, TheyFollowATextureThatIsTurned) {
    Document document = fileOf(plane());
    document.root["materials"][0]["normalTexture"]["extensions"] = {
        {"KHR_texture_transform", {{"rotation", std::numbers::pi / 2}}}};
    document.root["extensionsUsed"] = {"KHR_texture_transform"};
    const GltfImport result = load(document);
    ASSERT_FALSE(result.scene.meshes.at(0).details.empty());
    for (const VertexDetail& detail : result.scene.meshes[0].details) { // u of the texture is v of the file
        EXPECT_NEAR(glm::distance(detail.tangent, glm::vec4(0, -1, 0, 1)), 0.0f, 1e-6f);
    }
}

/// Each vertex of the file moves by a length of its own.
TEST_F(GltfMikkTSpace, VerticesThatBecomeTwoMoveAsTheOneOfTheFile) {
    const SourceMesh mesh = mirrored();
    Document document = fileOf(mesh);
    std::vector<float> moves;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        moves.insert(moves.end(), {0.0f, 0.0f, 1.0f + static_cast<float>(i)});
    }
    document.primitive()["targets"] = {{{"POSITION", document.addAccessor(moves, "VEC3", kFloat)}}};
    document.root["meshes"][0]["weights"] = {1};
    const GltfImport result = load(document);
    const Mesh& moved = result.scene.meshes.at(0);
    ASSERT_EQ(moved.vertices.size(), mesh.vertices.size() + 4);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t source = mesh.indices[i];
        const glm::dvec3 place =
            glm::dvec3(moved.vertices[moved.indices[i]].position) + result.scene.instances.position(0);
        EXPECT_NEAR(place.z, mesh.vertices[source].position.z + moves[3 * source + 2], 1e-5) << i;
    }
}

TEST_F(GltfMikkTSpace, WhatItIsNotForIsDerivedOtherwiseWithANote) {
    SourceMesh expected = bumps();
    gltf::deriveTangents(expected, kFirst);
    GltfLimits limits;
    limits.maxBytes = 1u << 21u;
    const GltfImport result = load(fileOf(bumps()), limits);
    EXPECT_TRUE(anySays(result.ignored,
                        "mesh 0 '' primitive 0: its tangents are not MikkTSpace's: MikkTSpace "
                        "would take too much memory"));
    const Mesh& mesh = result.scene.meshes.at(0);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        EXPECT_NEAR(glm::distance(mesh.details[mesh.indices[i]].tangent,
                                  expected.details[expected.indices[i]].tangent),
                    0.0f, 1e-6f);
    }
    EXPECT_TRUE(
        anySays(load(fileOf(fan(3'000))).ignored, "too many triangles meet at a point for MikkTSpace"));
}

using GltfWithoutMikkTSpace = GltfFolder;

TEST_F(GltfWithoutMikkTSpace, ANoteSaysSo) {
    if (gltf::hasMikkTSpace()) {
        GTEST_SKIP() << "cdr was built with MikkTSpace";
    }
    EXPECT_TRUE(anySays(load(fileOf(bumps())).ignored,
                        "its tangents are not MikkTSpace's: cdr was built without MikkTSpace"));
}

} // namespace
} // namespace cdr::scene::test
