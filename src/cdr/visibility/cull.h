#pragma once

#include <cdr/host/worker_pool.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <vector>

namespace cdr::visibility {

/// The instances a camera may see, by bounding sphere, in instance order: the first `count` entries of each
/// array. The arrays keep the scene's size from frame to frame, so culling neither allocates nor clears once
/// warm.
struct VisibleList {
    std::vector<std::uint32_t> instance;
    std::vector<double> distanceView; ///< of each one's centre
    std::vector<float> radius;        ///< of each one, beside its distance so binning reads no scene
    std::size_t count = 0;
};

/// Sphere against frustum (thesis Listing A.1): keeps every instance whose bounding sphere is not wholly
/// outside one of the six planes. The same list, in the same order, for any number of workers.
/// @param aspect width over height of the picture.
/// @param visible overwritten.
void cullSpheres(const scene::Instances& instances, const scene::Camera& camera, double aspect,
                 host::WorkerPool& workers, VisibleList& visible);

} // namespace cdr::visibility
