#pragma once

#include <cdr/scene/scene_setup.h>

#include <cstdint>

namespace cdr::scenes {

/// For scenes that move: cubes on circles about the camera, from 1 to 10,000,000 units away, as many in each decade. Each
/// has a circle, a pace and a spin of its own, and is a hundredth as wide as it is far. The camera turns once about y in 360
/// frames: 60 degrees, near 0.5, far 20,000,000.
/// base::InputError for more movers than a scene may have objects.
scene::SceneSetup makeTraffic(std::uint64_t seed, std::uint32_t movers = 100'000);

} // namespace cdr::scenes
