#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>

namespace cdr::scene::gltf {

// Of the extensions that compress buffer views EXT_meshopt_compression is supported (meshopt.h). A file that uses another one
// without requiring it has the same geometry uncompressed as well, which is what we read. What is missing there would read as
// zeros, or as bytes that mean something else.

/// Bytes of a buffer.
struct BufferRange {
    int buffer = 0;
    std::size_t offset = 0;
    std::size_t length = 0;
    bool hasBytes = true; ///< whether the file has bytes of the buffer
};

/// The EXT_meshopt_compression of a buffer view whose bytes it holds and nothing else; null for another view. Refuses one
/// of KHR_meshopt_compression.
/// @param range that the view covers.
const nlohmann::json* meshoptOf(const nlohmann::json& view, const BufferRange& range,
                                const std::string& where);

} // namespace cdr::scene::gltf
