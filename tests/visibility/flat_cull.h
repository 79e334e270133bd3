#pragma once

#include <cdr/visibility/cull.h>

#include <numeric>
#include <vector>

/// Every instance tested by itself: what culling by cells is compared with.
inline cdr::visibility::VisibleList flatCull(const cdr::scene::Instances& instances,
                                             const cdr::scene::Camera& camera,
                                             const cdr::scene::Frustum& frustum) {
    std::vector<std::uint32_t> all(instances.size());
    std::iota(all.begin(), all.end(), 0u);
    cdr::visibility::VisibleList visible;
    cullSpheres(instances, all, camera, frustum, visible);
    return visible;
}
