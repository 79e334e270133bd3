#include "../../support/globe.h"

#include <cdr/base/error.h>
#include <cdr/scene/lod/levels.h>
#include <cdr/scene/lod/shared_mesh.h>
#include <cdr/scene/lod/surface_distance.h>
#include <scenes/boulders.h>
#include <scenes/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace {

using namespace cdr;
using namespace cdr::scene;

using Indices = std::vector<std::uint32_t>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Distance to a triangle by projected gradient on its barycentric coordinates: slow, and nothing like the
/// code under test.
double distanceToTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                          const glm::dvec3& c) {
    double best = std::numeric_limits<double>::infinity();
    double centreU = 0.5;
    double centreV = 0.5;
    double step = 0.5;
    for (int round = 0; round < 24; ++round) {
        double nextU = centreU;
        double nextV = centreV;
        for (int i = -2; i <= 2; ++i) {
            for (int j = -2; j <= 2; ++j) {
                double u = std::clamp(centreU + 0.5 * i * step, 0.0, 1.0);
                double v = std::clamp(centreV + 0.5 * j * step, 0.0, 1.0);
                if (u + v > 1.0) {
                    const double over = 0.5 * (u + v - 1.0);
                    u = std::clamp(u - over, 0.0, 1.0);
                    v = 1.0 - u;
                }
                const double distance = glm::distance(p, a + u * (b - a) + v * (c - a));
                if (distance < best) {
                    best = distance;
                    nextU = u;
                    nextV = v;
                }
            }
        }
        centreU = nextU;
        centreV = nextV;
        step *= 0.7;
    }
    return best;
}

glm::dvec3 cornerOf(const Mesh& mesh, const Indices& indices, std::size_t corner) {
    return glm::dvec3(mesh.vertices[indices[corner]].position);
}

double distanceToSurface(const glm::dvec3& p, const Mesh& mesh, const Indices& indices) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const glm::dvec3 a = cornerOf(mesh, indices, i);
        const glm::dvec3 b = cornerOf(mesh, indices, i + 1);
        const glm::dvec3 c = cornerOf(mesh, indices, i + 2);
        // No point of the triangle is nearer than its nearest corner less its longest side.
        const double corner = std::min({glm::distance(p, a), glm::distance(p, b), glm::distance(p, c)});
        const double side = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
        if (corner - side < best) {
            best = std::min(best, distanceToTriangle(p, a, b, c));
        }
    }
    return best;
}

/// A point at random on a surface, triangles chosen evenly.
glm::dvec3 pointOn(const Mesh& mesh, const Indices& indices, scenes::Random& random) {
    const auto triangles = static_cast<double>(indices.size() / 3);
    const std::size_t i =
        3 * std::min(static_cast<std::size_t>(random.uniform(0.0, triangles)), indices.size() / 3 - 1);
    double u = random.uniform(0.0, 1.0);
    double v = random.uniform(0.0, 1.0);
    if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
    }
    const glm::dvec3 a = cornerOf(mesh, indices, i);
    return a + u * (cornerOf(mesh, indices, i + 1) - a) + v * (cornerOf(mesh, indices, i + 2) - a);
}

using Point = std::array<float, 3>;

/// Edges of one triangle only, by where they lie: vertices may be double.
std::set<std::pair<Point, Point>> openEdges(const Mesh& mesh, const Indices& indices) {
    std::map<std::pair<Point, Point>, int> uses;
    const auto pointAt = [&](std::size_t corner) {
        const glm::vec3& p = mesh.vertices[indices[corner]].position;
        return Point{p.x, p.y, p.z};
    };
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Point a = pointAt(i + k);
            const Point b = pointAt(i + (k + 1) % 3);
            ++uses[{std::min(a, b), std::max(a, b)}];
        }
    }
    std::set<std::pair<Point, Point>> open;
    for (const auto& [edge, count] : uses) {
        if (count == 1) {
            open.insert(edge);
        }
    }
    return open;
}

std::set<Edge> bordersOf(const Indices& indices) {
    std::map<Edge, int> uses;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++uses[std::minmax(indices[i + k], indices[i + (k + 1) % 3])];
        }
    }
    std::set<Edge> borders;
    for (const auto& [edge, count] : uses) {
        if (count == 1) {
            borders.insert(edge);
        }
    }
    return borders;
}

