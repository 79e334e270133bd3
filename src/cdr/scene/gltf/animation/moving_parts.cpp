#include "moving_parts.h"

#include "animations.h"
#include "skins.h"

#include <cdr/platform/worker_pool.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

/// Nodes that a rig needs: those that move, and those whose skins or weights deform what they draw.
std::vector<bool> wantedNodes(const json& root, const PlacedNodes& nodes, std::vector<bool> wanted) {
    std::set<int> skins; // a file may have many nodes of one skin, which may have many joints
    for (const MeshNode& node : nodes.meshes) {
        const auto i = static_cast<std::size_t>(node.node);
        wanted[i] = wanted[i] || node.skin.has_value() || targetCount(root, node.mesh) > 0;
        if (node.skin && skins.insert(*node.skin).second) {
            for (const int joint : jointNodes(root, *node.skin)) {
                wanted[static_cast<std::size_t>(joint)] = true;
            }
        }
    }
    return wanted;
}

bool isMorphedAtRest(const FileRig& rig, std::size_t node) {
    if (!rig.nodeOf[node]) {
        return false;
    }
    const RigNode& placed = rig.rig.nodes[*rig.nodeOf[node]];
    const auto first = rig.rig.weights.begin() + static_cast<std::ptrdiff_t>(placed.firstWeight);
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(placed.weightCount),
                       [](double weight) { return weight != 0.0; });
}

} // namespace

MovingParts::MovingParts(const json& root, const PlacedNodes& nodes, Accessors& accessors,
                         MemoryPrediction& memory, Notes& notes)
    : m_accessors(accessors),
      m_notes(notes),
      m_animated(animatedNodes(root)),
      m_morphed(morphedNodes(root)),
      m_rig(makeRig(root, nodes, wantedNodes(root, nodes, m_animated), memory)) {
    m_made->rig = m_rig.rig;
    m_made->animations = readAnimations(root, accessors, m_rig, memory, notes);
    for (const MeshNode& node : nodes.meshes) {
        if (node.skin && m_skins.try_emplace(*node.skin, m_made->skins.size()).second) {
            m_made->skins.push_back(readSkin(root, *node.skin, accessors, m_rig, memory));
        }
    }
    // Once for each node: it may have millions of copies.
    for (std::size_t i = 0; i < m_morphed.size(); ++i) {
        m_morphed[i] = m_morphed[i] || isMorphedAtRest(m_rig, i);
    }
    for (const std::size_t i : nodes.order) {
        const auto parent = nodes.all[i].parent;
        m_animated[i] = m_animated[i] || (parent && m_animated[*parent]);
    }
}

std::optional<std::size_t> MovingParts::skinOf(const MeshNode& node, const Primitive& primitive) const {
    return node.skin && primitive.jointSets > 0 ? std::optional(m_skins.at(*node.skin)) : std::nullopt;
}

bool MovingParts::deforms(const MeshNode& node, const Primitive& primitive) const {
    return skinOf(node, primitive) ||
           (m_morphed[static_cast<std::size_t>(node.node)] && !primitive.targets.empty());
}

PrimitiveBytes MovingParts::predict(const MeshNode& node, const Primitive& primitive) const {
    const auto skin = skinOf(node, primitive);
    const std::uint64_t joints = skin ? m_made->skins[*skin].joints.size() : 0;
    const std::size_t rigNode = m_rig.nodeOf[static_cast<std::size_t>(node.node)].value();
    PrimitiveBytes bytes = predictDeformer(primitive, m_accessors);
    // All meshes are posed at once, each with joints and weights of its own.
    bytes.kept +=
        joints * sizeof(glm::dmat4) + std::uint64_t{m_rig.rig.nodes[rigNode].weightCount} * sizeof(double);
    return bytes;
}

void MovingParts::carry(const MeshNode& node, std::uint32_t instance, const glm::dvec3& origin) {
    if (moves(node)) {
        const std::size_t rigNode = m_rig.nodeOf[static_cast<std::size_t>(node.node)].value();
        m_made->carried.push_back(
            {.instance = instance, .node = rigNode, .origin = origin, .toNode = node.toNode});
    }
}

std::size_t MovingParts::addDeformed(Scene& scene, const MeshNode& node, const Primitive& primitive,
                                     SourcePrimitive source, const std::string& where) {
    const auto skin = skinOf(node, primitive);
    const std::size_t joints = skin ? m_made->skins[*skin].joints.size() : 0;
    Deformer deformer = makeDeformer(primitive, source, m_accessors, joints, m_notes, where);
    const std::size_t rigNode = m_rig.nodeOf[static_cast<std::size_t>(node.node)].value();
    if (skin && !m_made->deformed.empty() && m_made->deformed.back().node == rigNode) {
        // Parts of one object go with one point, so that its motion is one.
        deformer.centre = m_made->deformed.back().deformer.centre;
        deformer.anchor = m_made->deformed.back().deformer.anchor;
    }
    m_made->deformed.push_back({.copies = {},
                                .mesh = static_cast<std::uint32_t>(scene.meshes.size()),
                                .node = rigNode,
                                .skin = skin,
                                .deformer = std::move(deformer)});
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.name = std::move(source.mesh.name);
    mesh.vertices = std::move(source.mesh.vertices);
    mesh.details = std::move(source.mesh.details);
    mesh.indices = std::move(source.mesh.indices);
    return m_made->deformed.size() - 1;
}

void MovingParts::place(Scene& scene, std::size_t deformed, const MeshNode& node, std::uint32_t material,
                        std::uint32_t object) {
    DeformedMesh& mesh = m_made->deformed[deformed];
    mesh.copies.push_back(
        {.instance = static_cast<std::uint32_t>(scene.instances.size()), .toNode = node.toNode});
    addInstance(scene, mesh.mesh, material, object, glm::dvec3(0.0), glm::mat3(1.0f));
}

std::shared_ptr<const SceneAnimation> MovingParts::finish(Scene& scene) {
    if (m_made->animations.empty() && m_made->deformed.empty()) {
        return nullptr;
    }
    platform::WorkerPool workers(1);
    show(scene, motionOf(m_made, std::nullopt, {}), 0, workers);
    return m_made;
}

} // namespace cdr::scene::gltf
