#include "primitive.h"

#include "checks.h"
#include "json.h"

#include <nlohmann/json.hpp>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

std::size_t countJointSets(const std::map<std::string, int>& attributes) {
    std::size_t sets = 0;
    while (attributes.contains(fmt::format("JOINTS_{}", sets)) &&
           attributes.contains(fmt::format("WEIGHTS_{}", sets))) {
        ++sets;
    }
    return sets;
}

Primitive readPrimitive(const json& root, const json& source, const std::string& where) {
    Primitive primitive;
    primitive.draco = dracoOf(root, source, where);
    primitive.mode = indexMember(source, "mode").value_or(kModeTriangles);
    primitive.indices = indexMember(source, "indices").value_or(-1);
    primitive.material = indexMember(source, "material").value_or(-1);
    for (const json& target : arrayMember(source, "targets")) {
        if (!target.is_object()) {
            refuse("{}: a morph target is no object", where);
        }
        primitive.targets.push_back(indicesByName(target));
    }
    if (member(source, "attributes") == nullptr) {
        refuse("{}: has no 'attributes'", where);
    }
    primitive.attributes = indicesByName(objectMember(source, "attributes", where));
    primitive.jointSets = countJointSets(primitive.attributes); // once: there may be millions of copies
    primitive.hasExtensions = !objectMember(source, "extensions", where).empty();
    return primitive;
}

} // namespace

MeshSource readMesh(const json& root, int mesh) {
    const json& source = itemAt(root, "meshes", mesh, "mesh");
    MeshSource result{.name = std::string(fullNameOf(source)), .primitives = {}};
    for (const json& primitive : arrayMember(source, "primitives")) {
        result.primitives.push_back(
            readPrimitive(root, primitive, placeOf(mesh, result.name, result.primitives.size())));
    }
    return result;
}

std::string placeOf(int mesh, const std::string& name, std::size_t primitive) {
    return fmt::format("mesh {} '{}' primitive {}", mesh, oneLine(name, kMaxNameLength), primitive);
}

} // namespace cdr::scene::gltf
