#pragma once

#include <cdr/gpu/memory.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cdr::gpu {

/// A device-only buffer that holds a copy of `bytes`.
Buffer uploadBuffer(const Device& device, std::span<const std::byte> bytes, vk::BufferUsageFlags usage,
                    const std::string& name);

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
