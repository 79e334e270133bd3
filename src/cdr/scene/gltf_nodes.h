#pragma once

#include <cdr/scene/gltf.h>

#include <glm/glm.hpp>

#include <vector>

namespace tinygltf {
class Model;
}

namespace cdr::scene::gltf {

/// A node with a mesh and where it stands.
struct MeshNode {
    int node = 0;
    int mesh = 0;
    glm::dmat4 toWorld{1.0};
};

/// The nodes of the default scene that carry a mesh, in the order of the file's node array. Without a default
/// scene the first one counts, and without any scene all nodes do.
std::vector<MeshNode> meshNodes(const tinygltf::Model& model, const GltfLimits& limits);

} // namespace cdr::scene::gltf
