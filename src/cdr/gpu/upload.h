#pragma once

#include <cdr/gpu/memory.h>

#include <cstdint>
#include <span>
#include <string>

namespace cdr::gpu {

/// A device-only buffer that holds a copy of `bytes`.
Buffer uploadBuffer(const Device& device, std::span<const std::byte> bytes, vk::BufferUsageFlags usage,
                    const std::string& name);

/// A sampled image that holds tightly packed 4-byte pixels, ready for fragment shaders.
Image uploadImage(const Device& device, vk::Extent2D extent, vk::Format format,
                  std::span<const std::byte> pixels, const std::string& name);

} // namespace cdr::gpu
