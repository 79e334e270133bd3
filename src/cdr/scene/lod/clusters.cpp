#include <cdr/scene/box_tree.h>
#include <cdr/scene/lod/cluster_errors.h>
#include <cdr/scene/lod/cluster_groups.h>
#include <cdr/scene/lod/clusters.h>
#include <cdr/scene/lod/shared_mesh.h>

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace cdr::scene {

namespace {

constexpr std::size_t kClusterVertices = 160;
constexpr std::size_t kClusterTriangles = 256;
constexpr std::size_t kGroupClusters = 8;
/// A coarser form with more of the triangles than this is not worth a level.
constexpr double kMaxLeft = 0.8;
/// No coarser form of a group has fewer triangles.
constexpr std::size_t kMinTriangles = 12;
/// A mesh with a point that more triangles meet in is not cut: that takes time by their square.
constexpr std::size_t kMaxAround = 4096;
/// For roundings of float32 spheres.
constexpr double kSphereMargin = 1.0 + 1e-6;

using Indices = std::vector<std::uint32_t>;

/// The vertices of some triangles alone, since the simplifier takes time by all that it is given.
struct PartOfMesh {
    std::vector<glm::vec3> positions;
    Indices indices;  ///< into these
    Indices vertices; ///< by position: those of the whole
};

PartOfMesh partOf(const SharedMesh& mesh, const Indices& indices) {
    PartOfMesh part;
    part.vertices = indices;
    std::sort(part.vertices.begin(), part.vertices.end());
    part.vertices.erase(std::unique(part.vertices.begin(), part.vertices.end()), part.vertices.end());
    for (const std::uint32_t vertex : part.vertices) {
        part.positions.push_back(mesh.positions[vertex]);
    }
    for (const std::uint32_t index : indices) {
        const auto found = std::lower_bound(part.vertices.begin(), part.vertices.end(), index);
        part.indices.push_back(static_cast<std::uint32_t>(found - part.vertices.begin()));
    }
    return part;
}

/// Cuts triangles into clusters.
std::vector<Indices> cut(const Indices& indices, const std::vector<glm::vec3>& positions) {
    constexpr float kConeWeight = 0.25f; // of facing alike, against being round
    std::vector<meshopt_Meshlet> meshlets(
        meshopt_buildMeshletsBound(indices.size(), kClusterVertices, kClusterTriangles));
    std::vector<unsigned int> vertices(meshlets.size() * kClusterVertices);
    std::vector<unsigned char> triangles(meshlets.size() * kClusterTriangles * 3);
    meshlets.resize(meshopt_buildMeshlets(
        meshlets.data(), vertices.data(), triangles.data(), indices.data(), indices.size(), &positions[0].x,
        positions.size(), sizeof(glm::vec3), kClusterVertices, kClusterTriangles, kConeWeight));
    std::vector<Indices> clusters;
    for (const meshopt_Meshlet& meshlet : meshlets) {
        Indices& cluster = clusters.emplace_back(std::size_t{meshlet.triangle_count} * 3);
        for (std::size_t i = 0; i < cluster.size(); ++i) {
            cluster[i] = vertices[meshlet.vertex_offset + triangles[meshlet.triangle_offset + i]];
        }
    }
    return clusters;
}

/// The clusters of a coarser form; none: the triangles do not get fewer.
/// @param isFixed by vertex of the mesh.
std::vector<Indices> coarserFormOf(const SharedMesh& mesh, const Indices& indices,
                                   const std::vector<bool>& isFixed) {
    const PartOfMesh part = partOf(mesh, indices);
    std::vector<glm::vec3> positions = part.positions;
    for (const std::uint32_t vertex : part.vertices) {
        if (isFixed[vertex]) { // the simplifier leaves a point as it is where an unused vertex lies
            positions.push_back(mesh.positions[vertex]);
        }
    }
    const Indices coarse = simplified(part.indices, positions, part.indices.size() / 6);
    if (coarse.size() / 3 < kMinTriangles ||
        static_cast<double>(coarse.size()) > kMaxLeft * static_cast<double>(part.indices.size())) {
        return {};
    }
    std::vector<Indices> clusters = cut(coarse, part.positions);
    for (Indices& cluster : clusters) {
        for (std::uint32_t& index : cluster) {
            index = part.vertices[index];
        }
    }
    return clusters;
}

float floatAbove(double value) {
    return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

/// Puts finished clusters and groups into a tree.
class TreeBuilder {
  public:
    explicit TreeBuilder(const SharedMesh& mesh) : m_mesh(mesh) {}

    void add(const LooseCluster& cluster, std::uint32_t coarserBy) {
        const meshopt_Bounds bounds =
            meshopt_computeClusterBounds(cluster.indices.data(), cluster.indices.size(),
                                         &m_mesh.positions[0].x, m_mesh.positions.size(), sizeof(glm::vec3));
        const glm::vec3 centre(bounds.center[0], bounds.center[1], bounds.center[2]);
        double radius = 0.0;
        for (const std::uint32_t index : cluster.indices) {
            radius = std::max(radius, glm::distance(glm::dvec3(centre), glm::dvec3(m_mesh.positions[index])));
        }
        m_tree.clusters.push_back(
            {.firstIndex = static_cast<std::uint32_t>(m_tree.indices.size()),
             .indexCount = static_cast<std::uint32_t>(cluster.indices.size()),
             .madeBy = cluster.madeBy,
             .coarserBy = coarserBy,
             .bounds = {.centre = centre, .radius = floatAbove(radius * kSphereMargin)},
             .coneAxis = {bounds.cone_axis[0], bounds.cone_axis[1], bounds.cone_axis[2]},
             .coneCutoff = bounds.cone_cutoff});
        for (const std::uint32_t index : cluster.indices) {
            m_tree.indices.push_back(m_mesh.vertices[index]);
        }
    }

    /// Its number. Its error is that of its clusters until it is measured.
    std::uint32_t addGroup(std::span<const LooseCluster* const> clusters) {
        const auto group = static_cast<std::uint32_t>(m_tree.groups.size());
        const auto first = static_cast<std::uint32_t>(m_tree.clusters.size());
        float finerError = 0.0f;
        std::vector<ClusterSphere> held;
        for (const LooseCluster* cluster : clusters) {
            add(*cluster, group);
            held.push_back(m_tree.clusters.back().bounds);
            if (cluster->madeBy != kNoGroup) {
                const ClusterGroup& finer = m_tree.groups[cluster->madeBy];
                finerError = std::max(finerError, finer.error);
                held.push_back(finer.bounds);
            }
        }
        m_tree.groups.push_back({.firstCluster = first,
                                 .clusterCount = static_cast<std::uint32_t>(clusters.size()),
                                 .bounds = sphereOver(held),
                                 .error = finerError});
        return group;
    }

    /// @param errors by group, of those from `first` on.
    void setErrors(std::size_t first, std::span<const double> errors) {
        for (std::size_t group = first; group < m_tree.groups.size(); ++group) {
            float& error = m_tree.groups[group].error;
            error = std::max(error, floatAbove(errors[group]));
        }
    }

    std::size_t groups() const { return m_tree.groups.size(); }
    ClusterTree finish() { return std::move(m_tree); }

  private:
    static ClusterSphere sphereOver(std::span<const ClusterSphere> spheres) {
        Box box;
        for (const ClusterSphere& sphere : spheres) {
            box.add(glm::dvec3(sphere.centre - sphere.radius));
            box.add(glm::dvec3(sphere.centre + sphere.radius));
        }
        const glm::vec3 centre(box.centre());
        double radius = 0.0;
        for (const ClusterSphere& sphere : spheres) {
            radius = std::max(radius, glm::distance(glm::dvec3(centre), glm::dvec3(sphere.centre)) +
                                          static_cast<double>(sphere.radius));
        }
        return {.centre = centre, .radius = floatAbove(radius * kSphereMargin)};
    }

    const SharedMesh& m_mesh;
    ClusterTree m_tree;
};

/// By index of a shared mesh: the point of space where it is.
Indices placesOf(const SharedMesh& mesh) {
    Indices places(mesh.positions.size());
    meshopt_generateVertexRemap(places.data(), mesh.indices.data(), mesh.indices.size(),
                                mesh.positions.data(), mesh.positions.size(), sizeof(glm::vec3));
    return places;
}

/// How many triangles meet in the point that most meet in.
std::size_t mostAround(const SharedMesh& mesh, const Indices& places) {
    std::vector<std::size_t> around(mesh.positions.size());
    for (const std::uint32_t index : mesh.indices) {
        ++around[places[index]];
    }
    return *std::max_element(around.begin(), around.end());
}

/// By vertex: whether clusters of several groups meet at its place. Where more than two triangles share an edge, that is no
/// open border in all of the groups.
std::vector<bool> whereGroupsMeet(const std::vector<std::vector<std::size_t>>& groups,
                                  const std::vector<Indices>& clusters, const Indices& places) {
    constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> userOf(places.size(), kNone); // by place, the last one
    std::vector<bool> isShared(places.size());
    for (std::size_t group = 0; group < groups.size(); ++group) {
        for (const std::size_t cluster : groups[group]) {
            for (const std::uint32_t index : clusters[cluster]) {
                const std::size_t before = std::exchange(userOf[places[index]], group);
                isShared[places[index]] = isShared[places[index]] || (before != kNone && before != group);
            }
        }
    }
    std::vector<bool> meet(places.size());
    for (std::size_t vertex = 0; vertex < places.size(); ++vertex) {
        meet[vertex] = isShared[places[vertex]];
    }
    return meet;
}

/// One level coarser: groups that get coarser go into the tree, and what is loose afterwards is returned.
std::vector<LooseCluster> coarsened(const SharedMesh& mesh, const Indices& places,
                                    std::vector<LooseCluster> loose, platform::WorkerPool& workers,
                                    TreeBuilder& tree) {
    std::vector<Indices> clusters;
    for (const LooseCluster& cluster : loose) {
        clusters.push_back(cluster.indices);
    }
    const std::vector<std::vector<std::size_t>> groups = groupClusters(clusters, places, kGroupClusters);
    const std::vector<bool> isFixed = whereGroupsMeet(groups, clusters, places);
    std::vector<std::vector<Indices>> forms(groups.size());
    workers.run(groups.size(), [&](std::size_t group, std::size_t) {
        Indices joined;
        for (const std::size_t cluster : groups[group]) {
            joined.insert(joined.end(), clusters[cluster].begin(), clusters[cluster].end());
        }
        forms[group] = coarserFormOf(mesh, joined, isFixed);
    });
    std::vector<LooseCluster> next;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (forms[i].empty()) {
            for (const std::size_t cluster : groups[i]) {
                next.push_back(std::move(loose[cluster]));
            }
            continue;
        }
        std::vector<const LooseCluster*> finer;
        for (const std::size_t cluster : groups[i]) {
            finer.push_back(&loose[cluster]);
        }
        const std::uint32_t group = tree.addGroup(finer);
        for (Indices& cluster : forms[i]) {
            next.push_back({.indices = std::move(cluster), .madeBy = group});
        }
    }
    return next;
}

} // namespace

ClusterTree makeClusters(const Mesh& mesh, platform::WorkerPool& workers) {
    const SharedMesh shared = sharedBy(mesh);
    const Indices places = placesOf(shared);
    if (mostAround(shared, places) > kMaxAround) {
        return {};
    }
    std::vector<LooseCluster> loose;
    for (Indices& cluster : cut(shared.indices, shared.positions)) {
        loose.push_back({.indices = std::move(cluster)});
    }
    TreeBuilder tree(shared);
    const SurfaceDistance toMesh(shared.positions, shared.indices);
    for (std::size_t grouped = 0;;) {
        loose = coarsened(shared, places, std::move(loose), workers, tree);
        if (tree.groups() == grouped) {
            break; // nothing got coarser
        }
        tree.setErrors(grouped, measureErrors(shared, toMesh, loose, {grouped, tree.groups()}, workers));
        grouped = tree.groups();
    }
    for (const LooseCluster& cluster : loose) {
        tree.add(cluster, kNoGroup);
    }
    return tree.finish();
}

void makeClusters(Scene& scene, platform::WorkerPool& workers) {
    for (Mesh& mesh : scene.meshes) {
        if (mesh.clusters.clusters.empty() && mesh.indices.size() / 3 >= kMinClusteredTriangles) {
            mesh.clusters = makeClusters(mesh, workers);
        }
    }
}

} // namespace cdr::scene
