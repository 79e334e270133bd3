#pragma once

#include <cdr/scene/scene_setup.h>

#include <cstdint>

namespace cdr::scenes {

/// Hills of 40 km by 40 km as one mesh, for levels of detail that differ within a mesh: in full near the camera, coarse at
/// the horizon. 60 degrees, near 1, far 60,000; in 360 frames the camera circles once at a radius of 500 over the middle,
/// looking ahead.
/// @param cells along each side, 1 to 2048; two triangles each. base::InputError for others.
scene::SceneSetup makeTerrain(std::uint64_t seed, std::uint32_t cells = 1024);

} // namespace cdr::scenes
