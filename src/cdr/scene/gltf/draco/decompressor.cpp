#include "decompressor.h"

#include "../checks.h"
#include "../component.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace cdr::scene::gltf {

namespace {

DracoBounds boundsOf(const Primitive& primitive, Accessors& accessors, std::uint64_t room,
                     const std::string& where) {
    if (primitive.mode != kModeTriangles) {
        refuse("{}: {} holds what is of mode {}, and only lists of triangles ({}) are read", where, kDraco,
               primitive.mode, kModeTriangles);
    }
    const Accessor* position = attributeOf(primitive, "POSITION", accessors);
    const Accessor* indices = indicesOf(primitive, accessors);
    if (position == nullptr || indices == nullptr) {
        refuse("{}: {} needs indices and positions", where, kDraco);
    }
    indices->requireIndices(primitive.indices);
    if (indices->count() % 3 != 0) {
        refuse("{}: its {} indices make no triangles", where, indices->count());
    }
    return {.triangles = indices->count() / 3, .vertices = position->count(), .bytes = room};
}

void requireNotSparse(const Accessor& accessor, int index, const std::string& where) {
    if (accessor.isSparse()) {
        refuse("{}: accessor {} is sparse, and {} holds the rest of it", where, index, kDraco);
    }
}

void addIndices(DecodedPrimitive& decoded, std::vector<std::uint32_t> list, const Primitive& primitive,
                Accessors& accessors, std::uint64_t vertices, const std::string& where) {
    const Accessor& declared = accessors.at(primitive.indices);
    requireNotSparse(declared, primitive.indices, where);
    const std::uint64_t most =
        std::min<std::uint64_t>(vertices, 1ull << (8 * componentBytes(declared.componentType())));
    for (const std::uint32_t index : list) {
        if (index >= most) {
            refuse("{}: {} holds index {}, over {} vertices or the component type of accessor {}", where,
                   kDraco, index, vertices, primitive.indices);
        }
    }
    decoded.indexList = std::move(list);
    // Little-endian numbers begin with what a shorter type has of them.
    decoded.indices.emplace(declared, Strided{reinterpret_cast<const std::uint8_t*>(decoded.indexList.data()),
                                              sizeof(std::uint32_t)});
}

void addAttribute(DecodedPrimitive& decoded, const std::string& name, int index, const Accessor& declared,
                  const DracoAttribute& found, std::uint64_t vertices, const std::string& where) {
    requireNotSparse(declared, index, where);
    if (declared.componentType() != found.componentType || declared.components() != found.components ||
        declared.count() != vertices) {
        refuse("{}: {} holds {} of {} elements of {} components of type {}, and accessor {} has {} of {} of "
               "type {}",
               where, kDraco, oneLine(name, kMaxNameLength), vertices, found.components, found.componentType,
               index, declared.count(), declared.components(), declared.componentType());
    }
    decoded.attributes.emplace(
        name, Accessor(declared, {found.bytes.data(), static_cast<std::size_t>(declared.components()) *
                                                          componentBytes(declared.componentType())}));
}

std::uint64_t bytesOf(const DecodedPrimitive& decoded) {
    std::uint64_t bytes = decoded.indexList.size() * sizeof(std::uint32_t);
    for (const auto& [id, values] : decoded.values) {
        bytes += values.bytes.size();
    }
    return bytes;
}

} // namespace

Decompressor::Decompressor(const Buffers& buffers, Accessors& accessors, std::uint64_t maxBytes)
    : m_buffers(buffers),
      m_accessors(accessors),
      m_bytesLeft(maxBytes) {}

std::uint64_t Decompressor::decode(Primitive& primitive, std::uint64_t room, const std::string& where) {
    if (!primitive.draco || primitive.decoded != nullptr) {
        return 0;
    }
    const DracoBounds bounds = boundsOf(primitive, m_accessors, room, where);
    const ByteSource compressed = m_buffers.view(primitive.draco->bufferView).bytes;
    if (compressed.size() > m_bytesLeft) {
        refuse("{}: with it, meshes of {} are over the limit of bytes", where, kDraco);
    }
    m_bytesLeft -= compressed.size();
    DracoMesh mesh = decodeDraco(compressed.read(), *primitive.draco, bounds, where);
    auto decoded = std::make_shared<DecodedPrimitive>();
    addIndices(*decoded, std::move(mesh.indices), primitive, m_accessors, bounds.vertices, where);
    decoded->values = std::move(mesh.attributes);
    for (const auto& [name, id] : primitive.draco->ids) {
        const auto named = primitive.attributes.find(name);
        if (named == primitive.attributes.end()) {
            continue; // nothing reads it
        }
        const auto found = decoded->values.find(id);
        if (found == decoded->values.end()) {
            refuse("{}: {} holds no attribute {}, which {} is", where, kDraco, id,
                   oneLine(name, kMaxNameLength));
        }
        addAttribute(*decoded, name, named->second, m_accessors.at(named->second), found->second,
                     bounds.vertices, where);
    }
    primitive.decoded = decoded;
    return bytesOf(*decoded);
}

std::uint64_t Decompressor::drop(Primitive& primitive) {
    const std::uint64_t bytes = primitive.decoded == nullptr ? 0 : bytesOf(*primitive.decoded);
    primitive.decoded = nullptr;
    return bytes;
}

const Accessor* attributeOf(const Primitive& primitive, const std::string& name, Accessors& accessors) {
    if (primitive.decoded != nullptr) {
        const auto found = primitive.decoded->attributes.find(name);
        if (found != primitive.decoded->attributes.end()) {
            return &found->second;
        }
    }
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? nullptr : &accessors.at(found->second);
}

const Accessor* indicesOf(const Primitive& primitive, Accessors& accessors) {
    if (primitive.decoded != nullptr) {
        return &*primitive.decoded->indices;
    }
    return primitive.indices < 0 ? nullptr : &accessors.at(primitive.indices);
}

} // namespace cdr::scene::gltf
