#include "part_names.h"

#include "checks.h"
#include "json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <map>

namespace cdr::scene::gltf {

namespace {

/// Its beginning; empty where a primitive has no material, or one without a name.
std::string materialNameOf(const nlohmann::json& root, const Primitive& primitive) {
    const nlohmann::json& materials = arrayMember(root, "materials");
    const bool exists =
        primitive.material >= 0 && static_cast<std::size_t>(primitive.material) < materials.size();
    return exists
               ? oneLine(fullNameOf(materials[static_cast<std::size_t>(primitive.material)]), kMaxNameLength)
               : std::string();
}

} // namespace

std::vector<std::string> partNames(const nlohmann::json& root, const MeshSource& mesh,
                                   const std::string& node) {
    if (mesh.primitives.size() < 2) {
        return {node};
    }
    std::map<std::string, std::size_t> uses;
    std::vector<std::string> names;
    for (const Primitive& primitive : mesh.primitives) {
        names.push_back(materialNameOf(root, primitive));
        ++uses[names.back()];
    }
    const std::string prefix = oneLine(node, kMaxNameLength);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string& material = names[i];
        names[i] = material.empty()      ? fmt::format("{} / part {}", prefix, i)
                   : uses[material] == 1 ? fmt::format("{} / {}", prefix, material)
                                         : fmt::format("{} / {} {}", prefix, material, i);
    }
    return names;
}

} // namespace cdr::scene::gltf
