#include "stream.h"

#include "../checks.h"

#include <draco/compression/config/compression_shared.h>
#include <draco/compression/entropy/symbol_decoding.h>
#include <draco/core/decoder_buffer.h>
#include <draco/core/varint_decoding.h>

#include <algorithm>
#include <vector>

namespace cdr::scene::gltf {

namespace {

// The header: "DRACO", version, kind of geometry, method, flags.
constexpr std::size_t kVersionAt = 5;
constexpr std::size_t kGeometryAt = 7;
constexpr std::size_t kMethodAt = 8;
constexpr std::size_t kFlagsAt = 9;
constexpr std::size_t kDracoHeaderBytes = 11;
constexpr std::uint8_t kMetadataFlag = METADATA_FLAG_MASK >> 8; // in the higher byte

/// An encoder's tables have a symbol for each value below 2^18 at most.
constexpr std::uint32_t kMaxTableSymbols = 1u << 18;
/// What decoding symbols takes: 12 bytes a symbol, and a table of 2^20 numbers.
constexpr std::uint64_t kTableBytes = 12ull * kMaxTableSymbols + (4ull << 20);

// What the decoder keeps, from reading libdraco 1.5; vectors that grow count three times.
constexpr std::uint64_t kSequentialTriangleBytes = 60;
constexpr std::uint64_t kEdgebreakerTriangleBytes = 352;
/// Of each table of attributes with seams of their own.
constexpr std::uint64_t kTableTriangleBytes = 208;
constexpr std::uint64_t kEdgebreakerVertexBytes = 24;

constexpr int kValenceContexts = 6;

/// Reads a stream, and refuses to go beyond its end.
class DracoReader {
  public:
    DracoReader(std::span<const std::uint8_t> bytes, const std::string& where) : m_where(where) {
        m_buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size(),
                      draco::kDracoMeshBitstreamVersion);
    }

    [[noreturn]] void refuseDamaged() const { refuse("{}: what {} holds is damaged", m_where, kDraco); }

    std::uint8_t byte() {
        std::uint8_t value = 0;
        require(m_buffer.Decode(&value));
        return value;
    }
    std::uint32_t number() {
        std::uint32_t value = 0;
        require(draco::DecodeVarint(&value, &m_buffer));
        return value;
    }
    void skip(std::uint64_t bytes) {
        require(bytes <= left());
        m_buffer.Advance(static_cast<std::int64_t>(bytes));
    }
    /// Skips symbols, which only the decoder can tell the end of.
    void skipSymbols(std::uint32_t count) {
        requireBoundedTable();
        std::vector<std::uint32_t> symbols(count);
        require(draco::DecodeSymbols(count, 1, &m_buffer, symbols.data()));
    }
    void requireBoundedTable() const {
        if (!hasBoundedTable(m_buffer)) {
            refuse("{}: {} holds {}", m_where, kDraco, kTooLargeTable);
        }
    }
    void require(bool isSound) const {
        if (!isSound) {
            refuseDamaged();
        }
    }
    std::uint64_t left() const { return static_cast<std::uint64_t>(m_buffer.remaining_size()); }

