#pragma once

#include "../accessor.h"
#include "../primitive.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cdr::scene::gltf {

/// What of a primitive was compressed. Its accessors are those of the file over the decoded bytes.
struct DecodedPrimitive {
    std::vector<std::uint32_t> indexList;
    std::map<int, DracoAttribute> values; ///< by id in the stream; attributes may share one
    std::optional<Accessor> indices;
    std::map<std::string, Accessor> attributes; ///< by name; others are not compressed
};

/// Decodes primitives that KHR_draco_mesh_compression holds.
class Decompressor {
  public:
    /// Both must outlive this.
    /// @param maxBytes of all compressed streams together: one that many primitives name takes its time for each
    Decompressor(const Buffers& buffers, Accessors& accessors, std::uint64_t maxBytes);

    /// Decodes a primitive that has to be and is not. Refuses one whose accessors are not what the stream holds.
    /// @param room bytes of memory that decoding may take
    /// @returns bytes that are kept
    std::uint64_t decode(Primitive& primitive, std::uint64_t room, const std::string& where);

    /// Frees what was decoded of a primitive that is imported. If it is needed again, it is decoded again.
    /// @returns bytes that were kept
    static std::uint64_t drop(Primitive& primitive);

  private:
    const Buffers& m_buffers;
    Accessors& m_accessors;
    std::uint64_t m_bytesLeft;
};

/// The accessor of an attribute, null where the primitive has none of this name. Of a primitive that is still to be decoded
/// it has its counts and no data.
const Accessor* attributeOf(const Primitive& primitive, const std::string& name, Accessors& accessors);
/// That of its indices.
const Accessor* indicesOf(const Primitive& primitive, Accessors& accessors);

} // namespace cdr::scene::gltf
