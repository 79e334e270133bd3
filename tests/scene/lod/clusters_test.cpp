#include <cdr/scene/lod/clusters.h>
#include <cdr/scene/lod/surface_distance.h>
#include <scenes/boulders.h>
#include <scenes/terrain.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace {

using namespace cdr::scene;

ClusterTree clustersOf(const Mesh& mesh, std::size_t threads = 2) {
    cdr::platform::WorkerPool workers(threads);
    return makeClusters(mesh, workers);
}

const Mesh& boulder() {
    static const Mesh mesh = cdr::scenes::makeBoulder(3, 5); // 20,480 triangles
    return mesh;
}

const ClusterTree& boulderTree() {
    static const ClusterTree tree = clustersOf(boulder());
    return tree;
}

/// The indices of all clusters whose coarser form is not wanted while they are.
std::vector<std::uint32_t> indicesWhere(const ClusterTree& tree, const auto& isCoarseWanted) {
    std::vector<std::uint32_t> indices;
    for (const MeshCluster& cluster : tree.clusters) {
        const bool isFineEnough = cluster.madeBy == kNoGroup || isCoarseWanted(tree.groups[cluster.madeBy]);
        const bool isCoarsest =
            cluster.coarserBy == kNoGroup || !isCoarseWanted(tree.groups[cluster.coarserBy]);
        if (isFineEnough && isCoarsest) {
            const auto first = tree.indices.begin() + cluster.firstIndex;
            indices.insert(indices.end(), first, first + cluster.indexCount);
        }
    }
    return indices;
}

std::vector<std::array<std::uint32_t, 3>> sortedTriangles(const std::vector<std::uint32_t>& indices) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        std::array triangle{indices[i], indices[i + 1], indices[i + 2]};
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        triangles.push_back(triangle);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

/// How many edges have no partner that runs the other way.
std::size_t openEdges(const std::vector<std::uint32_t>& indices) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t from = indices[i + k];
            const std::uint32_t to = indices[i + (k + 1) % 3];
            edges[std::minmax(from, to)] += from < to ? 1 : -1;
        }
    }
    return static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 0; }));
}

TEST(Clusters, TheFinestAreTheMesh) {
    const std::vector<std::uint32_t> finest =
        indicesWhere(boulderTree(), [](const ClusterGroup&) { return false; });
    EXPECT_EQ(sortedTriangles(finest), sortedTriangles(boulder().indices));
}

TEST(Clusters, TheCoarsestAreFew) {
    const std::vector<std::uint32_t> coarsest =
        indicesWhere(boulderTree(), [](const ClusterGroup&) { return true; });
    EXPECT_GT(coarsest.size() / 3, 0u);
    EXPECT_LT(coarsest.size() / 3, boulder().indices.size() / 3 / 40);
    EXPECT_LT(boulderTree().indices.size(), 3 * boulder().indices.size());
}

/// Mixtures of levels for several cameras, near and far, and errors; those alone that are coarser than the mesh.
std::vector<std::vector<std::uint32_t>> mixturesOf(const Mesh& mesh, const ClusterTree& tree) {
    float largest = 0.0f;
    for (const ClusterGroup& group : tree.groups) {
        largest = std::max(largest, group.error);
    }
    std::vector<std::vector<std::uint32_t>> mixtures;
    for (const float pixels : {0.02f, 0.1f, 0.3f, 1.0f}) {
        for (const glm::vec3& eye :
             {glm::vec3(1.1f, 0.0f, 0.0f), glm::vec3(0.0f, -1.5f, 0.3f), glm::vec3(-2.0f, 1.0f, 1.0f)}) {
            mixtures.push_back(indicesWhere(tree, [&](const ClusterGroup& group) {
                const float distance =
                    glm::distance(group.bounds.centre, mesh.boundingRadius * eye) - group.bounds.radius;
                return group.error <= pixels * largest * std::max(distance / mesh.boundingRadius, 0.01f);
            }));
            if (mixtures.back().size() >= mesh.indices.size()) {
                mixtures.pop_back();
            }
        }
    }
    return mixtures;
}

/// A closed mesh stays closed, whatever error is allowed where.
TEST(Clusters, AnyMixtureIsWithoutCracks) {
    const auto mixtures = mixturesOf(boulder(), boulderTree());
    EXPECT_GE(mixtures.size(), 9u);
    for (const std::vector<std::uint32_t>& drawn : mixtures) {
        EXPECT_EQ(openEdges(drawn), 0u) << drawn.size();
    }
}