  private:
    draco::DecoderBuffer m_buffer;
    const std::string& m_where;
};

void requireMesh(std::span<const std::uint8_t> bytes, const std::string& where) {
    constexpr std::string_view kMagic = "DRACO";
    if (bytes.size() < kDracoHeaderBytes || !std::equal(kMagic.begin(), kMagic.end(), bytes.begin())) {
        refuse("{}: {} holds no Draco stream", where, kDraco);
    }
    if (bytes[kGeometryAt] != draco::TRIANGULAR_MESH) {
        refuse("{}: {} holds {}, and only triangles are drawn", where, kDraco,
               bytes[kGeometryAt] == draco::POINT_CLOUD ? "a point cloud" : "what is no mesh");
    }
    if (bytes[kVersionAt] != draco::kDracoMeshBitstreamVersionMajor ||
        bytes[kVersionAt + 1] != draco::kDracoMeshBitstreamVersionMinor) {
        refuse("{}: {} holds a stream of version {}.{}, and glTF has 2.2", where, kDraco, bytes[kVersionAt],
               bytes[kVersionAt + 1]);
    }
}

/// Skips one tree of metadata. Draco reads them by a stack that a hostile one makes as large as it likes.
void skipMetadataTree(DracoReader& reader) {
    bool isNamed = false;
    for (std::uint64_t open = 1; open > 0; --open) {
        if (isNamed) {
            reader.skip(reader.byte());
        }
        isNamed = true;
        for (std::uint32_t entries = reader.number(); entries > 0; --entries) {
            reader.skip(reader.byte());
            reader.skip(reader.number());
        }
        open += reader.number();
    }
}

void requireRoom(const DracoStream& stream, const DracoBounds& bounds, const std::string& where) {
    if (stream.connectivityBytes > bounds.bytes) {
        refuse("{}: decoding {} would take {} bytes of memory, and {} are left of the limit", where, kDraco,
               stream.connectivityBytes, bounds.bytes);
    }
}

/// Removes metadata.
void strip(DracoStream& stream, const DracoBounds& bounds, const std::string& where) {
    if ((stream.bytes[kFlagsAt + 1] & kMetadataFlag) == 0) {
        return;
    }
    stream.connectivityBytes = stream.bytes.size();
    requireRoom(stream, bounds, where);
    DracoReader reader(stream.bytes.subspan(kDracoHeaderBytes), where);
    for (std::uint32_t attributes = reader.number(); attributes > 0; --attributes) {
        reader.number();
        skipMetadataTree(reader);
    }
    skipMetadataTree(reader);
    stream.withoutMetadata.assign(stream.bytes.begin(), stream.bytes.begin() + kDracoHeaderBytes);
    stream.withoutMetadata[kFlagsAt + 1] &= static_cast<std::uint8_t>(~kMetadataFlag);
    const auto rest = stream.bytes.last(static_cast<std::size_t>(reader.left()));
    stream.withoutMetadata.insert(stream.withoutMetadata.end(), rest.begin(), rest.end());
    stream.bytes = stream.withoutMetadata;
}

void requireTriangles(std::uint32_t triangles, const DracoBounds& bounds, const std::string& where) {
    if (triangles == 0 || triangles != bounds.triangles) {
        refuse("{}: {} holds {} triangles, and its indices make {}", where, kDraco, triangles,
               bounds.triangles);
    }
}

void openSequential(DracoReader& reader, DracoStream& stream, const DracoBounds& bounds,
                    const std::string& where) {
    stream.triangles = reader.number();
    const std::uint32_t vertices = reader.number();
    requireTriangles(stream.triangles, bounds, where);
    reader.require(vertices <= 3ull * stream.triangles);
    stream.connectivityBytes += stream.triangles * kSequentialTriangleBytes + kTableBytes;
    requireRoom(stream, bounds, where);
    if (reader.byte() == 0) {
        reader.requireBoundedTable();
    }
}

void skipSplits(DracoReader& reader, std::uint32_t triangles) {
    const std::uint32_t splits = reader.number();
    reader.require(splits <= triangles);
    for (std::uint32_t i = 0; i < splits; ++i) {
        reader.number();
        reader.number();
    }
    reader.skip((splits + 7ull) / 8); // a bit of each
}

void openEdgebreaker(DracoReader& reader, DracoStream& stream, const DracoBounds& bounds,
                     const std::string& where) {
    const std::uint8_t kind = reader.byte();
    if (kind != draco::MESH_EDGEBREAKER_STANDARD_ENCODING &&
        kind != draco::MESH_EDGEBREAKER_VALENCE_ENCODING) {
        refuse("{}: {} holds triangles in a way that is not supported ({})", where, kDraco, kind);
    }
    std::uint64_t vertices = reader.number();
    stream.triangles = reader.number();
    requireTriangles(stream.triangles, bounds, where);
    reader.require(vertices <= 3ull * stream.triangles);
    const std::uint8_t tables = reader.byte();
    const std::uint32_t symbols = reader.number();
    const std::uint32_t splits = reader.number();
    reader.require(symbols <= stream.triangles && splits <= symbols);
    vertices += splits;
    stream.connectivityBytes +=
        stream.triangles * (kEdgebreakerTriangleBytes + tables * kTableTriangleBytes) +
        vertices * kEdgebreakerVertexBytes * (1ull + tables) + kTableBytes;
    requireRoom(stream, bounds, where);
    if (kind == draco::MESH_EDGEBREAKER_STANDARD_ENCODING) {
        return; // its symbols are plain bits
    }
    skipSplits(reader, stream.triangles);
    for (int i = 0; i < 1 + tables; ++i) { // starts of components, and seams
        reader.byte();
        reader.skip(reader.number());
    }
    for (int i = 0; i < kValenceContexts; ++i) {
        const std::uint32_t count = reader.number();
        reader.require(count <= stream.triangles);
        if (count > 0) {
            reader.skipSymbols(count);
        }
    }
}

} // namespace

bool hasBoundedTable(const draco::DecoderBuffer& buffer) {
    draco::DecoderBuffer ahead = buffer;
    std::uint8_t scheme = 0;
    std::uint8_t bits = 0;
    std::uint32_t symbols = 0;
    return ahead.Decode(&scheme) && (scheme != draco::SYMBOL_CODING_RAW || ahead.Decode(&bits)) &&
           draco::DecodeVarint(&symbols, &ahead) && symbols <= kMaxTableSymbols;
}

DracoStream openDraco(std::span<const std::uint8_t> compressed, const DracoBounds& bounds,
                      const std::string& where) {
    requireMesh(compressed, where);
    DracoStream stream{.bytes = compressed, .withoutMetadata = {}};
    strip(stream, bounds, where);
    DracoReader reader(stream.bytes.subspan(kDracoHeaderBytes), where);
    const std::uint8_t method = stream.bytes[kMethodAt];
    stream.isEdgebreaker = method == draco::MESH_EDGEBREAKER_ENCODING;
    if (stream.isEdgebreaker) {
        openEdgebreaker(reader, stream, bounds, where);
    } else if (method == draco::MESH_SEQUENTIAL_ENCODING) {
        openSequential(reader, stream, bounds, where);
    } else {
        reader.refuseDamaged();
    }
    return stream;
}

} // namespace cdr::scene::gltf
