#include "nodes.h"

#include "../checks.h"
#include "../json.h"
#include "../materials/layer.h"
#include "lights.h"

#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr int kNoParent = -1;

struct Placement {
    glm::dmat4 toWorld{1.0};
    std::uint32_t depth = 0;
    bool reached = false;
    bool inScene = false;
    bool hidden = false;          ///< the node or an ancestor
    std::optional<float> layer{}; ///< of the node, else of its nearest ancestor that has one
};

/// What a document says of a node, except for its transform, which is read when it is placed.
struct NodeSource {
    std::vector<int> children;
    int mesh = -1;   ///< or none
    int camera = -1; ///< or none
    int light = -1;  ///< or none
    std::optional<int> skin{};
};

int lightOf(const json& node) {
    const json* extension = extensionOf(node, kLights);
    return extension == nullptr ? -1 : indexMember(*extension, "light").value_or(-1);
}

bool isHidden(const json& node, const std::string& where) {
    const json* extension = extensionOf(node, kVisibility);
    return extension != nullptr && member(*extension, "visible") != nullptr &&
           !boolMember(*extension, "visible", where);
}

std::vector<NodeSource> readNodes(const json& root) {
    std::vector<NodeSource> nodes;
    nodes.reserve(arrayMember(root, "nodes").size());
    for (std::size_t i = 0; i < arrayMember(root, "nodes").size(); ++i) {
        const json& node = itemAt(root, "nodes", static_cast<int>(i), "node");
        nodes.push_back({.children = indicesMember(node, "children"),
                         .mesh = indexMember(node, "mesh").value_or(-1),
                         .camera = indexMember(node, "camera").value_or(-1),
                         .light = lightOf(node),
                         .skin = indexMember(node, "skin")});
    }
    return nodes;
}

void requireUsable(const glm::dmat4& matrix, const json& node, std::size_t index) {
    for (int i = 0; i < 16; ++i) {
        if (!std::isfinite(matrix[i / 4][i % 4])) {
            refuse("node {} '{}': its transform is not finite", index, nameOf(node));
        }
    }
    if (matrix[0][3] != 0.0 || matrix[1][3] != 0.0 || matrix[2][3] != 0.0 || matrix[3][3] != 1.0) {
        refuse("node {} '{}': its matrix is not affine", index, nameOf(node));
    }
}

/// Exporters that invert matrices in float32 leave such roundings in the last row.
constexpr double kLastRowRounding = 1e-5;

/// The matrix with an exact last row, where only roundings keep it from being affine.
glm::dmat4 withoutRoundings(glm::dmat4 matrix) {
    const glm::dvec4 affine(0.0, 0.0, 0.0, 1.0);
    const glm::dvec4 last(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]);
    if (glm::all(glm::lessThanEqual(glm::abs(last - affine), glm::dvec4(kLastRowRounding)))) {
        for (int column = 0; column < 4; ++column) {
            matrix[column][3] = affine[column];
        }
    }
    return matrix;
}

/// A node for messages: its number, and its name if it has one.
std::string labelOf(const json& root, int node) {
    const std::string name = nameOf(itemAt(root, "nodes", node, "node"));
    return name.empty() ? fmt::format("node {}", node) : fmt::format("node {} '{}'", node, name);
}

/// Refuses children that do not exist or that two nodes share.
std::vector<int> findParents(const json& root, const std::vector<NodeSource>& nodes) {
    std::vector<int> parents(nodes.size(), kNoParent);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const int child : nodes[i].children) {
            itemAt(nodes, child, "node");
            int& parent = parents[static_cast<std::size_t>(child)];
            if (parent != kNoParent) {
                refuse("{} is a child of both {} and {}, and a node has one parent", labelOf(root, child),
                       labelOf(root, parent), labelOf(root, static_cast<int>(i)));
            }
            parent = static_cast<int>(i);
        }
    }
    return parents;
}

/// Marks the roots of the scene that is shown.
void markScene(const json& root, const std::vector<int>& parents, std::optional<std::uint32_t> scene,
               std::vector<Placement>& placements) {
    const std::size_t scenes = arrayMember(root, "scenes").size();
    if (scene && *scene >= scenes) {
        refuse("scene {} does not exist, the file has {}", *scene, scenes);
    }
    const std::optional<int> shown = scene ? static_cast<int>(*scene) : indexMember(root, "scene");
    if (scenes == 0 && !shown) {
        for (Placement& placement : placements) {
            placement.inScene = true;
        }
        return;
    }
    for (const int node : indicesMember(itemAt(root, "scenes", shown.value_or(0), "scene"), "nodes")) {
        itemAt(placements, node, "node");
        const auto i = static_cast<std::size_t>(node);
        if (parents[i] != kNoParent || placements[i].inScene) {
            refuse("scene: its node {} is {}", node,
                   parents[i] == kNoParent ? "listed twice" : "a child of another node");
        }
        placements[i].inScene = true;
    }
}

