#pragma once

#include "stream.h"

#include <memory>
#include <string>

namespace draco {
class Mesh;
}

namespace cdr::scene::gltf {

/// Decodes a mesh by libdraco. Its decoder takes memory by counts that lie all over the stream and has no limit of its own. So
/// each of them is looked at just before the decoder reads it. Refuses damaged streams.
std::unique_ptr<draco::Mesh> decodeGuarded(const DracoStream& stream, const DracoBounds& bounds,
                                           const std::string& where);

} // namespace cdr::scene::gltf
