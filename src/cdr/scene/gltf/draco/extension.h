#pragma once

#include "stream.h"

#include <cdr/platform/file.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cdr::scene::gltf {

/// What KHR_draco_mesh_compression says of a primitive.
struct DracoPrimitive {
    int bufferView = 0;
    std::map<std::string, int> ids; ///< by attribute: its unique id in the stream
};

/// The compressed form of a primitive, if it has to be decoded. That is so if the file requires the extension, or if a part
/// of the primitive is in no uncompressed form. Refuses one that is unsound.
/// @param root of the document.
std::optional<DracoPrimitive> dracoOf(const nlohmann::json& root, const nlohmann::json& primitive,
                                      const std::string& where);

/// The values of an attribute, vertex by vertex.
struct DracoAttribute {
    int componentType = 0; ///< glTF's number; 0: glTF has no such type
    int components = 0;
    platform::Bytes bytes{};
};

/// A decoded mesh.
struct DracoMesh {
    std::vector<std::uint32_t> indices;       ///< three for each triangle; a damaged stream may name any
    std::map<int, DracoAttribute> attributes; ///< by unique id, those that were asked for and are there
};

/// Refuses a stream that is not sound or goes over the bounds.
DracoMesh decodeDraco(std::span<const std::uint8_t> compressed, const DracoPrimitive& primitive,
                      const DracoBounds& bounds, const std::string& where);

} // namespace cdr::scene::gltf
