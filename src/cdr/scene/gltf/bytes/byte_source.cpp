#include "byte_source.h"

#include "../checks.h"

#include <algorithm>
#include <utility>

namespace cdr::scene::gltf {

void readOpen(const OpenFile& file, std::uint64_t offset, std::span<std::uint8_t> bytes) {
    if (!file.file.read(offset, bytes)) {
        refuse("{}{} bytes from byte {} on can no longer be read", file.name.empty() ? "" : file.name + ": ",
               bytes.size(), offset);
    }
}

ByteSource::ByteSource(std::span<const std::uint8_t> bytes) : m_first(bytes.data()), m_size(bytes.size()) {}

ByteSource::ByteSource(platform::Bytes bytes)
    : m_owned(std::make_shared<const platform::Bytes>(std::move(bytes))),
      m_first(m_owned->data()),
      m_size(m_owned->size()) {}

ByteSource::ByteSource(std::shared_ptr<const OpenFile> file)
    : m_file(std::move(file)),
      m_size(static_cast<std::size_t>(m_file->file.size())) {}

ByteSource ByteSource::part(std::size_t offset, std::size_t length) const {
    ByteSource part = *this;
    if (part.m_file != nullptr) {
        part.m_offset += offset;
    } else if (part.m_first != nullptr) {
        part.m_first += offset;
    }
    part.m_size = length;
    return part;
}

void ByteSource::read(std::size_t offset, std::span<std::uint8_t> into) const {
    if (m_file != nullptr) {
        readOpen(*m_file, m_offset + offset, into);
    } else if (!into.empty()) {
        std::copy_n(m_first + offset, into.size(), into.begin());
    }
}

platform::Bytes ByteSource::read() const {
    platform::Bytes bytes(m_size);
    read(0, bytes);
    return bytes;
}

} // namespace cdr::scene::gltf
