#include "container.h"

#include "../checks.h"

#include <cstddef>

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

std::string_view asText(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Walks the chunks of a GLB and keeps its first JSON and BIN chunk; the format says to skip other ones.
Container openChunks(std::span<const std::uint8_t> file) {
    Container container;
    std::size_t number = 0;
    while (!file.empty()) {
        if (file.size() < kChunkHeaderBytes) {
            refuse("GLB chunk {} is cut off", number);
        }
        const std::uint32_t length = littleEndian32(file, 0);
        const std::uint32_t type = littleEndian32(file, 4);
        file = file.subspan(kChunkHeaderBytes);
        if (length > file.size()) {
            refuse("GLB chunk {} is {} bytes but {} are left in the file", number, length, file.size());
        }
        if ((number == 0) != (type == kJsonChunk)) {
            refuse("GLB chunk {} is {}", number, number == 0 ? "not JSON" : "a second JSON");
        }
        if (number == 0) {
            container.json = asText(file.first(length));
        } else if (type == kBinChunk && !container.bin) {
            container.bin = file.first(length);
        }
        file = file.subspan(length);
        ++number;
    }
    return container;
}

} // namespace

Container openContainer(std::span<const std::uint8_t> file) {
    if (file.size() < 4 || littleEndian32(file, 0) != kMagic) {
        return {asText(file), {}};
    }
    if (file.size() < kHeaderBytes + kChunkHeaderBytes) {
        refuse("GLB header is cut off");
    }
    const std::uint32_t version = littleEndian32(file, 4);
    const std::uint32_t length = littleEndian32(file, 8);
    if (version != 2) {
        refuse("GLB version {} is not supported, only 2", version);
    }
    if (length < kHeaderBytes + kChunkHeaderBytes || length > file.size()) {
        refuse("GLB says it has {} bytes but the file has {}", length, file.size());
    }
    return openChunks(file.subspan(kHeaderBytes, length - kHeaderBytes));
}

} // namespace cdr::scene::gltf
