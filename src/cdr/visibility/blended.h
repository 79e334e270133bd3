#pragma once

#include <cdr/scene/scene.h>

#include <cstdint>
#include <vector>

namespace cdr::visibility {

/// The instances whose material blends (AlphaMode::blend): translucent surfaces, which are drawn after all
/// others.
struct BlendedInstances {
    scene::Instances instances;        ///< they alone, in scene order
    std::vector<std::uint32_t> source; ///< of each, its index in the scene
};

BlendedInstances blendedInstances(const scene::Scene& scene);

/// Whether any instance's material blends.
bool hasBlended(const scene::Scene& scene);

/// The scene's instances under their own indices, the blended ones with the most negative radius there is: no
/// view volume is near enough to keep such a sphere.
scene::Instances withoutBlended(const scene::Scene& scene);

} // namespace cdr::visibility
