#pragma once

#include <cdr/platform/worker_pool.h>
#include <cdr/scene/frustum.h>
#include <cdr/visibility/cull_cells.h>
#include <cdr/visibility/depth_tiles.h>

namespace cdr::visibility {

/// Takes out of a list what opaque surfaces hide, cell by cell where they hide all of a cell. The same for any number of
/// workers.
/// @param frustum of the camera that `visible` was culled for, and of the picture that the tiles are of.
/// @param tiles how far away surfaces are known to be.
void dropHidden(const scene::Frustum& frustum, const DepthTiles& tiles, platform::WorkerPool& workers,
                VisibleCells& visible);

} // namespace cdr::visibility
