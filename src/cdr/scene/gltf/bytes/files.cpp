#include "files.h"

#include "../checks.h"
#include "../json.h"
#include "compression.h"
#include "data_uri.h"
#include "meshopt.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <memory>
#include <system_error>

namespace cdr::scene::gltf {

namespace {

namespace fs = std::filesystem;

/// How many times the limit of one file the external files of one glTF may take together, and its pictures in buffers.
constexpr std::uintmax_t kFilesInMemory = 4;

/// Most bytes of a file that is not worth an open descriptor.
constexpr std::size_t kSmallFile = 4 * BlockCache::kBlockBytes;

/// Most bytes from one element of a buffer view to the next, as glTF has it.
constexpr std::size_t kMaxStride = 252;

std::string percentDecode(const std::string& uri) {
    std::string decoded;
    decoded.reserve(uri.size());
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            decoded += uri[i];
            continue;
        }
        const std::string digits = uri.substr(i + 1, 2);
        unsigned value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
        if (error != std::errc() || digits.size() != 2 || end != digits.data() + 2) {
            refuse("URI '{}' has a '%' that is not followed by two hexadecimal digits", oneLine(uri));
        }
        decoded += static_cast<char>(value);
        i += 2;
    }
    return decoded;
}

/// Whether the text starts as `http:` or `C:` do.
bool hasScheme(const std::string& uri) {
    const auto end = std::ranges::find_if(
        uri, [](unsigned char c) { return std::isalnum(c) == 0 && c != '+' && c != '-' && c != '.'; });
    return end != uri.begin() && end != uri.end() && *end == ':';
}

bool isInside(const fs::path& path, const fs::path& folder) {
    const auto [inFolder, inPath] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return inFolder == folder.end() && inPath != path.end();
}

} // namespace

Files::Files(std::optional<fs::path> folder, const GltfLimits& limits)
    : m_folder(folder && folder->empty() ? fs::path(".") : std::move(folder)),
      m_maxFileBytes(limits.maxFileBytes),
      m_bytesLeft(std::max(limits.maxFileBytes, limits.maxFileBytes * kFilesInMemory)),
      m_viewBytesLeft(m_bytesLeft) {}

ByteSource Files::openWithin(const std::string& uri, std::uintmax_t maxBytes) const {
    if (isDataUri(uri)) {
        return ByteSource(decodeDataUri(uri));
    }
    return ByteSource(std::make_shared<const OpenFile>(resolve(uri), maxBytes,
                                                       fmt::format("'{}'", oneLine(uri, kMaxNameLength))));
}

ByteSource Files::open(const std::string& uri) {
    ByteSource bytes = openWithin(uri, std::min(m_maxFileBytes, m_bytesLeft));
    m_bytesLeft -= bytes.file() != nullptr ? bytes.size() : 0;
    return bytes;
}

platform::Bytes Files::readAgain(const std::string& uri) const {
    return openWithin(uri, m_maxFileBytes).read();
}

void Files::countInView(std::size_t bytes, const std::string& picture) {
    if (bytes > m_viewBytesLeft) {
        refuse("{}: with it, pictures in buffer views are over the limit of bytes", picture);
    }
    m_viewBytesLeft -= bytes;
}

fs::path Files::resolve(const std::string& uri) const {
    const std::string decoded = percentDecode(uri);
    // Backslashes and drive letters separate nothing here, but would elsewhere: the same file loads
    // everywhere.
    if (hasScheme(decoded) || decoded.empty() ||
        decoded.find_first_of(std::string("\\\0", 2)) != std::string::npos) {
        refuse("URI '{}' is not a relative path", oneLine(uri));
    }
    const fs::path relative = fs::path(decoded).lexically_normal();
    if (relative.is_absolute() || *relative.begin() == "..") {
        refuse("URI '{}' leads out of the file's folder", oneLine(uri));
    }
    if (!m_folder) {
        refuse("URI '{}' names a file, and beside bytes in memory there is none", oneLine(uri));
    }
    std::error_code folderError;
    std::error_code pathError;
    const fs::path folder = fs::weakly_canonical(*m_folder, folderError);
    fs::path path = fs::weakly_canonical(*m_folder / relative, pathError);
    if (folderError || pathError) {
        refuse("URI '{}' cannot be read: {}", oneLine(uri),
               (folderError ? folderError : pathError).message());
    }
    if (path == folder) {
        refuse("URI '{}' names the file's folder, not a file in it", oneLine(uri));
    }
    if (!isInside(path, folder)) {
        refuse("URI '{}' leads out of the file's folder through a link", oneLine(uri));
    }
    return path;
}

