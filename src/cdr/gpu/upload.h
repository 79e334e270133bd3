#pragma once

#include <cdr/gpu/memory.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace cdr::gpu {

/// A device-only buffer that holds a copy of `bytes`.
Buffer uploadBuffer(const Device& device, std::span<const std::byte> bytes, vk::BufferUsageFlags usage,
                    const std::string& name);

/// Fills a device-only buffer from its beginning, in parts of at most kMaxBytes. So no second copy of a large buffer is in
/// memory.
class BufferFill {
  public:
    static constexpr std::size_t kMaxBytes = std::size_t{32} << 20u;

    /// @param buffer made with vk::BufferUsageFlagBits::eTransferDst; nothing that was submitted reads it. It must outlive
    /// this.
    BufferFill(const Device& device, const Buffer& buffer) : m_device(device), m_buffer(buffer) {}

    /// Puts bytes behind those before, for which there must be room.
    void add(std::span<const std::byte> bytes);
    /// Waits until all is in the buffer.
    void finish();

  private:
    const Device& m_device;
    const Buffer& m_buffer;
    Buffer m_staging;
    std::size_t m_staged = 0;  ///< bytes that wait in m_staging
    std::size_t m_written = 0; ///< bytes that are in the buffer
};

/// Bytes that go to a place in a buffer.
struct BufferPart {
    std::size_t offset = 0;
    std::vector<std::byte> bytes;
};

/// Writes parts of what uploadBuffer() made, and waits. Nothing that was submitted may still read them.
void writeBuffer(const Device& device, const Buffer& buffer, std::span<const BufferPart> parts);

/// A sampled image of 4-byte pixels, ready for fragment shaders.
/// @param levels its levels' pixels, tightly packed, largest first; each the smallerLevel() of the one before. There must
/// be one.
Image uploadImage(const Device& device, vk::Extent2D extent, vk::Format format,
                  std::span<const std::span<const std::byte>> levels, const std::string& name);

} // namespace cdr::gpu
