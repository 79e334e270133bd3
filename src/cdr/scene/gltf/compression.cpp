#include "compression.h"

#include "checks.h"
#include "json.h"

#include <nlohmann/json.hpp>

#include <cstdint>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr const char* kDraco = "KHR_draco_mesh_compression";

bool hasDraco(const json& primitive) {
    const json* extensions = member(primitive, "extensions");
    return extensions != nullptr && member(*extensions, kDraco) != nullptr;
}

/// Refuses an accessor that no buffer view backs; sparse elements over others that are compressed are no way
/// out. What is no accessor is refused where it is used.
void requireView(const json& accessors, const json& index, const std::string& where) {
    if (index.is_number_unsigned() && index.get<std::size_t>() < accessors.size() &&
        member(accessors[index.get<std::size_t>()], "bufferView") == nullptr) {
        refuse("{}: accessor {} is there only as {}, which is not supported", where, index.get<std::size_t>(),
               kDraco);
    }
}

void requireViews(const json& accessors, const json& primitive, const std::string& where) {
    if (const json* indices = member(primitive, "indices")) {
        requireView(accessors, *indices, where);
    }
    if (const json* attributes = member(primitive, "attributes")) {
        for (const json& attribute : *attributes) {
            requireView(accessors, attribute, where);
        }
    }
}

/// Whether a view lies over its own compressed bytes: a writer that had no others named the buffer it had.
bool isOverCompressed(const tinygltf::BufferView& view, const tinygltf::Value& compressed) {
    const auto number = [&](const char* key, int fallback) {
        const bool isNumber = compressed.Has(key) && compressed.Get(key).IsInt();
        return std::int64_t{isNumber ? compressed.Get(key).Get<int>() : fallback};
    };
    const std::int64_t begin = number("byteOffset", 0);
    const auto viewBegin = static_cast<std::int64_t>(view.byteOffset);
    return number("buffer", -1) == view.buffer && viewBegin < begin + number("byteLength", 0) &&
           begin < viewBegin + static_cast<std::int64_t>(view.byteLength);
}

} // namespace

void requireUncompressed(const json& root) {
    const json& accessors = arrayMember(root, "accessors");
    std::size_t mesh = 0;
    for (const json& source : arrayMember(root, "meshes")) {
        std::size_t number = 0;
        for (const json& primitive : arrayMember(source, "primitives")) {
            if (hasDraco(primitive)) {
                requireViews(accessors, primitive,
                             fmt::format("mesh {} '{}' primitive {}", mesh, nameOf(source), number));
            }
            ++number;
        }
        ++mesh;
    }
}

void requireUncompressed(const tinygltf::BufferView& view, int bufferView, bool hasBuffer) {
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        const auto found = view.extensions.find(name);
        if (found != view.extensions.end() && (!hasBuffer || isOverCompressed(view, found->second))) {
            refuse("buffer view {} is there only as {}, which is not supported", bufferView, name);
        }
    }
}

} // namespace cdr::scene::gltf
