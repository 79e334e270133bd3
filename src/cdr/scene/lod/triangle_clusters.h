#pragma once

#include <cdr/scene/box_tree.h>
#include <cdr/scene/lod/mesh_pieces.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::scene {

/// Triangles that lie together.
struct TriangleCluster {
    std::vector<std::uint32_t> triangles; ///< ascending; triangle t is the indices 3t to 3t + 2
    Box bounds{};                         ///< of their corners

    double radius() const { return 0.5 * bounds.diagonal(); }
};

/// Sorts triangles into clusters and cuts the widest first. It ends when each fits a sphere of `radius`, when
/// there are `most`, or when a cut would not help. A triangle is never cut, so a cluster that is hardly wider
/// than its largest triangle stays. Every triangle is in one cluster. The clusters are the same on every
/// machine. O(triangles log triangles).
/// @param source not empty.
/// @param radius > 0; infinity for one cluster.
std::vector<TriangleCluster> clusterTriangles(const SourceMesh& source, double radius, std::size_t most);

} // namespace cdr::scene
