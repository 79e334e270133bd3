#pragma once

/// @file
/// @errors None.

#include <cdr/base/export.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/scene.h>

#include <cstddef>

namespace cdr::scene {

/// Meshes of fewer triangles get no clusters: one level for all of such a mesh is enough.
inline constexpr std::size_t kMinClusteredTriangles = 8192;

/// Cuts a mesh into clusters (meshoptimizer). Then it makes coarser clusters of groups of neighbours by edge collapses, and
/// repeats this. The border of a group stays as it is, and where other groups touch it. Errors are measured against the mesh, sampled, both ways. The tree is
/// the same each time, for any number of workers. It takes about twice the indices of the mesh. It is empty where more than
/// 4,096 triangles meet in one point, as in a fan.
///
/// After Ponchio, Cignoni, Ganovelli, Gobbetti, Marton and Scopigno (Batched Multi Triangulation, 2005) and Karis, Stubbe
/// and Wihlidal (A Deep Dive into Nanite, 2021).
/// @param mesh that requireUsable() lets pass, which is not checked, of a triangle at least.
CDR_EXPORT ClusterTree makeClusters(const Mesh& mesh, platform::WorkerPool& workers);

/// Makes those of each mesh of kMinClusteredTriangles or more that has none.
CDR_EXPORT void makeClusters(Scene& scene, platform::WorkerPool& workers);

} // namespace cdr::scene
