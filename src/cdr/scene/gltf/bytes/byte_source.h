#pragma once

#include <cdr/platform/file.h>
#include <cdr/platform/input_file.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace cdr::scene::gltf {

/// A file that stays open while it is imported.
struct OpenFile {
    /// As InputFile.
    OpenFile(const std::filesystem::path& path, std::uintmax_t maxBytes, std::string nameInMessages)
        : file(path, maxBytes),
          name(std::move(nameInMessages)) {}

    platform::InputFile file;
    std::string name; ///< how messages name it; empty for the file that is imported
};

/// Refuses bytes that cannot be read although they were there when the file was opened. Threads may share the file.
void readOpen(const OpenFile& file, std::uint64_t offset, std::span<std::uint8_t> bytes);

/// Where bytes are: in memory, or in an open file. Copies share them, and threads may too.
class ByteSource {
  public:
    ByteSource() = default;
    /// Bytes that outlive this.
    explicit ByteSource(std::span<const std::uint8_t> bytes);
    explicit ByteSource(platform::Bytes bytes);
    explicit ByteSource(std::shared_ptr<const OpenFile> file);

    std::size_t size() const { return m_size; }
    /// Some of them; all must be inside.
    ByteSource part(std::size_t offset, std::size_t length) const;
    /// Copies some of them; all must be inside.
    void read(std::size_t offset, std::span<std::uint8_t> into) const;
    /// A copy of all of them.
    platform::Bytes read() const;

    /// The first one, if they are in memory; else null.
    const std::uint8_t* inMemory() const { return m_first; }
    /// The file that they are in, if they are not in memory; else null.
    const OpenFile* file() const { return m_file.get(); }
    /// The first one's place in the file.
    std::uint64_t offsetInFile() const { return m_offset; }

  private:
    std::shared_ptr<const platform::Bytes> m_owned; ///< that `m_first` is in, unless others own it
    const std::uint8_t* m_first = nullptr;
    std::shared_ptr<const OpenFile> m_file;
    std::uint64_t m_offset = 0; ///< in the file
    std::size_t m_size = 0;
};

} // namespace cdr::scene::gltf
