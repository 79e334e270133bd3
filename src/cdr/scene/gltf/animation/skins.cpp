#include "skins.h"

#include "../checks.h"
#include "../json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr int kMatrixComponents = 16;

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

Skin readSkin(const json& root, int skin, Accessors& accessors, const FileRig& rig) {
    const json& source = itemAt(root, "skins", skin, "skin");
    const std::string where = fmt::format("skin {} '{}'", skin, nameOf(source));
    Skin result;
    for (const int joint : jointNodes(root, skin)) {
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
