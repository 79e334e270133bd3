#include <cdr/visibility/blended.h>

#include <algorithm>
#include <limits>

namespace cdr::visibility {

namespace {

bool isBlended(const scene::Scene& scene, std::size_t i) {
    return scene.materials[scene.instances.material[i]].alphaMode == scene::AlphaMode::blend;
}

} // namespace

BlendedInstances blendedInstances(const scene::Scene& scene) {
    const scene::Instances& all = scene.instances;
    BlendedInstances blended;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!isBlended(scene, i)) {
            continue;
        }
        scene::Instances& some = blended.instances;
        some.x.push_back(all.x[i]);
        some.y.push_back(all.y[i]);
        some.z.push_back(all.z[i]);
        some.radius.push_back(all.radius[i]);
        some.basis.push_back(all.basis[i]);
        some.mesh.push_back(all.mesh[i]);
        some.material.push_back(all.material[i]);
        some.object.push_back(all.object[i]);
        blended.source.push_back(static_cast<std::uint32_t>(i));
    }
    return blended;
}

bool hasBlended(const scene::Scene& scene) {
    const std::vector<std::uint32_t>& materials = scene.instances.material;
    return std::any_of(materials.begin(), materials.end(), [&](std::uint32_t material) {
        return scene.materials[material].alphaMode == scene::AlphaMode::blend;
    });
}

scene::Instances withoutBlended(const scene::Scene& scene) {
    scene::Instances opaque = scene.instances;
    for (std::size_t i = 0; i < opaque.size(); ++i) {
        if (isBlended(scene, i)) {
            opaque.radius[i] = std::numeric_limits<float>::lowest();
        }
    }
    return opaque;
}

} // namespace cdr::visibility
