#pragma once

#include <cdr/platform/file.h>

#include <cstdint>
#include <span>
#include <string>

namespace draco {
class DecoderBuffer;
}

namespace cdr::scene::gltf {

inline constexpr const char* kDraco = "KHR_draco_mesh_compression";

/// What must hold of a Draco mesh before memory is taken for it.
struct DracoBounds {
    std::uint64_t triangles = 0; ///< of the accessor of its indices
    std::uint64_t vertices = 0;  ///< of the accessors of its attributes
    std::uint64_t bytes = 0;     ///< that decoding may take
};

/// A compressed mesh whose connectivity the decoder may be given. Its counts are those of the file; what it takes for them is
/// within bounds. Not to be copied: `bytes` may be those that it holds.
struct DracoStream {
    std::span<const std::uint8_t> bytes; ///< without metadata, which glTF has no use for
    platform::Bytes withoutMetadata;     ///< what `bytes` are in, if there was some
    bool isEdgebreaker = false;          ///< else sequential
    std::uint32_t triangles = 0;
    std::uint64_t connectivityBytes = 0; ///< that decoding takes at most, except for attributes
};

/// Reads the header, the counts and the tables of the connectivity. Refuses what is no mesh of bitstream 2.2, and what goes
/// over the bounds.
DracoStream openDraco(std::span<const std::uint8_t> compressed, const DracoBounds& bounds,
                      const std::string& where);

/// What hasBoundedTable() finds.
inline constexpr const char* kTooLargeTable = "a table of more symbols than an encoder writes";
/// Whether the symbols that come next in a buffer have a table of no more entries than an encoder writes. The buffer only
/// states that number, and the decoder takes memory for it before it reads on.
bool hasBoundedTable(const draco::DecoderBuffer& buffer);

} // namespace cdr::scene::gltf