Buffers::Buffers(const nlohmann::json& root, const std::optional<ByteSource>& bin, Files& files,
                 const GltfLimits& limits)
    : m_root(root),
      m_bin(bin),
      m_files(files),
      m_decodableBytes(limits.maxFileBytes) {}

bool Buffers::hasBytes(int buffer) const {
    const nlohmann::json& source = itemAt(m_root, "buffers", buffer, "buffer");
    const nlohmann::json* meshopt = extensionOf(source, kMeshopt);
    const bool isFallback =
        meshopt != nullptr && boolMember(*meshopt, "fallback", fmt::format("buffer {}", buffer));
    return !isFallback && (member(source, "uri") != nullptr || (buffer == 0 && m_bin));
}

const ByteSource& Buffers::opened(int buffer) const {
    if (const auto found = m_opened.find(buffer); found != m_opened.end()) {
        return found->second;
    }
    const nlohmann::json& source = itemAt(m_root, "buffers", buffer, "buffer");
    const auto byteLength = static_cast<std::size_t>(indexMember(source, "byteLength").value_or(0));
    if (byteLength == 0) {
        refuse("buffer {} has no byteLength", buffer);
    }
    ByteSource bytes;
    if (const std::optional<std::string> uri = stringMember(source, "uri")) {
        bytes = m_files.open(*uri);
        if (bytes.file() != nullptr && (bytes.size() <= kSmallFile || m_openFiles == kMaxOpenFiles)) {
            bytes = ByteSource(bytes.read());
        }
        m_openFiles += bytes.file() != nullptr ? 1 : 0;
    } else {
        bytes = m_bin.value();
    }
    if (byteLength > bytes.size()) {
        refuse("buffer {} says it has {} bytes but its data has {}", buffer, byteLength, bytes.size());
    }
    return m_opened.emplace(buffer, bytes.part(0, byteLength)).first->second;
}

BufferView Buffers::view(int index) const {
    const nlohmann::json& view = itemAt(m_root, "bufferViews", index, "buffer view");
    const std::string where = fmt::format("buffer view {}", index);
    const int buffer = requiredIndex(view, "buffer", where);
    const auto offset = static_cast<std::size_t>(indexMember(view, "byteOffset").value_or(0));
    const auto length = static_cast<std::size_t>(requiredIndex(view, "byteLength", where));
    const auto stride = static_cast<std::size_t>(indexMember(view, "byteStride").value_or(0));
    if (stride > kMaxStride || stride % 4 != 0) {
        refuse("{}: its byteStride is {}, not a multiple of 4 up to {}", where, stride, kMaxStride);
    }
    const nlohmann::json* compressed = meshoptOf(
        view, {.buffer = buffer, .offset = offset, .length = length, .hasBytes = hasBytes(buffer)}, where);
    return {compressed != nullptr ? decoded(index, *compressed, length, where)
                                  : range(buffer, offset, length, where),
            stride};
}

ByteSource Buffers::range(int buffer, std::size_t offset, std::size_t length,
                          const std::string& where) const {
    if (!hasBytes(buffer)) {
        refuse("buffer {} has neither a URI nor a BIN chunk, or is a fallback", buffer);
    }
    const ByteSource& bytes = opened(buffer);
    if (offset > bytes.size() || length > bytes.size() - offset) {
        refuse("{} covers {} bytes from {} but buffer {} has {}", where, length, offset, buffer,
               bytes.size());
    }
    return bytes.part(offset, length);
}

ByteSource Buffers::decoded(int index, const nlohmann::json& compressed, std::size_t length,
                            const std::string& where) const {
    if (const auto found = m_decoded.find(index); found != m_decoded.end()) {
        return found->second;
    }
    const MeshoptView view = readMeshoptView(compressed, length, where);
    const ByteSource bytes = range(view.buffer, view.offset, view.length, where);
    if (length > m_decodableBytes) {
        refuse("{}: with it, decoded buffer views are over the limit of bytes", where);
    }
    m_decodableBytes -= length;
    return m_decoded.emplace(index, ByteSource(decodeMeshopt(view, bytes.read(), where))).first->second;
}

} // namespace cdr::scene::gltf
