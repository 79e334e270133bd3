#include "../../support/globe.h"
#include "../gltf/fixture.h"

#include <cdr/scene/lod/mesh_pieces.h>
#include <cdr/scene/lod/triangle_clusters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace cdr::scene::test {

namespace {

using Corners = std::array<std::tuple<double, double, double>, 3>;

/// The triangle's corners in the source's space, from the one that sorts first, so that copies compare equal.
Corners cornersOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    Corners corners{std::tuple(a.x, a.y, a.z), std::tuple(b.x, b.y, b.z), std::tuple(c.x, c.y, c.z)};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
}

glm::dvec3 placed(const MeshPiece& piece, std::size_t index) {
    return piece.origin + glm::dvec3(piece.mesh.vertices[piece.mesh.indices[index]].position);
}

/// Which pieces hold each triangle of the source. Positions must be such that pieces hold them exactly.
std::map<Corners, std::set<std::size_t>> holders(const std::vector<MeshPiece>& pieces) {
    std::map<Corners, std::set<std::size_t>> result;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        for (std::size_t i = 0; i < pieces[p].mesh.indices.size(); i += 3) {
            result[cornersOf(placed(pieces[p], i), placed(pieces[p], i + 1), placed(pieces[p], i + 2))]
                .insert(p);
        }
    }
    return result;
}

/// A bumpy square of 2 side^2 triangles, one unit a cell, about `centre`; positions are multiples of 1/8.
SourceMesh bumpySquare(std::uint32_t side, const glm::dvec3& centre) {
    SourceMesh mesh;
    mesh.name = "square";
    std::mt19937_64 random(3);
    for (std::uint32_t j = 0; j <= side; ++j) {
        for (std::uint32_t i = 0; i <= side; ++i) {
            const double height = 0.125 * static_cast<double>(random() % 16);
            mesh.positions.push_back(centre + glm::dvec3(i, height, j) - 0.5 * side);
            mesh.vertices.emplace_back();
        }
    }
    for (std::uint32_t j = 0; j < side; ++j) {
        for (std::uint32_t i = 0; i < side; ++i) {
            const std::uint32_t a = j * (side + 1) + i;
            const std::uint32_t c = a + side + 1;
            mesh.indices.insert(mesh.indices.end(), {a, c, c + 1, a, c + 1, a + 1});
        }
    }
    return mesh;
}

TEST(MeshPieces, AMeshNoWiderThanAPieceStaysWhole) {
    const SourceMesh source = bumpySquare(8, {1e7, 0.0, -3e6});
    for (const double radius : {6.0, 1e9}) {
        const std::vector<MeshPiece> pieces = cutIntoPieces(source, radius);
        ASSERT_EQ(pieces.size(), 1u);
        EXPECT_EQ(holders(pieces).size(), source.indices.size() / 3);
        EXPECT_EQ(pieces[0].mesh.vertices.size(), source.positions.size());
        EXPECT_EQ(pieces[0].mesh.name, "square");
        EXPECT_NEAR(pieces[0].origin.x, 1e7, 1.0);
        EXPECT_LT(pieces[0].mesh.boundingRadius, 6.0f);
    }
}

