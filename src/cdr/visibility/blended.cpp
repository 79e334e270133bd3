#include <cdr/visibility/blended.h>

#include <algorithm>

namespace cdr::visibility {

namespace {

bool isBlended(const scene::Scene& scene, std::uint32_t material) {
    return scene.materials[material].alphaMode == scene::AlphaMode::blend;
}

} // namespace

std::vector<std::uint32_t> blendedInstances(const scene::Scene& scene) {
    std::vector<std::uint32_t> blended;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        if (isBlended(scene, scene.instances.material[i])) {
            blended.push_back(static_cast<std::uint32_t>(i));
        }
    }
    return blended;
}

bool hasBlended(const scene::Scene& scene) {
    const std::vector<std::uint32_t>& materials = scene.instances.material;
    return std::any_of(materials.begin(), materials.end(),
                       [&](std::uint32_t material) { return isBlended(scene, material); });
}

} // namespace cdr::visibility
