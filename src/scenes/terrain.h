#pragma once

#include <cdr/scene/scene_setup.h>

#include <cstdint>

namespace cdr::scenes {

/// Hills of 40 km by 40 km as one mesh, for levels of detail that differ within a mesh. It is in full near the camera, and
/// coarse at the horizon. The lens is 60 degrees, near 1, far 60,000. In 360 frames the camera circles the middle once, at a radius of
/// 500, and looks ahead.
/// @param cells along each side, 1 to 2048; two triangles each. base::InputError for others.
scene::SceneSetup makeTerrain(std::uint64_t seed, std::uint32_t cells = 1024);

} // namespace cdr::scenes