/// Whole or cut, with its vertices in the order of their use or not.
TEST(MeshPieces, AMeshThatIsGivenAwayMakesTheSamePieces) {
    const SourceMesh anyOrder = bumpySquare(32, {1e7, 0.0, -3e6});
    std::vector<SourceMesh> sources(3);
    sources[0] = anyOrder;
    std::map<std::uint32_t, std::uint32_t> newIndex;
    for (const std::uint32_t index : anyOrder.indices) {
        SourceMesh& inOrder = sources[1];
        const auto [found, isNew] =
            newIndex.try_emplace(index, static_cast<std::uint32_t>(inOrder.positions.size()));
        if (isNew) {
            inOrder.positions.push_back(anyOrder.positions[index]);
            inOrder.vertices.push_back({.uv = glm::vec2(static_cast<float>(index))});
            inOrder.details.push_back({.uv = glm::vec2(static_cast<float>(index) + 0.5f)});
        }
        inOrder.indices.push_back(found->second);
    }
    sources[2] = sources[1];
    sources[2].positions.push_back(sources[2].positions[0] + 1e3); // which no triangle uses
    sources[2].vertices.emplace_back();
    sources[2].details.emplace_back();
    for (const SourceMesh& source : sources) {
        for (const double radius : {1e9, 8.0}) {
            const std::vector<MeshPiece> copied = cutIntoPieces(source, radius);
            SourceMesh given = source;
            const std::vector<MeshPiece> taken = cutIntoPieces(std::move(given), radius);
            ASSERT_EQ(taken.size(), copied.size());
            EXPECT_EQ(copied.size() == 1, radius == 1e9);
            for (std::size_t i = 0; i < taken.size(); ++i) {
                const Mesh& a = taken[i].mesh;
                const Mesh& b = copied[i].mesh;
                EXPECT_EQ(a.name, b.name);
                EXPECT_EQ(taken[i].origin, copied[i].origin);
                EXPECT_EQ(a.indices, b.indices);
                EXPECT_EQ(a.boundingRadius, b.boundingRadius);
                ASSERT_EQ(a.vertices.size(), b.vertices.size());
                ASSERT_EQ(a.details.size(), b.details.size());
                for (std::size_t k = 0; k < a.vertices.size(); ++k) {
                    ASSERT_EQ(a.vertices[k].position, b.vertices[k].position);
                    ASSERT_EQ(a.vertices[k].uv, b.vertices[k].uv);
                }
                for (std::size_t k = 0; k < a.details.size(); ++k) {
                    ASSERT_EQ(a.details[k].uv, b.details[k].uv);
                }
            }
        }
    }
}

/// As an importer's mesh, whose float32 vertices are all that its file has.
TEST(MeshPieces, AMeshWithoutPositionsLiesWhereItsVerticesDo) {
    SourceMesh exact = bumpySquare(16, {5.0, 0.0, -7.0});
    SourceMesh single = exact;
    for (std::size_t i = 0; i < single.vertices.size(); ++i) {
        single.vertices[i].position = glm::vec3(exact.positions[i]);
    }
    single.positions.clear();
    for (const double radius : {1e9, 4.0}) {
        const std::vector<MeshPiece> pieces = cutIntoPieces(single, radius);
        EXPECT_EQ(holders(pieces), holders(cutIntoPieces(exact, radius)));
        EXPECT_EQ(holders(pieces).size(), exact.indices.size() / 3);
    }
    EXPECT_EQ(holders(cutIntoPieces(std::move(single), 1e9)), holders(cutIntoPieces(exact, 1e9)));
}

TEST(MeshPieces, HoldEveryTriangleWithinTheRadiusAndAtMostFourTimes) {
    const SourceMesh source = bumpySquare(64, {1e7, 0.0, -3e6});
    const std::vector<MeshPiece> pieces = cutIntoPieces(source, 8.0);
    EXPECT_GT(pieces.size(), 16u);
    std::size_t copies = 0;
    for (const MeshPiece& piece : pieces) {
        copies += piece.mesh.indices.size() / 3;
        EXPECT_LT(piece.mesh.boundingRadius, 2.0f * 8.0f);
        for (const Vertex& vertex : piece.mesh.vertices) {
            EXPECT_LE(glm::length(glm::dvec3(vertex.position)),
                      static_cast<double>(piece.mesh.boundingRadius));
        }
    }
    const auto held = holders(pieces);
    EXPECT_EQ(held.size(), source.indices.size() / 3);
    for (std::size_t i = 0; i < source.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return source.positions[source.indices[i + k]]; };
        EXPECT_TRUE(held.contains(cornersOf(at(0), at(1), at(2))));
    }
    EXPECT_LT(copies, 2 * source.indices.size() / 3);
}

