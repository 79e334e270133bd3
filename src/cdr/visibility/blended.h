#pragma once

#include <cdr/scene/scene.h>

#include <cstdint>
#include <vector>

namespace cdr::scene {

/// The instances whose material blends (AlphaMode::blend): translucent surfaces, which are drawn after all
/// others.
struct BlendedInstances {
    Instances instances;               ///< they alone, in scene order
    std::vector<std::uint32_t> source; ///< of each, its index in the scene
};

BlendedInstances blendedInstances(const Scene& scene);

/// Whether any instance's material blends.
bool hasBlended(const Scene& scene);

/// The scene's instances under their own indices, the blended ones with the most negative radius there is: no
/// view volume is near enough to keep such a sphere.
Instances withoutBlended(const Scene& scene);

} // namespace cdr::scene