/// A bumpy square of `cells`^2 cells with a seam of normals along its middle row.
Mesh seamedTerrain(std::uint32_t cells) {
    Mesh mesh;
    mesh.boundingRadius = 2.0f;
    const auto addRow = [&](std::uint32_t j, const glm::vec3& normal) {
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const float x = 2.0f * static_cast<float>(i) / static_cast<float>(cells) - 1.0f;
            const float z = 2.0f * static_cast<float>(j) / static_cast<float>(cells) - 1.0f;
            mesh.vertices.push_back(
                {.position = {x, 0.1f * std::sin(5.0f * x) * std::cos(4.0f * z), z}, .normal = normal});
        }
    };
    const auto stitch = [&](std::uint32_t row) {
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = row * (cells + 1) + i;
            const std::uint32_t c = a + cells + 1;
            mesh.indices.insert(mesh.indices.end(), {a, c, c + 1, a, c + 1, a + 1});
        }
    };
    for (std::uint32_t j = 0; j <= cells / 2; ++j) {
        addRow(j, {0.0f, 1.0f, 0.0f});
    }
    for (std::uint32_t j = cells / 2; j <= cells; ++j) {
        addRow(j, {0.0f, 0.8f, 0.6f});
    }
    for (std::uint32_t row = 0; row <= cells; ++row) {
        if (row != cells / 2) {
            stitch(row);
        }
    }
    return mesh;
}

SurfaceDistance surfaceOf(const Mesh& mesh) {
    std::vector<glm::vec3> positions;
    for (const Vertex& vertex : mesh.vertices) {
        positions.push_back(vertex.position);
    }
    return {positions, mesh.indices};
}

TEST(SurfaceDistance, IsThatOfEveryTriangle) {
    const Mesh mesh = scenes::makeBoulder(3, 2);
    const SurfaceDistance surface = surfaceOf(mesh);
    scenes::Random random(5);
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 p = random.inCube(1.5);
        EXPECT_NEAR(std::sqrt(surface.nearestTo(p).squared), distanceToSurface(p, mesh, mesh.indices), 2e-5)
            << i;
    }
}

/// To the bit, wherever the search may end.
TEST(SurfaceDistance, TheLargerOfTwoIsThatOfAWholeSearch) {
    const Mesh mesh = scenes::makeBoulder(3, 3);
    const SurfaceDistance surface = surfaceOf(mesh);
    scenes::Random random(6);
    double largest = 0.0;
    double known = 0.0;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = random.inCube(1.5);
        const double squared = surface.nearestTo(p).squared;
        for (const double other : {0.0, 0.5 * squared, squared, 2.0 * squared}) {
            EXPECT_EQ(surface.largerSquared(p, other), std::max(other, squared)) << i;
        }
        largest = std::max(largest, squared);
        known = surface.largerSquared(p, known);
        EXPECT_EQ(known, largest) << i;
    }
}

TEST(Levels, NoPointOfALevelIsFartherThanItsErrorSays) {
    for (const Mesh& mesh : {scenes::makeBoulder(2013, 3), seamedTerrain(24)}) {
        const std::vector<MeshLevel> levels = makeLevels(mesh);
        ASSERT_GE(levels.size(), 2u);
        scenes::Random random(7);
        for (const MeshLevel& level : levels) {
            double farthest = 0.0;
            for (int i = 0; i < 120; ++i) {
                farthest = std::max(
                    farthest, distanceToSurface(pointOn(mesh, mesh.indices, random), mesh, level.indices));
                farthest = std::max(
                    farthest, distanceToSurface(pointOn(mesh, level.indices, random), mesh, mesh.indices));
            }
            const auto error = static_cast<double>(level.error);
            EXPECT_LE(farthest, 1.02 * error + 1e-5) << level.indices.size() / 3 << " triangles";
            EXPECT_GE(farthest, 0.4 * error) << level.indices.size() / 3 << " triangles";
        }
    }
}

TEST(Levels, GrowCoarserAndStop) {
    const Mesh mesh = scenes::makeBoulder(2013, 4);
    const LevelOptions options{.ratio = 0.5, .leastGain = 0.1, .most = 20, .leastTriangles = 40};
    const std::vector<MeshLevel> levels = makeLevels(mesh, options);
    ASSERT_GE(levels.size(), 5u);
    std::size_t triangles = mesh.indices.size() / 3;
    float error = 0.0f;
    for (const MeshLevel& level : levels) {
        EXPECT_EQ(level.indices.size() % 3, 0u);
        EXPECT_LE(static_cast<double>(level.indices.size()) / 3.0, 0.9 * static_cast<double>(triangles));
        EXPECT_GT(level.error, 0.0f);
        EXPECT_GE(level.error, error);
        triangles = level.indices.size() / 3;
        error = level.error;
        EXPECT_GE(triangles, 40u);
        EXPECT_LT(*std::max_element(level.indices.begin(), level.indices.end()), mesh.vertices.size());
    }
    EXPECT_LE(triangles, 160u);
    EXPECT_LT(makeLevels(mesh, {.most = 2}).size(), 3u);
    EXPECT_TRUE(makeLevels(makeBox(glm::vec3(1.0f))).empty());
    EXPECT_TRUE(makeLevels(Mesh{}).empty());
}

TEST(Levels, BordersStay) {
    std::size_t levels = 0;
    for (const Mesh& mesh :
         cdr::test::makeGlobe({.radius = 1000.0, .cells = 24, .pieceRadius = 300.0}).meshes) {
        const auto borders = openEdges(mesh, mesh.indices);
        ASSERT_FALSE(borders.empty());
        for (const MeshLevel& level : makeLevels(mesh)) {
            EXPECT_EQ(openEdges(mesh, level.indices), borders);
            ++levels;
        }
    }
    EXPECT_GT(levels, 20u);
}

