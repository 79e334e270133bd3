#include "deformers.h"

#include "../bytes/reading_order.h"
#include "../checks.h"
#include "../draco/decompressor.h"
#include "../json.h"
#include "morphed_tangents.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace cdr::scene::gltf {

namespace {

constexpr std::size_t kJointsPerSet = 4;

/// Of a vertex, while targets get the deltas of tangents: two sums, the mesh in full, deltas as they grow, and tables.
constexpr std::uint64_t kDeltaBytes = 256;

/// An accessor of one element for each vertex of the file.
const Accessor& requireVertices(const Accessor& accessor, const std::string& name, int components,
                                std::size_t count, const std::string& where) {
    if (accessor.components() != components || accessor.count() != count) {
        refuse("{}: {} has {} elements of {} components where {} of {} are needed", where, name,
               accessor.count(), accessor.components(), count, components);
    }
    return accessor;
}

struct JointSet {
    const Accessor* joints;
    const Accessor* weights;
};

/// The joints of a vertex, their weights made to add up to one.
std::vector<Influence> influencesOf(const std::vector<JointSet>& sets, std::uint32_t vertex,
                                    std::size_t joints, Notes& notes, const std::string& where) {
    std::vector<Influence> influences;
    double sum = 0.0;
    for (const JointSet& set : sets) {
        const glm::vec4 joint = set.joints->vector(vertex);
        const glm::vec4 weight = set.weights->vector(vertex);
        for (int c = 0; c < 4; ++c) {
            if (!(weight[c] >= 0.0f) || !std::isfinite(weight[c])) {
                refuse("{}: a weight of vertex {} is negative or not finite", where, vertex);
            }
            if (weight[c] > 0.0f) {
                if (!(joint[c] >= 0.0f && static_cast<double>(joint[c]) < static_cast<double>(joints))) {
                    refuse("{}: vertex {} follows joint {}, and the skin has {}", where, vertex, joint[c],
                           joints);
                }
                influences.push_back({static_cast<std::uint32_t>(joint[c]), weight[c]});
                sum += static_cast<double>(weight[c]);
            }
        }
    }
    if (influences.empty()) {
        notes.add("a vertex follows no joint, so the first joint of its skin is used", where);
        return {{0, 1.0f}};
    }
    for (Influence& influence : influences) {
        influence.weight = static_cast<float>(static_cast<double>(influence.weight) / sum);
    }
    return influences;
}

std::vector<MorphDelta> deltasOf(const std::map<std::string, int>& target, const Primitive& primitive,
                                 const SourcePrimitive& source, Accessors& accessors,
                                 const std::string& where) {
    const auto find = [&](const char* name) -> const Accessor* {
        const auto found = target.find(name);
        return found == target.end()
                   ? nullptr
                   : &requireVertices(accessors.at(found->second), name, 3, source.fileVertexCount, where);
    };
    const Accessor* position = find("POSITION");
    const Accessor* normal = find("NORMAL");
    const bool hasTangents = primitive.attributes.contains("TANGENT") && !source.mesh.details.empty() &&
                             source.derived == UvPlaces::Tangents::none;
    const Accessor* tangent = hasTangents ? find("TANGENT") : nullptr;
    std::vector<MorphDelta> deltas;
    const auto add = [&](std::uint32_t i) {
        const auto of = [&](const Accessor* accessor) {
            return accessor == nullptr ? glm::vec3(0.0f)
                                       : glm::vec3(accessor->vector(source.fileVertices[i]));
        };
        const MorphDelta delta{i, of(position), of(normal), of(tangent)};
        const glm::vec3 sum = delta.position + delta.normal + delta.tangent;
        if (!std::isfinite(sum.x) || !std::isfinite(sum.y) || !std::isfinite(sum.z)) {
            refuse("{}: a morph target moves vertex {} by more than a float32 holds", where, i);
        }
        if (delta.position != glm::vec3(0.0f) || delta.normal != glm::vec3(0.0f) ||
            delta.tangent != glm::vec3(0.0f)) {
            deltas.push_back(delta);
        }
    };
    const std::vector<std::uint32_t> order =
        readingOrder(source.fileVertices, bytesApartInFile({position, normal, tangent}));
    forEachInOrder(order, source.fileVertices.size(), add);
    if (!order.empty()) {
        std::ranges::sort(deltas, {}, &MorphDelta::vertex);
    }
    return deltas;
}

/// By vertex of the mesh; `order` as readingOrder() has it.
void addInOrder(Deformer& deformer, std::span<const std::uint32_t> order,
                const std::vector<std::size_t>& firstRead, const std::vector<Influence>& read) {
    std::vector<std::size_t> placeInOrder(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        placeInOrder[order[k]] = k;
    }
    for (const std::size_t k : placeInOrder) {
        const auto at = [&](std::size_t i) {
            return read.begin() + static_cast<std::ptrdiff_t>(firstRead[i]);
        };
        deformer.firstInfluence.push_back(deformer.influences.size());
        deformer.influences.insert(deformer.influences.end(), at(k), at(k + 1));
    }
    deformer.firstInfluence.push_back(deformer.influences.size());
}

void addInfluences(const Primitive& primitive, const SourcePrimitive& source, Accessors& accessors,
                   std::size_t joints, Notes& notes, const std::string& where, Deformer& deformer) {
    std::vector<JointSet> sets;
    std::size_t bytesApart = 0;
    for (std::size_t set = 0; set < primitive.jointSets; ++set) {
        const auto attribute = [&](const char* kind) {
            const std::string name = fmt::format("{}_{}", kind, set);
            return &requireVertices(*attributeOf(primitive, name, accessors), name, 4, source.fileVertexCount,
                                    where);
        };
        sets.push_back({attribute("JOINTS"), attribute("WEIGHTS")});
        bytesApart += bytesApartInFile({sets.back().joints, sets.back().weights});
    }
    std::vector<std::size_t> first;
    std::vector<Influence> influences;
    first.reserve(source.fileVertices.size() + 1);
    const std::vector<std::uint32_t> order = readingOrder(source.fileVertices, bytesApart);
    forEachInOrder(order, source.fileVertices.size(), [&](std::uint32_t i) {
        first.push_back(influences.size());
        const std::vector<Influence> added = influencesOf(sets, source.fileVertices[i], joints, notes, where);
        influences.insert(influences.end(), added.begin(), added.end());
    });
    first.push_back(influences.size());
    if (order.empty()) {
        deformer.firstInfluence = std::move(first);
        deformer.influences = std::move(influences);
    } else {
        addInOrder(deformer, order, first, influences);
    }
}

} // namespace

