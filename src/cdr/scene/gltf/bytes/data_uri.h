#pragma once

#include <cdr/platform/file.h>

#include <string_view>

namespace cdr::scene::gltf {

/// Whether it is a `data:` URI. Schemes have letters of either case.
bool isDataUri(std::string_view uri);

/// The bytes of a `data:` URI in base64. Refuses one that is malformed, empty, or of a media type that glTF does not use.
platform::Bytes decodeDataUri(std::string_view uri);

} // namespace cdr::scene::gltf
