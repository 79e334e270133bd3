#include "files.h"

#include "checks.h"
#include "compression.h"
#include "tinygltf.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

namespace cdr::scene::gltf {

namespace {

namespace fs = std::filesystem;

/// How many times the limit of one file the external files of one glTF may take together.
constexpr std::uintmax_t kFilesInMemory = 4;

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
    const auto end = std::find_if(uri.begin(), uri.end(), [](unsigned char c) {
        return std::isalnum(c) == 0 && c != '+' && c != '-' && c != '.';
    });
    return end != uri.begin() && end != uri.end() && *end == ':';
}

bool isInside(const fs::path& path, const fs::path& folder) {
    const auto [inFolder, inPath] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return inFolder == folder.end() && inPath != path.end();
}

} // namespace

Files::Files(fs::path folder, const GltfLimits& limits)
    : m_folder(folder.empty() ? fs::path(".") : std::move(folder)),
      m_maxFileBytes(limits.maxFileBytes),
      m_bytesLeft(std::max(limits.maxFileBytes, limits.maxFileBytes * kFilesInMemory)) {}

host::Bytes Files::read(const std::string& uri) {
    if (uri.starts_with("data:")) {
        std::optional<host::Bytes> bytes = decodeDataUri(uri);
        if (!bytes) {
            refuse("data URI '{}...' cannot be decoded", oneLine(uri.substr(0, 40)));
        }
        return *std::move(bytes);
    }
    host::Bytes bytes = host::readFile(resolve(uri), std::min(m_maxFileBytes, m_bytesLeft));
    m_bytesLeft -= bytes.size();
    return bytes;
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
    std::error_code folderError;
    std::error_code pathError;
    const fs::path folder = fs::weakly_canonical(m_folder, folderError);
    fs::path path = fs::weakly_canonical(m_folder / relative, pathError);
    if (folderError || pathError) {
        refuse("URI '{}' cannot be read: {}", oneLine(uri),
               (folderError ? folderError : pathError).message());
    }
    if (!isInside(path, folder)) {
        refuse("URI '{}' leads out of the file's folder through a link", oneLine(uri));
    }
    return path;
}

Buffers::Buffers(const std::vector<DataSource>& sources, std::optional<std::span<const std::uint8_t>> bin,
                 Files& files) {
    m_owned.reserve(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
        std::span<const std::uint8_t> bytes;
        if (sources[i].uri) {
            bytes = m_owned.emplace_back(files.read(*sources[i].uri));
        } else if (i == 0 && bin) {
            bytes = *bin;
        } else {
            m_buffers.emplace_back();
            continue;
        }
        if (sources[i].byteLength > bytes.size()) {
            refuse("buffer {} says it has {} bytes but its data has {}", i, sources[i].byteLength,
                   bytes.size());
        }
        m_buffers.emplace_back(bytes.first(sources[i].byteLength));
    }
}

std::span<const std::uint8_t> Buffers::view(const tinygltf::Model& model, int bufferView) const {
    const tinygltf::BufferView& view = itemAt(model.bufferViews, bufferView, "buffer view");
    const auto& bytes = itemAt(m_buffers, view.buffer, "buffer");
    requireUncompressed(view, bufferView, bytes.has_value());
    if (!bytes) {
        refuse("buffer {} has neither a URI nor a BIN chunk", view.buffer);
    }
    const std::span<const std::uint8_t> buffer = *bytes;
    if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
        refuse("buffer view {} covers {} bytes from {} but buffer {} has {}", bufferView, view.byteLength,
               view.byteOffset, view.buffer, buffer.size());
    }
    return buffer.subspan(view.byteOffset, view.byteLength);
}

} // namespace cdr::scene::gltf
