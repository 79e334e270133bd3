#pragma once

#include <cdr/scene/scene_setup.h>

#include <cstdint>

namespace cdr::scenes {

/// For occlusion culling: a town of boxes seen from one of its streets, where houses hide nearly all of it. Blocks of 100
/// units, each of 16 houses with windows, ledges and roofs, and of cars, lamps and trees. It is 625 boxes, each an object
/// of its own. The camera goes along a street, 1.7 units above it, and turns into another one. 60 degrees, near 0.2, far
/// 8,000, 240 frames. base::InputError for more boxes than a scene may have objects.
/// @param blocks along each side of the town, even.
scene::SceneSetup makeCity(std::uint64_t seed, std::uint32_t blocks = 40);

} // namespace cdr::scenes
