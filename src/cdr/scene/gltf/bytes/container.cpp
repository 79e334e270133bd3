#include "container.h"

#include "../checks.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cdr::scene::gltf {

namespace {

constexpr std::uint32_t kMagic = 0x46546c67;     // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a; // "JSON"
constexpr std::uint32_t kBinChunk = 0x004e4942;  // "BIN"
constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;

std::uint32_t littleEndian32(std::span<const std::uint8_t> bytes, std::size_t at) {
    return std::uint32_t{bytes[at]} | std::uint32_t{bytes[at + 1]} << 8 | std::uint32_t{bytes[at + 2]} << 16 |
           std::uint32_t{bytes[at + 3]} << 24;
}

/// Reads the headers of chunks. Small chunks follow each other, so it reads some bytes ahead.
class HeaderReader {
  public:
    explicit HeaderReader(const ByteSource& file) : m_file(file) {}

    /// `length` bytes, at most kMaxBytes, all inside the file.
    std::span<const std::uint8_t> at(std::size_t offset, std::size_t length) {
        if (offset < m_begin || offset + length > m_begin + m_ahead.size()) {
            m_begin = offset;
            m_ahead.resize(std::min(kMaxBytes, m_file.size() - offset));
            m_file.read(offset, m_ahead);
        }
        return std::span(m_ahead).subspan(offset - m_begin, length);
    }

  private:
    static constexpr std::size_t kMaxBytes = 4096;

    const ByteSource& m_file;
    std::size_t m_begin = 0;
    platform::Bytes m_ahead;
};

/// Walks the chunks of a GLB and keeps its first JSON and BIN chunk; the format says to skip other ones.
Container openChunks(const ByteSource& file, HeaderReader& headers, std::size_t end) {
    Container container;
    std::size_t number = 0;
    for (std::size_t at = kHeaderBytes; at < end; ++number) {
        if (end - at < kChunkHeaderBytes) {
            refuse("GLB chunk {} is cut off", number);
        }
        const std::span<const std::uint8_t> header = headers.at(at, kChunkHeaderBytes);
        const std::uint32_t length = littleEndian32(header, 0);
        const std::uint32_t type = littleEndian32(header, 4);
        at += kChunkHeaderBytes;
        if (length > end - at) {
            refuse("GLB chunk {} is {} bytes but {} are left in the file", number, length, end - at);
        }
        if ((number == 0) != (type == kJsonChunk)) {
            refuse("GLB chunk {} is {}", number, number == 0 ? "not JSON" : "a second JSON");
        }
        if (number == 0) {
            container.json = file.part(at, length).read();
        } else if (type == kBinChunk && !container.bin) {
            container.bin = file.part(at, length);
        }
        at += length;
    }
    return container;
}

} // namespace

Container openContainer(const ByteSource& file) {
    HeaderReader headers(file);
    if (file.size() < 4 || littleEndian32(headers.at(0, 4), 0) != kMagic) {
        return {.json = file.read(), .bin = {}};
    }
    if (file.size() < kHeaderBytes + kChunkHeaderBytes) {
        refuse("GLB header is cut off");
    }
    const std::span<const std::uint8_t> header = headers.at(0, kHeaderBytes);
    const std::uint32_t version = littleEndian32(header, 4);
    const std::uint32_t length = littleEndian32(header, 8);
    if (version != 2) {
        refuse("GLB version {} is not supported, only 2", version);
    }
    if (length < kHeaderBytes + kChunkHeaderBytes || length > file.size()) {
        refuse("GLB says it has {} bytes but the file has {}", length, file.size());
    }
    return openChunks(file, headers, length);
}

} // namespace cdr::scene::gltf