TEST(Clusters, ErrorsAndSpheresGrowWithCoarseness) {
    const ClusterTree& tree = boulderTree();
    for (const ClusterGroup& group : tree.groups) {
        EXPECT_GT(group.error, 0.0f);
        for (std::uint32_t i = 0; i < group.clusterCount; ++i) {
            const MeshCluster& cluster = tree.clusters[group.firstCluster + i];
            EXPECT_EQ(&tree.groups[cluster.coarserBy], &group);
            if (cluster.madeBy == kNoGroup) {
                continue;
            }
            const ClusterGroup& finer = tree.groups[cluster.madeBy];
            EXPECT_LE(finer.error, group.error);
            EXPECT_LE(glm::distance(finer.bounds.centre, group.bounds.centre) + finer.bounds.radius,
                      group.bounds.radius * 1.000001f);
        }
    }
}

TEST(Clusters, BoundsHoldTheirTriangles) {
    const ClusterTree& tree = boulderTree();
    for (const MeshCluster& cluster : tree.clusters) {
        for (std::uint32_t i = 0; i < cluster.indexCount; ++i) {
            const glm::vec3& corner = boulder().vertices[tree.indices[cluster.firstIndex + i]].position;
            EXPECT_LE(glm::distance(corner, cluster.bounds.centre), cluster.bounds.radius);
        }
    }
}

/// A mixture is as far from the mesh as the largest error in it says, and no farther.
TEST(Clusters, ErrorsAreThoseOfTheSurface) {
    const ClusterTree& tree = boulderTree();
    std::vector<glm::vec3> positions;
    for (const Vertex& vertex : boulder().vertices) {
        positions.push_back(vertex.position);
    }
    std::vector<float> errors;
    for (const ClusterGroup& group : tree.groups) {
        errors.push_back(group.error);
    }
    std::sort(errors.begin(), errors.end());
    for (const double share : {0.3, 0.7, 0.9, 1.0}) {
        const float most = errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
        const std::vector<std::uint32_t> drawn =
            indicesWhere(tree, [&](const ClusterGroup& group) { return group.error <= most; });
        const double measured = surfaceDeviation(positions, boulder().indices, drawn);
        EXPECT_LE(measured, static_cast<double>(most) * 1.05) << share;
        EXPECT_GE(measured, static_cast<double>(most) * 0.7) << share;
    }
}

TEST(Clusters, AreTheSameForAnyNumberOfThreads) {
    const ClusterTree alone = clustersOf(boulder(), 1);
    const ClusterTree four = clustersOf(boulder(), 4);
    EXPECT_EQ(alone.indices, four.indices);
    ASSERT_EQ(alone.groups.size(), four.groups.size());
    for (std::size_t i = 0; i < alone.groups.size(); ++i) {
        EXPECT_EQ(alone.groups[i].error, four.groups[i].error);
        EXPECT_EQ(alone.groups[i].bounds.centre, four.groups[i].bounds.centre);
        EXPECT_EQ(alone.groups[i].bounds.radius, four.groups[i].bounds.radius);
    }
    ASSERT_EQ(alone.clusters.size(), four.clusters.size());
    for (std::size_t i = 0; i < alone.clusters.size(); ++i) {
        EXPECT_EQ(alone.clusters[i].bounds.centre, four.clusters[i].bounds.centre);
        EXPECT_EQ(alone.clusters[i].bounds.radius, four.clusters[i].bounds.radius);
        EXPECT_EQ(alone.clusters[i].coneAxis, four.clusters[i].coneAxis);
        EXPECT_EQ(alone.clusters[i].coneCutoff, four.clusters[i].coneCutoff);
    }
}

/// Seams of colour lie where groups meet, too: no hole opens between points at one place.
TEST(Clusters, SeamsStayClosed) {
    Mesh mesh = cdr::scenes::makeTerrain(1, 96).scene.meshes.front();
    const ClusterTree tree = clustersOf(mesh);
    const std::vector<std::uint32_t> coarsest = indicesWhere(tree, [](const ClusterGroup&) { return true; });
    EXPECT_LT(coarsest.size(), mesh.indices.size() / 4);
    EXPECT_EQ(openEdges(coarsest), std::size_t{4 * 96}); // the border of the field, as it was
}

