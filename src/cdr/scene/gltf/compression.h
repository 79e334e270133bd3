#pragma once

#include <nlohmann/json_fwd.hpp>
#include <tiny_gltf.h>

namespace cdr::scene::gltf {

// Extensions that compress geometry are not supported. A file that uses one without requiring it has the same
// geometry uncompressed as well, which is what we read; what is missing there would read as zeros, or as
// bytes that mean something else.

/// Refuses a document with a primitive of which KHR_draco_mesh_compression holds what no buffer view does.
/// Before tinygltf sees it, which calls that unsound.
/// @param root its numbers sound, see requireSoundNumbers().
void requireUncompressed(const nlohmann::json& root);

/// Refuses a buffer view whose bytes EXT_ or KHR_meshopt_compression holds and nothing else.
/// @param hasBuffer whether there are bytes of the buffer that the view is in.
void requireUncompressed(const tinygltf::BufferView& view, int bufferView, bool hasBuffer);

} // namespace cdr::scene::gltf
