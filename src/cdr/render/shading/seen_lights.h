#pragma once

#include <cdr/scene/frustum.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <vector>

namespace cdr::render {

/// The lights that a frame is shaded with, by index. First come all of scene::shadowLights(), since their order gives them
/// channels of a shadow mask. Others belong if their range reaches into the view. The rest lights nothing that is seen: its
/// share is exactly 0 there, so pictures keep their bits.
std::vector<std::uint32_t> seenLights(const std::vector<scene::PointLight>& lights,
                                      const scene::Camera& camera, const scene::Frustum& frustum);

} // namespace cdr::render
