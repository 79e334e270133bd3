#pragma once

#include <cdr/scene/frustum.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <span>
#include <vector>

namespace cdr::render {

/// The lights that a frame is shaded with, by index, in their order. These are the first kMaxShadowLights, since their order
/// gives them channels of a shadow mask. All others belong if their range reaches into the view. The rest lights nothing that
/// is seen: its share is exactly 0 there, so pictures keep their bits.
std::vector<std::uint32_t> seenLights(std::span<const scene::PointLight> lights, const scene::Camera& camera,
                                      const scene::Frustum& frustum);

} // namespace cdr::render
