#include "rig.h"

#include "../checks.h"
#include "../json.h"

#include <nlohmann/json.hpp>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

RigNode rigNodeOf(const json& node, const PlacedNodes& nodes, std::size_t index, const FileRig& made) {
    const NodeTransform transform = readTransform(node);
    RigNode result{.local = transform.local, .matrix = transform.matrix};
    if (const auto parent = nodes.all[index].parent) {
        result.parent = made.nodeOf[*parent];
        if (!result.parent) {
            result.parentToWorld = nodes.all[*parent].toWorld;
        }
    }
    return result;
}

} // namespace

std::size_t targetCount(const json& root, int mesh) {
    const json& primitives = arrayMember(itemAt(root, "meshes", mesh, "mesh"), "primitives");
    return primitives.empty() ? 0 : arrayMember(primitives.front(), "targets").size();
}

std::vector<double> restWeights(const json& root, const json& node) {
    const auto mesh = indexMember(node, "mesh");
    if (!mesh) {
        return {};
    }
    const std::size_t targets = targetCount(root, *mesh);
    const std::string where = fmt::format("node '{}'", nameOf(node));
    std::vector<double> weights = numbersOf(node, "weights", where);
    if (weights.empty()) {
        weights = numbersOf(itemAt(root, "meshes", *mesh, "mesh"), "weights", where);
    }
    if (!weights.empty() && weights.size() != targets) {
        refuse("{}: {} weights for {} morph targets", where, weights.size(), targets);
    }
    weights.resize(targets);
    return weights;
}

FileRig makeRig(const json& root, const PlacedNodes& nodes, const std::vector<bool>& wanted,
                MemoryPrediction& memory) {
    FileRig made;
    made.nodeOf.resize(nodes.all.size());
    for (const std::size_t i : nodes.order) {
        const auto parent = nodes.all[i].parent;
        if (!wanted[i] && !(parent && made.nodeOf[*parent])) {
            continue;
        }
        const json& node = itemAt(root, "nodes", static_cast<int>(i), "node");
        const auto mesh = indexMember(node, "mesh");
        const std::size_t targets = mesh ? targetCount(root, *mesh) : 0;
        memory.add({.kept = sizeof(RigNode) + targets * sizeof(double)}, "the nodes that move");
        RigNode added = rigNodeOf(node, nodes, i, made);
        const std::vector<double> weights = restWeights(root, node);
        added.firstWeight = made.rig.weights.size();
        added.weightCount = weights.size();
        made.rig.weights.insert(made.rig.weights.end(), weights.begin(), weights.end());
        made.nodeOf[i] = made.rig.nodes.size();
        made.rig.nodes.push_back(added);
    }
    return made;
}

} // namespace cdr::scene::gltf