/// Walks down from every root. In a graph where a node has one parent at most, what is not reached is on a
/// cycle.
void place(const json& root, const std::vector<NodeSource>& nodes, const std::vector<int>& parents,
           const GltfLimits& limits, Notes& notes, std::vector<Placement>& placements,
           std::vector<std::size_t>& order) {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (parents[i] == kNoParent) {
            open.push_back(i);
        }
    }
    while (!open.empty()) {
        const std::size_t i = open.back();
        open.pop_back();
        order.push_back(i);
        Placement& placement = placements[i];
        placement.reached = true;
        if (parents[i] != kNoParent) {
            const Placement& parent = placements[static_cast<std::size_t>(parents[i])];
            placement.toWorld = parent.toWorld;
            placement.depth = parent.depth + 1;
            placement.inScene = parent.inScene;
            placement.hidden = parent.hidden;
            placement.layer = parent.layer;
        }
        if (placement.depth >= limits.maxNodeDepth) {
            refuse("node {} is nested over the limit of {} deep", i, limits.maxNodeDepth);
        }
        const json& node = arrayMember(root, "nodes")[i];
        const NodeTransform transform = readTransform(node);
        placement.toWorld =
            placement.toWorld * (transform.matrix ? *transform.matrix : matrixOf(transform.local));
        requireUsable(placement.toWorld, node, i);
        placement.hidden = placement.hidden || isHidden(node, fmt::format("node {}", i));
        if (const auto layer = layerOf(node, fmt::format("node {}", i), notes)) {
            placement.layer = layer;
        }
        for (const int child : nodes[i].children) {
            open.push_back(static_cast<std::size_t>(child));
        }
    }
}

} // namespace

NodeTransform readTransform(const json& node) {
    const std::string where = fmt::format("node '{}'", nameOf(node));
    NodeTransform transform;
    if (const auto numbers = numbersMember(node, "matrix", 16, where)) {
        transform.matrix.emplace(1.0);
        for (int i = 0; i < 16; ++i) {
            (*transform.matrix)[i / 4][i % 4] = (*numbers)[static_cast<std::size_t>(i)];
        }
        transform.matrix = withoutRoundings(*transform.matrix);
        return transform;
    }
    LocalTransform& local = transform.local;
    if (const auto turn = numbersMember(node, "rotation", 4, where)) {
        // glTF stores x, y, z, w; glm takes w first, and would take no rotation for the identity.
        local.rotation = glm::dquat((*turn)[3], (*turn)[0], (*turn)[1], (*turn)[2]);
        const double length = glm::length(local.rotation);
        if (!(length > 0.0) || !std::isfinite(length)) {
            refuse("{}: its rotation has no direction", where);
        }
        local.rotation /= length;
    }
    if (const auto scale = numbersMember(node, "scale", 3, where)) {
        local.scale = {(*scale)[0], (*scale)[1], (*scale)[2]};
    }
    if (const auto translation = numbersMember(node, "translation", 3, where)) {
        local.translation = {(*translation)[0], (*translation)[1], (*translation)[2]};
    }
    return transform;
}

PlacedNodes placeNodes(const json& root, const GltfLimits& limits, std::optional<std::uint32_t> scene,
                       Notes& notes) {
    const std::vector<NodeSource> sources = readNodes(root);
    const std::vector<int> parents = findParents(root, sources);
    std::vector<Placement> placements(sources.size());
    markScene(root, parents, scene, placements);
    PlacedNodes nodes;
    nodes.order.reserve(sources.size());
    place(root, sources, parents, limits, notes, placements, nodes.order);
    nodes.all.reserve(sources.size());
    for (std::size_t i = 0; i < placements.size(); ++i) {
        if (!placements[i].reached) {
            refuse("node {} is its own ancestor", i);
        }
        nodes.all.push_back({.parent = parents[i] == kNoParent
                                           ? std::nullopt
                                           : std::optional(static_cast<std::size_t>(parents[i])),
                             .toWorld = placements[i].toWorld,
                             .inScene = placements[i].inScene});
        const bool isShown = placements[i].inScene && !placements[i].hidden;
        if (isShown && sources[i].mesh >= 0) {
            nodes.meshes.push_back({static_cast<int>(i), sources[i].mesh, placements[i].toWorld,
                                    placements[i].layer, sources[i].skin});
        }
        if (placements[i].inScene && sources[i].camera >= 0) {
            nodes.cameras.push_back({static_cast<int>(i), sources[i].camera, placements[i].toWorld});
        }
        if (isShown && sources[i].light >= 0) {
            nodes.lights.push_back({static_cast<int>(i), sources[i].light, placements[i].toWorld});
        }
    }
    return nodes;
}

} // namespace cdr::scene::gltf
