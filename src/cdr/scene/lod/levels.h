#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/scene.h>

#include <cstddef>
#include <vector>

namespace cdr::scene {

/// How levels of detail are made.
struct LevelOptions {
    double ratio = 0.5;              ///< triangles of a level as a share of the one before it, in (0, 1)
    double leastGain = 0.1;          ///< making stops where a level saves less than this share, in [0, 1)
    std::size_t most = 12;           ///< levels beside the mesh itself, at most kMaxLevels
    std::size_t leastTriangles = 12; ///< no level has fewer
};

/// Coarser levels of a mesh, by edge collapses (meshoptimizer). Each collapse moves a vertex onto a
/// neighbour, so levels use the mesh's own vertices. Open borders stay as they are, so neighbours that share
/// one still meet, whatever level each is drawn at. Seams of normals, colours and texture coordinates are
/// collapsed along themselves alone. A level's error is measured (surfaceDeviation()): the simplifier's own
/// figure, a mean over quadrics, was exceeded up to twice. Errors ascend. The same levels each time.
///
/// Empty where nothing can be saved.
/// @param mesh that requireUsable() lets pass, which is not checked.
/// @throws base::InputError for unusable options.
CDR_EXPORT std::vector<MeshLevel> makeLevels(const Mesh& mesh, const LevelOptions& options = {});

/// Makes the levels of every mesh that has none, and no clusters; those the scene's maker gave stay. The same levels for any
/// number of workers.
/// @throws base::InputError for unusable options, where a mesh has no levels.
CDR_EXPORT void makeLevels(Scene& scene, platform::WorkerPool& workers, const LevelOptions& options = {});

} // namespace cdr::scene
