#pragma once

#include <cdr/base/export.h>
#include <cdr/scene/frustum.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <span>
#include <vector>

/// What a frame draws: culling, binning, levels of detail.
/// @threads Functions keep nothing: many threads may call them at once, each with output and workers of its own, while
/// nothing changes the scene.
namespace cdr::visibility {

/// The instances a camera may see, by bounding sphere, in instance order: the first `count` entries of each
/// array. The arrays keep the scene's size from frame to frame, so culling neither allocates nor clears once
/// warm.
struct VisibleList {
    std::vector<std::uint32_t> instance; ///< index of each
    std::vector<double> distanceView;    ///< of each one's centre
    std::vector<float> radius;           ///< of each one, beside its distance so binning reads no scene
    std::size_t count = 0;               ///< that are valid
};

/// Keeps those of some instances whose bounding sphere is not wholly outside one of the six planes (testSpheres()), on
/// the calling thread.
/// @param some indices into `instances`, ascending. VisibleList::instance holds the same indices.
/// @param frustum of the camera and the picture.
/// @param visible overwritten.
/// @errors None.
CDR_EXPORT void cullSpheres(const scene::Instances& instances, std::span<const std::uint32_t> some,
                            const scene::Camera& camera, const scene::Frustum& frustum, VisibleList& visible);

} // namespace cdr::visibility
