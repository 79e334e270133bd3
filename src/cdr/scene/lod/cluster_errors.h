#pragma once

#include <cdr/host/worker_pool.h>
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

/// By group: how far the clusters that it made are from the mesh, sampled, and how far the vertices of the mesh are that are
/// nearest to these.
/// @param surface clusters that stand for all of the mesh.
/// @param groups that are measured; 0 for those before.
std::vector<double> measureErrors(const SharedMesh& mesh, const SurfaceDistance& toMesh,
                                  std::span<const LooseCluster> surface, host::IndexRange groups,
                                  host::WorkerPool& workers);

} // namespace cdr::scene
