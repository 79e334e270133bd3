#include <cdr/visibility/blended.h>

namespace cdr::visibility {

bool isBlended(const scene::Scene& scene, std::size_t instance) {
    const scene::Instances& instances = scene.instances;
    return scene.materials[instances.material[instance]].alphaMode == scene::AlphaMode::blend &&
           instances.radius[instance] != scene::kNoRadius;
}

std::vector<std::uint32_t> blendedInstances(const scene::Scene& scene) {
    std::vector<std::uint32_t> blended;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        if (isBlended(scene, i)) {
            blended.push_back(static_cast<std::uint32_t>(i));
        }
    }
    return blended;
}

bool hasBlended(const scene::Scene& scene) {
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        if (isBlended(scene, i)) {
            return true;
        }
    }
    return false;
}

} // namespace cdr::visibility
