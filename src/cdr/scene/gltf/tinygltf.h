#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace cdr::scene::gltf {

/// tinygltf's model of a JSON document that refers to no file. Refuses whatever tinygltf complains about.
tinygltf::Model parseModel(const std::string& json);

/// Decodes a base64 `data:` URI; nothing when it is malformed or of a media type that glTF does not use.
std::optional<std::vector<unsigned char>> decodeDataUri(const std::string& uri);

} // namespace cdr::scene::gltf
