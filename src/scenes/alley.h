#pragma once

#include <cdr/scene/scene_setup.h>

#include <cstdint>

namespace cdr::scenes {

/// For depth of field: a tiled alley from under the camera to 240 units away, with blocks along both sides
/// and posts beside them. A few cubes are in the way, the first 12 units ahead. Detail at every distance,
/// and a floor that every boundary between cascades cuts. 50 degrees, near 0.5, far 500, one still camera
/// 1.7 above the tiles.
scene::SceneSetup makeAlley(std::uint64_t seed);

} // namespace cdr::scenes
