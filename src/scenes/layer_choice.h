#pragma once

#include <cdr/scene/scene.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cdr::scenes {

/// Another layer (scene::Material::layer) for a material than the scene gives it.
struct LayerChoice {
    std::string material; ///< its name, or "#N" for the one of index N
    float layer = 0.0f;   ///< scene units towards the camera

    bool operator==(const LayerChoice&) const = default;
};

/// How a choice names one material: its name where no other has it, else "#N".
std::string materialName(const scene::Scene& scene, std::uint32_t material);

/// The layers of a scene's materials under some choices, by index. All materials of a name are meant, and of two choices the
/// later one holds. base::InputError for a material that the scene has not.
std::vector<float> layersOf(const scene::Scene& scene, std::span<const LayerChoice> choices);

/// Gives the materials of a scene these layers. base::InputError as layersOf(); the scene is then as it was.
void setLayers(scene::Scene& scene, std::span<const LayerChoice> choices);

} // namespace cdr::scenes
