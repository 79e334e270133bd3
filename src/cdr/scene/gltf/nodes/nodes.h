#pragma once

#include "../notes.h"

#include <cdr/scene/animation/pose.h>
#include <cdr/scene/gltf/gltf.h>

#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::scene::gltf {

/// Hides a node and all below it, but for cameras, which show nothing themselves.
inline constexpr const char* kVisibility = "KHR_node_visibility";

/// A node with a mesh and where it stands.
struct MeshNode {
    int node = 0;
    int mesh = 0;
    glm::dmat4 toWorld{1.0};      ///< of the node, or of one of its copies
    std::optional<float> layer{}; ///< of all that it draws, instead of its materials' own
    std::optional<int> skin{};
    std::optional<glm::dmat4> toNode{}; ///< of a copy
};

/// A node with a camera.
struct CameraNode {
    int node = 0;
    int camera = 0;
    glm::dmat4 toWorld{1.0};
};

/// A node with a light.
struct LightNode {
    int node = 0;
    int light = 0;
    glm::dmat4 toWorld{1.0};
};

/// Where a node of the file stands.
struct PlacedNode {
    std::optional<std::size_t> parent{};
    glm::dmat4 toWorld{1.0};
    bool inScene = false;
};

/// What a document says of how a node stands in its parent.
struct NodeTransform {
    LocalTransform local;
    std::optional<glm::dmat4> matrix; ///< instead
};

/// Refuses a rotation without direction.
NodeTransform readTransform(const nlohmann::json& node);

/// What stands in a scene, in the order of the file's node array.
struct PlacedNodes {
    std::vector<PlacedNode> all;    ///< every node of the file
    std::vector<std::size_t> order; ///< all of them, parents first
    std::vector<MeshNode> meshes;   ///< that are not hidden
    std::vector<CameraNode> cameras;
    std::vector<LightNode> lights; ///< that are not hidden
};

/// The nodes of a document's scene, or without one of the default scene that carry something. Without a default scene
/// the first one counts, and without any scene all nodes do.
PlacedNodes placeNodes(const nlohmann::json& root, const GltfLimits& limits,
                       std::optional<std::uint32_t> scene, Notes& notes);

} // namespace cdr::scene::gltf
