#pragma once

/// @file
/// @errors None: what is wanted of arguments is not checked.

#include <cdr/base/export.h>
#include <cdr/depth/cascade.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/frustum.h>
#include <cdr/scene/scene.h>
#include <cdr/visibility/bin.h>
#include <cdr/visibility/level_choice.h>

namespace cdr::visibility {

/// What levels of detail are chosen for.
struct DetailView {
    const scene::Camera& camera;       ///< of the frame
    const scene::Frustum& frustum;     ///< of the camera and the picture
    const depth::Cascades& clipRanges; ///< as binByDistance() took them
    double wideSpan = 0.0;             ///< likewise
    LevelRule levels{};                ///< of the frustum and the picture
};

/// Puts runs of clusters in the place of each draw of a mesh that has them (scene::ClusterTree). At each place it takes the coarsest
/// form whose error is small enough. In world space it is at most `levels.slope` times the view distance of its group's sphere. That
/// is w - r, but no nearer than the near plane. Clusters outside the frustum or the draw's cascade are left out. So are clusters
/// that face away from the camera, unless the material has two sides. Whether a run is wide depends on its own clusters, not on the
/// instance. Draws of one instance follow one another in the order of its clusters. The lists are the same for any number of
/// workers.
/// @param lists of binByDistance() over the same camera and ranges, after chooseLevels().
CDR_EXPORT void chooseClusters(const scene::Scene& scene, const DetailView& view,
                               platform::WorkerPool& workers, DrawLists& lists);

/// Chooses as `levels.mode` says: chooseLevels(), and chooseClusters() where clusters are wanted.
CDR_EXPORT void chooseDetail(const scene::Scene& scene, const DetailView& view, platform::WorkerPool& workers,
                             DrawLists& lists);

} // namespace cdr::visibility
