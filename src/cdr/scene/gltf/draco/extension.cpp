#include "extension.h"

#include "../checks.h"
#include "../component.h"
#include "../json.h"
#include "decoder.h"

#include <draco/mesh/mesh.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

bool isRequired(const json& root) {
    const json& required = arrayMember(root, "extensionsRequired");
    return std::ranges::any_of(required,
                               [](const json& name) { return name.get_ref<const std::string&>() == kDraco; });
}

/// Whether bytes of the file back an accessor. What is no accessor is refused where it is used.
bool hasView(const json& accessors, int index) {
    const auto i = static_cast<std::size_t>(index);
    return i >= accessors.size() || member(accessors[i], "bufferView") != nullptr;
}

int componentTypeOf(draco::DataType type) {
    switch (type) {
    case draco::DT_INT8:
        return kByte;
    case draco::DT_UINT8:
        return kUnsignedByte;
    case draco::DT_INT16:
        return kShort;
    case draco::DT_UINT16:
        return kUnsignedShort;
    case draco::DT_UINT32:
        return kUnsignedInt;
    case draco::DT_FLOAT32:
        return kFloat;
    default:
        return 0;
    }
}

DracoAttribute valuesOf(const draco::PointAttribute& attribute, std::uint32_t vertices,
                        const std::string& where) {
    DracoAttribute result{.componentType = componentTypeOf(attribute.data_type()),
                          .components = attribute.num_components()};
    const auto stride = static_cast<std::size_t>(attribute.byte_stride());
    result.bytes.resize(vertices * stride);
    for (std::uint32_t i = 0; i < vertices; ++i) {
        const draco::PointIndex point(i);
        // In a damaged stream a vertex may have no value.
        if ((!attribute.is_mapping_identity() && i >= attribute.indices_map_size()) ||
            attribute.mapped_index(point).value() >= attribute.size()) {
            refuse("{}: what {} holds is damaged: vertex {} has no value", where, kDraco, i);
        }
        attribute.GetMappedValue(point, result.bytes.data() + i * stride);
    }
    return result;
}

} // namespace

std::optional<DracoPrimitive> dracoOf(const json& root, const json& primitive, const std::string& where) {
    const json* extension = extensionOf(primitive, kDraco);
    if (extension == nullptr) {
        return {};
    }
    const json& accessors = arrayMember(root, "accessors");
    const std::optional<int> indices = indexMember(primitive, "indices");
    bool isNeeded = isRequired(root) || (indices && !hasView(accessors, *indices));
    for (const auto& [name, accessor] : indicesByName(objectMember(primitive, "attributes", where))) {
        isNeeded = isNeeded || !hasView(accessors, accessor);
    }
    if (!isNeeded) {
        return {};
    }
    return DracoPrimitive{.bufferView = requiredIndex(*extension, "bufferView", where),
                          .ids = indicesByName(objectMember(*extension, "attributes", where))};
}

DracoMesh decodeDraco(std::span<const std::uint8_t> compressed, const DracoPrimitive& primitive,
                      const DracoBounds& bounds, const std::string& where) {
    const DracoStream stream = openDraco(compressed, bounds, where);
    const std::unique_ptr<draco::Mesh> mesh = decodeGuarded(stream, bounds, where);
    DracoMesh result;
    result.indices.reserve(3ull * mesh->num_faces());
    for (std::uint32_t i = 0; i < mesh->num_faces(); ++i) {
        for (const draco::PointIndex& point : mesh->face(draco::FaceIndex(i))) {
            result.indices.push_back(point.value());
        }
    }
    for (const auto& [name, id] : primitive.ids) {
        const draco::PointAttribute* attribute = mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
        if (attribute != nullptr && !result.attributes.contains(id)) { // many names may have one
            result.attributes.emplace(id, valuesOf(*attribute, mesh->num_points(), where));
        }
    }
    return result;
}

} // namespace cdr::scene::gltf