void requireTargets(const nlohmann::json& root, const Primitive& primitive, Accessors& accessors,
                    const std::string& where) {
    const auto positions = primitive.attributes.find("POSITION");
    if (primitive.targets.empty() || positions == primitive.attributes.end()) {
        return;
    }
    const std::size_t vertices = accessors.at(positions->second).count();
    for (const auto& target : primitive.targets) {
        for (const auto& [name, index] : target) {
            const nlohmann::json& accessor = itemAt(root, "accessors", index, "accessor");
            const int count = requiredIndex(accessor, "count", fmt::format("accessor {}", index));
            if (static_cast<std::size_t>(count) != vertices) {
                refuse("{}: {} of a morph target has {} elements, and the mesh has {} vertices", where,
                       oneLine(name, kMaxNameLength), count, vertices);
            }
        }
    }
}

PrimitiveBytes predictDeformer(const Primitive& primitive, Accessors& accessors) {
    const PrimitiveBytes mesh = predictBytes(primitive, accessors, VertexKind::detailed);
    // Its vertices at rest and at a moment; all that its file says of each.
    const std::uint64_t vertices = mesh.kept / sizeof(Vertex) + 1;
    return {.kept = 2 * mesh.kept + vertices * (sizeof(std::size_t) +
                                                primitive.jointSets * kJointsPerSet * sizeof(Influence) +
                                                primitive.targets.size() * sizeof(MorphDelta)),
            .passing = std::max(mesh.passing, primitive.targets.empty() ? 0 : vertices * kDeltaBytes)};
}

Deformer makeDeformer(const Primitive& primitive, const SourcePrimitive& source, Accessors& accessors,
                      std::size_t joints, Notes& notes, const std::string& where) {
    Deformer deformer;
    deformer.vertices = source.mesh.vertices;
    deformer.details = source.mesh.details;
    deformer.isFlat = groundOf(primitive) == Ground::surface && !primitive.attributes.contains("NORMAL");
    for (const auto& target : primitive.targets) {
        for (const auto& [name, accessor] : target) {
            if (name != "POSITION" && name != "NORMAL" && name != "TANGENT") {
                notes.add("morph targets change positions, normals and tangents alone", where);
            }
        }
        deformer.targets.push_back(deltasOf(target, primitive, source, accessors, where));
    }
    if (source.derived != UvPlaces::Tangents::none && !deformer.targets.empty()) {
        deformer.derivedTangents = true;
        addTangentDeltas(deformer, source.mesh.indices, source.derived);
    }
    if (joints > 0) {
        addInfluences(primitive, source, accessors, joints, notes, where, deformer);
    }
    finish(deformer);
    return deformer;
}

} // namespace cdr::scene::gltf
