#pragma once

#include "block_cache.h"
#include "byte_source.h"

#include <cdr/platform/file.h>
#include <cdr/scene/gltf/gltf.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace cdr::scene::gltf {

/// Reads what a glTF refers to, and nothing outside the folder it is in.
class Files {
  public:
    /// @param folder none where the glTF is in memory: then it may refer to no file.
    Files(std::optional<std::filesystem::path> folder, const GltfLimits& limits);

    /// The bytes of a `data:` URI or of the file that a relative, percent-encoded URI names. A file counts each time.
    ByteSource open(const std::string& uri);
    /// The bytes of a URI that was opened, as they are now. They count no more. Threads may share this.
    platform::Bytes readAgain(const std::string& uri) const;

    /// Counts a picture that is read out of a buffer view. Refuses it where all of them take too many bytes together: many may share
    /// a view, and each is read in full.
    void countInView(std::size_t bytes, const std::string& picture);

    /// The file that a URI names, which is no `data:` URI; refuses one outside the folder.
    std::filesystem::path resolve(const std::string& uri) const;

  private:
    ByteSource openWithin(const std::string& uri, std::uintmax_t maxBytes) const;

    std::optional<std::filesystem::path> m_folder;
    std::uintmax_t m_maxFileBytes;
    std::uintmax_t
        m_bytesLeft; ///< of all files together: one small file named a thousand times must not fill memory
    std::uintmax_t m_viewBytesLeft; ///< the same for all pictures in buffer views
};

/// The bytes of a buffer view, all inside its buffer.
struct BufferView {
    ByteSource bytes;
    std::size_t stride = 0; ///< between elements, 0 where they follow each other
};

/// A document's buffers. One is opened when first used. What files hold stays there until it is read, except for small
/// files and for files beyond the first kMaxOpenFiles ones.
class Buffers {
  public:
    static constexpr std::size_t kMaxOpenFiles = 64;

    /// @param root of the document; must outlive this, as `files` must.
    /// @param bin the BIN chunk, if any.
    Buffers(const nlohmann::json& root, const std::optional<ByteSource>& bin, Files& files,
            const GltfLimits& limits);

    /// Refuses a view in a buffer that has no bytes: only those that are used must, since extensions may hold
    /// the rest. What EXT_meshopt_compression calls a fallback has none. What that extension holds is decoded when
    /// first asked for, and kept.
    BufferView view(int index) const;
    /// What was read last of the views that are in files.
    BlockCache& blocks() const { return m_blocks; }

  private:
    ByteSource decoded(int index, const nlohmann::json& compressed, std::size_t length,
                       const std::string& where) const;
    ByteSource range(int buffer, std::size_t offset, std::size_t length, const std::string& where) const;

    bool hasBytes(int buffer) const;
    /// A buffer that has bytes.
    const ByteSource& opened(int buffer) const;

    const nlohmann::json& m_root;
    std::optional<ByteSource> m_bin;
    Files& m_files;
    mutable std::map<int, ByteSource> m_opened; ///< by buffer
    mutable std::size_t m_openFiles = 0;
    mutable std::map<int, ByteSource> m_decoded; ///< by view
    mutable std::uintmax_t m_decodableBytes;     ///< that are left, of all views together
    mutable BlockCache m_blocks;
};

} // namespace cdr::scene::gltf
