#include "nodes.h"

#include "checks.h"

#include <glm/gtc/quaternion.hpp>
#include <tiny_gltf.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace cdr::scene::gltf {

namespace {

constexpr int kNoParent = -1;

struct Placement {
    glm::dmat4 toWorld{1.0};
    std::uint32_t depth = 0;
    bool reached = false;
    bool inScene = false;
};

glm::dmat4 localTransform(const tinygltf::Node& node) {
    glm::dmat4 local(1.0);
    if (!node.matrix.empty()) {
        for (int i = 0; i < 16; ++i) {
            local[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        }
        return local;
    }
    if (!node.rotation.empty()) {
        // glTF stores x, y, z, w; glm takes w first, and would take no rotation for the identity.
        const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        const double length = glm::length(rotation);
        if (!(length > 0.0) || !std::isfinite(length)) {
            refuse("node '{}': its rotation has no direction", oneLine(node.name));
        }
        local = glm::mat4_cast(rotation / length);
    }
    for (int c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>(c);
        local[c] *= node.scale.empty() ? 1.0 : node.scale[i];
        local[3][c] = node.translation.empty() ? 0.0 : node.translation[i];
    }
    return local;
}

void requireUsable(const glm::dmat4& matrix, const tinygltf::Node& node, std::size_t index) {
    for (int i = 0; i < 16; ++i) {
        if (!std::isfinite(matrix[i / 4][i % 4])) {
            refuse("node {} '{}': its transform is not finite", index, oneLine(node.name));
        }
    }
    if (matrix[0][3] != 0.0 || matrix[1][3] != 0.0 || matrix[2][3] != 0.0 || matrix[3][3] != 1.0) {
        refuse("node {} '{}': its matrix is not affine", index, oneLine(node.name));
    }
}

/// Refuses children that do not exist or that two nodes share.
std::vector<int> findParents(const tinygltf::Model& model) {
    std::vector<int> parents(model.nodes.size(), kNoParent);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        for (const int child : model.nodes[i].children) {
            itemAt(model.nodes, child, "node");
            int& parent = parents[static_cast<std::size_t>(child)];
            if (parent != kNoParent) {
                refuse("node {} is a child of both node {} and node {}", child, parent, i);
            }
            parent = static_cast<int>(i);
        }
    }
    return parents;
}

/// Marks the roots of the scene that is shown.
void markScene(const tinygltf::Model& model, const std::vector<int>& parents,
               std::optional<std::uint32_t> scene, std::vector<Placement>& placements) {
    if (scene && *scene >= model.scenes.size()) {
        refuse("scene {} does not exist, the file has {}", *scene, model.scenes.size());
    }
    const int shown = scene ? static_cast<int>(*scene) : model.defaultScene;
    if (model.scenes.empty() && shown < 0) {
        for (Placement& placement : placements) {
            placement.inScene = true;
        }
        return;
    }
    for (const int root : itemAt(model.scenes, std::max(shown, 0), "scene").nodes) {
        itemAt(model.nodes, root, "node");
        const auto i = static_cast<std::size_t>(root);
        if (parents[i] != kNoParent || placements[i].inScene) {
            refuse("scene: its node {} is {}", root,
                   parents[i] == kNoParent ? "listed twice" : "a child of another node");
        }
        placements[i].inScene = true;
    }
}

/// Walks down from every root. In a graph where a node has one parent at most, what is not reached is on a
/// cycle.
void place(const tinygltf::Model& model, const std::vector<int>& parents, const GltfLimits& limits,
           std::vector<Placement>& placements) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (parents[i] == kNoParent) {
            open.push_back(i);
        }
    }
    while (!open.empty()) {
        const std::size_t i = open.back();
        open.pop_back();
        Placement& placement = placements[i];
        placement.reached = true;
        if (parents[i] != kNoParent) {
            const Placement& parent = placements[static_cast<std::size_t>(parents[i])];
            placement.toWorld = parent.toWorld;
            placement.depth = parent.depth + 1;
            placement.inScene = parent.inScene;
        }
        if (placement.depth >= limits.maxNodeDepth) {
            refuse("node {} is nested over the limit of {} deep", i, limits.maxNodeDepth);
        }
        placement.toWorld = placement.toWorld * localTransform(model.nodes[i]);
        requireUsable(placement.toWorld, model.nodes[i], i);
        for (const int child : model.nodes[i].children) {
            open.push_back(static_cast<std::size_t>(child));
        }
    }
}

} // namespace

PlacedNodes placeNodes(const tinygltf::Model& model, const GltfLimits& limits,
                       std::optional<std::uint32_t> scene) {
    const std::vector<int> parents = findParents(model);
    std::vector<Placement> placements(model.nodes.size());
    markScene(model, parents, scene, placements);
    place(model, parents, limits, placements);
    PlacedNodes nodes;
    for (std::size_t i = 0; i < placements.size(); ++i) {
        if (!placements[i].reached) {
            refuse("node {} is its own ancestor", i);
        }
        if (placements[i].inScene && model.nodes[i].mesh >= 0) {
            nodes.meshes.push_back({static_cast<int>(i), model.nodes[i].mesh, placements[i].toWorld});
        }
        if (placements[i].inScene && model.nodes[i].camera >= 0) {
            nodes.cameras.push_back({static_cast<int>(i), model.nodes[i].camera, placements[i].toWorld});
        }
    }
    return nodes;
}

} // namespace cdr::scene::gltf