/// Where normals jump the vertices are double; a level that let one side go its own way would tear it.
TEST(Levels, SeamsOfNormalsDoNotTear) {
    const Mesh mesh = seamedTerrain(24);
    const std::vector<MeshLevel> levels = makeLevels(mesh);
    ASSERT_GE(levels.size(), 2u);
    for (const MeshLevel& level : levels) {
        // Edges of the seam by position, once per side.
        std::map<std::pair<float, float>, std::set<float>> sides;
        for (const Edge& edge : bordersOf(level.indices)) {
            const Vertex& a = mesh.vertices[edge.first];
            const Vertex& b = mesh.vertices[edge.second];
            if (a.position.z == 0.0f && b.position.z == 0.0f) {
                sides[std::minmax(a.position.x, b.position.x)].insert(a.normal.z);
            }
        }
        EXPECT_FALSE(sides.empty());
        for (const auto& [edge, normals] : sides) {
            EXPECT_EQ(normals.size(), 2u) << edge.first << " to " << edge.second;
        }
        // No triangle mixes the normals of both sides.
        for (std::size_t i = 0; i < level.indices.size(); i += 3) {
            EXPECT_EQ(mesh.vertices[level.indices[i]].normal, mesh.vertices[level.indices[i + 1]].normal);
            EXPECT_EQ(mesh.vertices[level.indices[i]].normal, mesh.vertices[level.indices[i + 2]].normal);
        }
    }
}

TEST(Levels, ASceneHasThemWhateverTheWorkersAndKeepsThoseGiven) {
    SceneSetup setup = scenes::makeBoulders(1, {.boulders = 3, .shapes = 3, .subdivisions = 3});
    const MeshLevel given{.indices = {0, 1, 2}, .error = 0.25f};
    setup.scene.meshes[1].levels = {given};
    Scene first = setup.scene;
    cdr::platform::WorkerPool one(1);
    makeLevels(first, one);
    cdr::platform::WorkerPool three(3);
    makeLevels(setup.scene, three);
    for (std::size_t mesh = 0; mesh < 3; ++mesh) {
        ASSERT_EQ(first.meshes[mesh].levels.size(), setup.scene.meshes[mesh].levels.size());
        for (std::size_t level = 0; level < first.meshes[mesh].levels.size(); ++level) {
            EXPECT_EQ(first.meshes[mesh].levels[level].indices,
                      setup.scene.meshes[mesh].levels[level].indices);
            EXPECT_EQ(first.meshes[mesh].levels[level].error, setup.scene.meshes[mesh].levels[level].error);
        }
    }
    ASSERT_EQ(first.meshes[1].levels.size(), 1u);
    EXPECT_EQ(first.meshes[1].levels[0].indices, given.indices);
    EXPECT_GT(first.meshes[0].levels.size(), 2u);
}

/// A mesh without an index buffer shares no vertex, yet its triangles touch.
TEST(Levels, UnsharedVerticesAreTakenAsOne) {
    const Mesh mesh = scenes::makeBoulder(4, 3);
    const Mesh unshared = unshareVertices(mesh);
    const std::vector<MeshLevel> levels = makeLevels(unshared);
    ASSERT_EQ(levels.size(), makeLevels(mesh).size());
    EXPECT_TRUE(bordersOf(levels.back().indices).empty());
}

/// A level that let one go for the other would bend tangents, or move a second picture.
TEST(Levels, VerticesWithOtherDetailsAreNotTakenAsOne) {
    Mesh mesh = unshareVertices(makeBox(glm::vec3(1.0f)));
    EXPECT_EQ(sharedBy(mesh).vertices.size(), 24u);
    mesh.details.resize(mesh.vertices.size());
    EXPECT_EQ(sharedBy(mesh).vertices.size(), 24u);
    mesh.details[0].tangent.w = -1.0f;
    EXPECT_EQ(sharedBy(mesh).vertices.size(), 25u); // another triangle has a vertex in its place
    mesh.details[1].uv.y = 0.5f;                    // as this one, of one triangle, has not
    EXPECT_EQ(sharedBy(mesh).vertices.size(), 25u);
    mesh.details[2].uv.y = 0.5f;
    EXPECT_EQ(sharedBy(mesh).vertices.size(), 26u);
}

TEST(Levels, UnusableOptionsAreRefused) {
    const Mesh mesh = scenes::makeBoulder(4, 1);
    for (const LevelOptions& options :
         {LevelOptions{.ratio = 0.0}, LevelOptions{.ratio = 1.0}, LevelOptions{.ratio = NAN},
          LevelOptions{.leastGain = -0.1}, LevelOptions{.leastGain = 1.0}, LevelOptions{.most = 33}}) {
        EXPECT_THROW(makeLevels(mesh, options), cdr::base::InputError);
    }
}

} // namespace