/// What makes seams watertight, whatever a transform rounds.
TEST(MeshPieces, OnePieceHoldsAnyTwoTrianglesThatTouch) {
    const SourceMesh source = bumpySquare(40, {1e7, 0.0, -3e6});
    const auto held = holders(cutIntoPieces(source, 4.0));
    std::map<std::tuple<double, double, double>, std::vector<const std::set<std::size_t>*>> byPoint;
    for (const auto& [corners, pieces] : held) {
        for (const auto& corner : corners) {
            byPoint[corner].push_back(&pieces);
        }
    }
    int seams = 0;
    for (const auto& [point, fan] : byPoint) {
        std::set<std::size_t> common = *fan.front();
        std::set<std::size_t> all;
        for (const std::set<std::size_t>* pieces : fan) {
            std::set<std::size_t> both;
            std::set_intersection(common.begin(), common.end(), pieces->begin(), pieces->end(),
                                  std::inserter(both, both.end()));
            common = both;
            all.insert(pieces->begin(), pieces->end());
        }
        EXPECT_FALSE(common.empty());
        seams += all.size() > 1 ? 1 : 0;
    }
    EXPECT_GT(seams, 100);
}

TEST(MeshPieces, KeepFloat32SourcesExactly) {
    SourceMesh source = bumpySquare(64, {1e6, 2e6, -3e6});
    std::mt19937_64 random(4);
    std::set<std::tuple<double, double, double>> sources;
    // Multiples of what float32 steps by at these distances.
    for (glm::dvec3& p : source.positions) {
        p += glm::dvec3(random() % 8, random() % 8, random() % 8) * glm::dvec3(0.0625, 0.125, 0.25);
        p.z = std::round(4.0 * p.z) / 4.0;
        p.y = std::round(8.0 * p.y) / 8.0;
        ASSERT_EQ(static_cast<double>(static_cast<float>(p.x)), p.x);
        sources.insert({p.x, p.y, p.z});
    }
    for (const MeshPiece& piece : cutIntoPieces(source, 8.0)) {
        for (std::size_t i = 0; i < piece.mesh.indices.size(); ++i) {
            const glm::dvec3 p = placed(piece, i);
            ASSERT_TRUE(sources.contains({p.x, p.y, p.z}));
        }
    }
}

TEST(MeshPieces, WhatLiesApartInOneMeshIsCutApart) {
    SourceMesh source;
    const Mesh cube = makeBox(glm::vec3(0.5f));
    for (const double x : {-1e6, 1e6}) {
        const auto first = static_cast<std::uint32_t>(source.positions.size());
        for (const Vertex& vertex : cube.vertices) {
            source.positions.push_back(glm::dvec3(vertex.position) + glm::dvec3(x, 0.1, 0.0));
            source.vertices.push_back(vertex);
        }
        for (const std::uint32_t index : cube.indices) {
            source.indices.push_back(first + index);
        }
    }
    const std::vector<MeshPiece> pieces = cutIntoPieces(source, kPieceRadius);
    ASSERT_EQ(pieces.size(), 2u);
    for (const MeshPiece& piece : pieces) {
        EXPECT_NEAR(piece.mesh.boundingRadius, std::sqrt(0.75), 0.1);
        EXPECT_EQ(piece.mesh.indices.size(), cube.indices.size());
        for (std::size_t i = 0; i < piece.mesh.indices.size(); ++i) {
            const glm::dvec3 p = placed(piece, i);
            EXPECT_NEAR(std::abs(std::abs(p.x) - 1e6), 0.5, 1e-9);
            EXPECT_NEAR(std::abs(p.y - 0.1), 0.5, 3e-8);
        }
    }
}

TEST(MeshPieces, TrianglesLargerThanAPieceStayWhole) {
    const SourceMesh quad{.name = "quad",
                          .positions = {{-1e6, 0, -1e6}, {1e6, 0, -1e6}, {1e6, 0, 1e6}, {-1e6, 0, 1e6}},
                          .vertices = std::vector<Vertex>(4),
                          .indices = {0, 2, 1, 0, 3, 2}};
    EXPECT_EQ(cutIntoPieces(quad, 10.0).size(), 1u);
}

