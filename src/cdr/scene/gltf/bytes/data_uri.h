#pragma once

#include <cdr/platform/file.h>

#include <optional>
#include <string_view>

namespace cdr::scene::gltf {

/// The bytes of a base64 `data:` URI; nothing when it is malformed, empty, or of a media type that glTF does
/// not use.
std::optional<platform::Bytes> decodeDataUri(std::string_view uri);

} // namespace cdr::scene::gltf
