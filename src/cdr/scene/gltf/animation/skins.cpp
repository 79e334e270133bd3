#include "skins.h"

#include "../checks.h"
#include "../json.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr int kMatrixComponents = 16;
/// What a joint takes in a skin: its place in the rig, and a matrix.
constexpr std::uint64_t kJointBytes = sizeof(std::size_t) + sizeof(glm::dmat4);

/// Of a point, so the last row counts for nothing.
glm::dmat4 affine(glm::dmat4 matrix, const std::string& where, std::size_t index) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row) {
            if (!std::isfinite(matrix[column][row])) {
                refuse("{}: its inverse bind matrix {} is not finite", where, index);
            }
        }
        matrix[column][3] = column == 3 ? 1.0 : 0.0;
    }
    return matrix;
}

} // namespace

std::vector<int> jointNodes(const json& root, int skin) {
    std::vector<int> joints = indicesMember(itemAt(root, "skins", skin, "skin"), "joints");
    if (joints.empty()) {
        refuse("skin {}: has no joints", skin);
    }
    for (const int joint : joints) {
        itemAt(root, "nodes", joint, "node");
    }
    return joints;
}

Skin readSkin(const json& root, int skin, Accessors& accessors, const FileRig& rig,
              MemoryPrediction& memory) {
    const json& source = itemAt(root, "skins", skin, "skin");
    const std::string where = fmt::format("skin {} '{}'", skin, nameOf(source));
    const std::vector<int> joints = jointNodes(root, skin);
    memory.add({.kept = joints.size() * kJointBytes}, where);
    Skin result;
    result.joints.reserve(joints.size());
    for (const int joint : joints) {
        result.joints.push_back(rig.nodeOf[static_cast<std::size_t>(joint)].value());
    }
    result.inverseBind.resize(result.joints.size(), glm::dmat4(1.0));
    if (const auto index = indexMember(source, "inverseBindMatrices")) {
        const Accessor& accessor = accessors.at(*index);
        if (accessor.components() != kMatrixComponents || accessor.count() < result.joints.size()) {
            refuse("{}: {} inverse bind matrices of {} components for {} joints", where, accessor.count(),
                   accessor.components(), result.joints.size());
        }
        for (std::size_t i = 0; i < result.joints.size(); ++i) {
            result.inverseBind[i] = affine(accessor.matrix(i), where, i);
        }
    }
    return result;
}

} // namespace cdr::scene::gltf
