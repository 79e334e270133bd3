#pragma once

#include "document.h"

#include <cdr/host/file.h>
#include <cdr/scene/gltf/gltf.h>

#include <cstdint>
#include <filesystem>
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

  private:
    std::filesystem::path resolve(const std::string& uri) const;

    std::filesystem::path m_folder;
    std::uintmax_t m_maxFileBytes;
    std::uintmax_t
        m_bytesLeft; ///< of all files together: one small file named a thousand times must not fill memory
};

/// A document's buffers; those of a GLB's BIN chunk stay where they are.
class Buffers {
  public:
    /// @param bin the BIN chunk, if any; must outlive this.
    Buffers(const std::vector<DataSource>& sources, std::optional<std::span<const std::uint8_t>> bin,
            Files& files);

    /// The bytes of a buffer view, all inside its buffer. Refuses one in a buffer that has none: only those
    /// that are used must, since extensions may hold the rest.
    std::span<const std::uint8_t> view(const tinygltf::Model& model, int bufferView) const;

  private:
    std::vector<host::Bytes> m_owned;
    std::vector<std::optional<std::span<const std::uint8_t>>> m_buffers; ///< none where the file has no bytes
};

} // namespace cdr::scene::gltf
