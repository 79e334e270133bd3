#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <cstddef>
#include <span>
#include <vector>

namespace cdr::render {

/// Gathers values on their way into some buffers of a device.
class Stager {
  public:
    /// @param buffer among those of write()
    /// @param first place of the values in it
    /// @param values must be there until write()
    template <typename Values>
    void add(std::size_t buffer, std::size_t first, const Values& values) {
        const std::span all(values);
        add({.buffer = buffer, .offset = first * sizeof(all[0]), .bytes = std::as_bytes(all)});
    }

    bool isEmpty() const { return m_pieces.empty(); }

    /// Puts all into a buffer that the host writes, which grows where it must, and adds the copies from there. Without
    /// anything there is no buffer after it.
    /// base::RunError when the device's memory does not suffice, with both figures where that is known before.
    /// @param regions by buffer
    void write(const gpu::Device& device, gpu::Buffer& staging,
               std::span<std::vector<vk::BufferCopy>> regions) const;

  private:
    struct Piece {
        std::size_t buffer = 0;
        std::size_t offset = 0; ///< in it, bytes
        std::span<const std::byte> bytes;
    };
    void add(const Piece& piece);

    std::vector<Piece> m_pieces;
    std::size_t m_bytes = 0;
};

} // namespace cdr::render