/// A bumpy wall of rows of points, and a fin that stands on its middle row: three triangles meet in each edge of its foot.
class WallWithFin {
  public:
    /// @param isWelded the foot has vertices of the wall; else its own, at the same places.
    explicit WallWithFin(bool isWelded) {
        mesh.boundingRadius = 200.0f;
        addRows(kSide, [](double row) { return glm::dvec3(0.0, wave(row), row); });
        for (std::uint32_t row = 0; row + 1 < kSide; ++row) {
            addQuads(row * kSide, (row + 1) * kSide);
        }
        if (!isWelded) {
            addRows(1, [](double) { return glm::dvec3(0.0, wave(kFoot), kFoot); });
        }
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        addRows(kSide / 2,
                [](double row) { return glm::dvec3(0.0, wave(kFoot) + row + 1.0, kFoot + wave(row)); });
        addQuads(isWelded ? kFoot * kSide : first - kSide, first);
        for (std::uint32_t row = 0; row + 1 < kSide / 2; ++row) {
            addQuads(first + row * kSide, first + (row + 1) * kSide);
        }
    }

    /// How many edges along the foot have one triangle alone: what stands on them has left the wall.
    std::size_t looseEdges(const std::vector<std::uint32_t>& indices) const {
        std::map<std::pair<std::size_t, std::size_t>, int> triangles;
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const std::size_t from = columnOfFoot(indices[i]);
            const std::size_t to = columnOfFoot(indices[i % 3 == 2 ? i - 2 : i + 1]);
            triangles[std::minmax(from, to)] += from < kSide && to < kSide ? 1 : 0;
        }
        return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(),
                                                      [](const auto& edge) { return edge.second == 1; }));
    }

    Mesh mesh;

  private:
    static constexpr std::uint32_t kSide = 96;
    static constexpr std::uint32_t kFoot = kSide / 2;

    static double wave(double row) { return std::sin(1.7 * row); }
    /// Where the vertex is at the foot: its column; else kSide.
    std::size_t columnOfFoot(std::uint32_t vertex) const {
        const glm::vec3& position = mesh.vertices[vertex].position;
        const auto foot = mesh.vertices.begin() + kFoot * kSide;
        return static_cast<std::size_t>(
            std::find_if(foot, foot + kSide, [&](const Vertex& at) { return at.position == position; }) -
            foot);
    }
    void addRows(std::uint32_t rows, const auto& placeOf) {
        for (std::uint32_t row = 0; row < rows; ++row) {
            for (std::uint32_t column = 0; column < kSide; ++column) {
                const glm::dvec3 place = placeOf(row) + glm::dvec3(column, std::cos(2.3 * column), 0.0);
                mesh.vertices.push_back({.position = glm::vec3(place), .normal = {}, .uv = {rows, 0.0f}});
            }
        }
    }
    void addQuads(std::uint32_t low, std::uint32_t high) {
        for (std::uint32_t i = 0; i + 1 < kSide; ++i) {
            mesh.indices.insert(mesh.indices.end(),
                                {low + i, high + i, high + i + 1, low + i, high + i + 1, low + i + 1});
        }
    }
};

TEST(Clusters, WhereThreeTrianglesShareAnEdgeAnyMixtureIsWithoutCracks) {
    for (const bool isWelded : {true, false}) {
        const WallWithFin wall(isWelded);
        EXPECT_EQ(wall.looseEdges(wall.mesh.indices), 0u);
        const auto mixtures = mixturesOf(wall.mesh, clustersOf(wall.mesh));
        EXPECT_GE(mixtures.size(), 5u);
        for (const std::vector<std::uint32_t>& drawn : mixtures) {
            EXPECT_EQ(wall.looseEdges(drawn), 0u) << isWelded << " " << drawn.size();
        }
    }
}

/// Cutting takes time by the square of the triangles around a point.
TEST(Clusters, AFanOfManyTrianglesGetsNone) {
    const auto fanOf = [](std::uint32_t triangles) {
        Mesh fan;
        fan.vertices.push_back({.position = glm::vec3(0.0f)});
        for (std::uint32_t i = 0; i <= triangles; ++i) {
            const double angle = i * 6.0 / triangles;
            fan.vertices.push_back({.position = {std::cos(angle), std::sin(angle), 0.0}});
        }
        for (std::uint32_t i = 1; i <= triangles; ++i) {
            fan.indices.insert(fan.indices.end(), {0, i, i + 1});
        }
        fan.boundingRadius = 1.1f;
        return fan;
    };
    EXPECT_FALSE(clustersOf(fanOf(1000)).clusters.empty());
    EXPECT_TRUE(clustersOf(fanOf(5000)).clusters.empty());
}

TEST(Clusters, SmallMeshesGetNone) {
    cdr::platform::WorkerPool workers(1);
    Scene scene;
    scene.meshes = {cdr::scenes::makeBoulder(1, 2), boulder()};
    makeClusters(scene, workers);
    EXPECT_TRUE(scene.meshes[0].clusters.clusters.empty());
    EXPECT_FALSE(scene.meshes[1].clusters.clusters.empty());
}

} // namespace
