#include "scene_choice.h"

#include <cdr/base/error.h>
#include <scenes/open_scene.h>

namespace cdr::cli {

void addSceneChoice(CLI::App& command, scene::GltfChoice& choice) {
    command.add_option("--gltf-scene", choice.scene, "Scene of a glTF file, from 0; its default one");
    command.add_option("--camera", choice.camera,
                       "Look through a glTF scene's perspective camera, from 0; else all of it is framed");
}

scene::OpenedScene openChosen(const std::string& nameOrPath, std::uint64_t seed,
                              const scene::GltfChoice& choice) {
    if (!choice.scene && !choice.camera) {
        return scenes::openScene(nameOrPath, seed);
    }
    if (!scene::isGltfPath(nameOrPath)) {
        throw base::InputError("--gltf-scene and --camera are for .gltf and .glb files, not " + nameOrPath);
    }
    return scene::openGltf(nameOrPath, choice);
}

} // namespace cdr::cli
