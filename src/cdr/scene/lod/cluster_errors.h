#pragma once

#include <cdr/platform/worker_pool.h>
#include <cdr/scene/cluster_tree.h>
#include <cdr/scene/lod/shared_mesh.h>
#include <cdr/scene/lod/surface_distance.h>

#include <cstdint>
#include <span>
#include <vector>

namespace cdr::scene {

/// A cluster that no coarser form takes the place of yet.
struct LooseCluster {
    std::vector<std::uint32_t> indices{}; ///< into SharedMesh::positions
    std::uint32_t madeBy = kNoGroup;
};

/// The error of each group, both ways. One is from the clusters that it made to the mesh, sampled, the other from the
/// mesh's vertices to these clusters. A vertex counts for the clusters that are nearest to it.
/// @param surface clusters that stand for all of the mesh.
/// @param groups that are measured; 0 for those before.
std::vector<double> measureErrors(const SharedMesh& mesh, const SurfaceDistance& toMesh,
                                  std::span<const LooseCluster> surface, platform::IndexRange groups,
                                  platform::WorkerPool& workers);

} // namespace cdr::scene