/// Work and memory are bounded by the triangles, whatever a file makes of them.
TEST(MeshPieces, HostileMeshesStayBounded) {
    constexpr std::uint32_t kTriangles = 200'000;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> exponent(-37.0, 37.0);
    SourceMesh soup;   // anything anywhere
    SourceMesh fan;    // all around one vertex
    SourceMesh same;   // one triangle over and over
    SourceMesh spread; // ever farther out, so that a cut in the middle parts one from all others
    fan.positions.emplace_back(0.0);
    for (std::uint32_t i = 0; i < 3 * kTriangles; ++i) {
        const double size = std::pow(10.0, exponent(random));
        soup.positions.emplace_back(size, -size, i % 2 ? size : 1.0);
        spread.positions.emplace_back(std::pow(10.0, 70.0 * (i / 3) / kTriangles - 35.0), i % 3, i % 2);
        fan.positions.emplace_back(std::cos(1e-5 * i) * 1e6, std::sin(1e-5 * i) * 1e6, 0.0);
        same.positions.emplace_back(i % 3 * 1e9, i % 2, 0.0);
        for (SourceMesh* mesh : {&soup, &same, &spread}) {
            mesh->indices.push_back(i);
        }
        fan.indices.push_back(i % 3 == 0 ? 0 : i);
    }
    for (SourceMesh* mesh : {&soup, &fan, &same, &spread}) {
        mesh->vertices.resize(mesh->positions.size());
        const std::vector<MeshPiece> pieces = cutIntoPieces(*mesh, 1e-3);
        EXPECT_LE(pieces.size(), kMaxPieces);
        std::size_t triangles = 0;
        for (const MeshPiece& piece : pieces) {
            triangles += piece.mesh.indices.size() / 3;
        }
        EXPECT_GE(triangles, kTriangles);
        EXPECT_LE(triangles, 4 * kTriangles);
    }
}

/// What is not a number has no order, by which seams are closed. What holds it stays whole, for a world to refuse it.
TEST(MeshPieces, AMeshThatIsNotFiniteIsNotCut) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        SourceMesh source = bumpySquare(32, glm::dvec3(0.0));
        EXPECT_GT(cutIntoPieces(source, 6.0).size(), 1u);
        source.positions[100].z = bad;
        EXPECT_EQ(cutIntoPieces(source, 6.0).size(), 1u) << bad;
    }
}

TEST(Globe, IsClosedAndItsFrontsFaceOut) {
    const SourceMesh globe = cdr::test::globeMesh(2.0, 8);
    std::map<std::pair<std::tuple<double, double, double>, std::tuple<double, double, double>>, int> edges;
    for (std::size_t i = 0; i < globe.indices.size(); i += 3) {
        const auto at = [&](std::size_t k) { return globe.positions[globe.indices[i + k % 3]]; };
        EXPECT_GT(glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), at(0)), 0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 a = at(k);
            const glm::dvec3 b = at(k + 1);
            ++edges[{{a.x, a.y, a.z}, {b.x, b.y, b.z}}];
            --edges[{{b.x, b.y, b.z}, {a.x, a.y, a.z}}];
        }
    }
    EXPECT_EQ(edges.size(), globe.indices.size());
    for (const auto& [edge, balance] : edges) {
        EXPECT_EQ(balance, 0);
    }
}

