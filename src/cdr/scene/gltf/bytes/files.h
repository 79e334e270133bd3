#pragma once

#include <cdr/host/file.h>
#include <cdr/scene/gltf/gltf.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cdr::scene::gltf {

/// Reads what a glTF refers to, and nothing outside the folder it is in.
class Files {
  public:
    Files(std::filesystem::path folder, const GltfLimits& limits);

    /// The bytes of a `data:` URI or of the file that a relative, percent-encoded URI names.
    host::Bytes read(const std::string& uri);

    /// The file that a URI names, which is no `data:` URI; refuses one outside the folder.
    std::filesystem::path resolve(const std::string& uri) const;

  private:
    std::filesystem::path m_folder;
    std::uintmax_t m_maxFileBytes;
    std::uintmax_t
        m_bytesLeft; ///< of all files together: one small file named a thousand times must not fill memory
};

/// The bytes of a buffer view, all inside its buffer.
struct BufferView {
    std::span<const std::uint8_t> bytes;
    std::size_t stride = 0; ///< between elements, 0 where they follow each other
};

/// A document's buffers; those of a GLB's BIN chunk stay where they are.
class Buffers {
  public:
    /// @param root of the document; must outlive this.
    /// @param bin the BIN chunk, if any; must outlive this.
    Buffers(const nlohmann::json& root, std::optional<std::span<const std::uint8_t>> bin, Files& files,
            const GltfLimits& limits);

    /// Refuses a view in a buffer that has no bytes: only those that are used must, since extensions may hold
    /// the rest. What EXT_meshopt_compression holds is decoded when first asked for, and kept.
    BufferView view(int index) const;

  private:
    std::span<const std::uint8_t> decoded(int index, const nlohmann::json& compressed, std::size_t length,
                                          const std::string& where) const;
    std::span<const std::uint8_t> range(int buffer, std::size_t offset, std::size_t length,
                                        const std::string& where) const;

    const nlohmann::json& m_root;
    mutable std::map<int, host::Bytes> m_decoded; ///< by view
    mutable std::uintmax_t m_decodableBytes;      ///< that are left, of all views together
    std::vector<host::Bytes> m_owned;
    std::vector<std::optional<std::span<const std::uint8_t>>> m_buffers; ///< none where the file has no bytes
};

} // namespace cdr::scene::gltf
