#pragma once

/// @file
/// @errors None.

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace cdr::scene {

/// No group of a ClusterTree.
inline constexpr std::uint32_t kNoGroup = 0xffffffffu;

/// A ball in the object space of a mesh.
struct ClusterSphere {
    glm::vec3 centre{0.0f}; ///< object space
    float radius = 0.0f;    ///< 0 or more
};

/// A few hundred triangles of a mesh, or of a coarser form of a part of it.
struct MeshCluster {
    std::uint32_t firstIndex = 0; ///< into ClusterTree::indices
    std::uint32_t indexCount = 0; ///< three per triangle
    /// The group whose coarser form this cluster is part of; kNoGroup: it is part of the mesh itself.
    std::uint32_t madeBy = kNoGroup;
    /// The group whose coarser form takes the place of this cluster; kNoGroup: there is none coarser.
    std::uint32_t coarserBy = kNoGroup;
    ClusterSphere bounds{}; ///< holds its triangles
    glm::vec3 coneAxis{
        0.0f}; ///< the mean direction that its triangles face, of length 1; 0 if they face all ways
    /// All its triangles face away from a camera at c where dot(centre - c, coneAxis) >= coneCutoff * length(centre - c) +
    /// radius. In [0, 1], and 1 where they face all ways.
    float coneCutoff = 1.0f;
};

/// Neighbouring clusters that are drawn together in full, or together in a coarser form.
struct ClusterGroup {
    std::uint32_t firstCluster = 0; ///< those that the coarser form takes the place of
    std::uint32_t clusterCount = 0; ///< how many follow one another
    /// Holds these clusters, and the spheres of the groups that they were made by. So error divided by distance only grows
    /// from the mesh to its coarsest form.
    ClusterSphere bounds{};
    /// Object space: the Hausdorff distance between the coarser form and its part of the mesh. If a finer group that it
    /// was made from has a larger error, it is that. So it grows as well.
    float error = 0.0f;
};

/// A mesh as clusters at many levels of detail, which can be mixed in one picture without cracks. The border of a group is
/// the same in full and in its coarser form. Empty unless scene::makeClusters() was called (lod/clusters.h).
///
/// The clusters that stand for the mesh have a `madeBy` group whose error is small enough. The error of their `coarserBy`
/// group is too large (visibility::chooseClusters()).
struct ClusterTree {
    std::vector<std::uint32_t> indices; ///< each below the mesh's vertices.size()
    std::vector<MeshCluster> clusters;  ///< those of groups first, group by group
    std::vector<ClusterGroup> groups;   ///< each after the groups that its clusters were made by
};

} // namespace cdr::scene