class GltfPieces : public GltfFolder {
  protected:
    /// A strip of squares along x, `columns` of them, one unit each, from x = `begin` on.
    static Document strip(std::uint32_t columns, float begin) {
        Document document = square();
        document.root["accessors"].clear();
        std::vector<float> positions;
        std::vector<float> normals;
        std::vector<std::uint32_t> indices;
        for (std::uint32_t i = 0; i <= columns; ++i) {
            const float x = begin + static_cast<float>(i);
            positions.insert(positions.end(), {x, 0.0f, 0.0f, x, 1.0f, 0.0f});
            normals.insert(normals.end(), {0, 0, 1, 0, 0, 1});
            if (i > 0) {
                const std::uint32_t a = 2 * i - 2;
                indices.insert(indices.end(), {a, a + 2, a + 3, a, a + 3, a + 1});
            }
        }
        json& primitive = document.primitive();
        primitive["attributes"]["POSITION"] = document.addAccessor(positions, "VEC3", kFloat);
        primitive["attributes"]["NORMAL"] = document.addAccessor(normals, "VEC3", kFloat);
        primitive["indices"] = document.addAccessor(indices, "SCALAR", kUInt);
        return document;
    }
};

TEST_F(GltfPieces, AWideMeshIsCutAndItsPiecesAreOneObject) {
    const Document document = strip(4000, 0.0f);
    const Scene scene = load(document).scene;
    ASSERT_GT(scene.instances.size(), 2u);
    EXPECT_LT(scene.instances.size(), 16u);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        EXPECT_EQ(scene.instances.object[i], 0u);
        EXPECT_LE(static_cast<double>(scene.instances.radius[i]), kPieceRadius + 2.0);
    }
    EXPECT_EQ(scene.objectNames.size(), 1u);
    EXPECT_EQ(load(document, {.pieceRadius = 1e4}).scene.instances.size(), 1u);
}

TEST_F(GltfPieces, TheNodesScaleCounts) {
    Document document = strip(4000, 0.0f);
    document.root["nodes"][0]["scale"] = {0.1, 0.1, 0.1};
    EXPECT_EQ(load(document).scene.instances.size(), 1u);
    document.root["nodes"][0]["scale"] = {10.0, 1.0, 1.0};
    EXPECT_GT(load(document).scene.instances.size(), 32u);
}

TEST_F(GltfPieces, BlendedMeshesStayWhole) {
    Document document = strip(4000, 0.0f);
    document.root["materials"] = {{{"alphaMode", "BLEND"}}};
    document.primitive()["material"] = 0;
    EXPECT_EQ(load(document).scene.instances.size(), 1u);
}

/// A turned node in a far one: pieces stand where float64 puts them, not where a float32 matrix does.
TEST_F(GltfPieces, HierarchiesComposeInFloat64) {
    Document document = strip(4000, 500'000.0f);
    const double angle = 0.3;
    document.root["nodes"] = {
        {{"translation", {4e8, -1e8, 3e8}}, {"children", {1}}},
        {{"mesh", 0}, {"rotation", {0.0, std::sin(0.5 * angle), 0.0, std::cos(0.5 * angle)}}}};
    const Scene scene = load(document).scene;
    ASSERT_GT(scene.instances.size(), 2u);
    double nearest = 1e9;
    double farthest = 0.0;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const glm::dvec3 offset = scene.instances.position(i) - glm::dvec3(4e8, -1e8, 3e8);
        // Turned about y, x goes to (cos, 0, -sin) and y stays; float64 at 4e8 is exact to 6e-8.
        const double along = offset.x * std::cos(angle) - offset.z * std::sin(angle);
        EXPECT_NEAR(offset.x * std::sin(angle) + offset.z * std::cos(angle), 0.0, 2e-7);
        const Mesh& mesh = scene.meshes[scene.instances.mesh[i]];
        for (const Vertex& vertex : mesh.vertices) {
            const double x = along + static_cast<double>(vertex.position.x);
            nearest = std::min(nearest, x);
            farthest = std::max(farthest, x);
            EXPECT_NEAR(x, std::round(x), 2e-7);
        }
    }
    EXPECT_NEAR(nearest, 500'000.0, 2e-7);
    EXPECT_NEAR(farthest, 504'000.0, 2e-7);
}

} // namespace

} // namespace cdr::scene::test
