#pragma once

#include <cdr/gpu/device.h>

#include <optional>

namespace cdr::gpu {

/// The first queue family that does graphics and compute.
std::optional<std::uint32_t> findQueueFamily(vk::PhysicalDevice physical);

/// The depth attachment format of 16, 24 or 32 (float) bits, if the device has one.
std::optional<vk::Format> findDepthFormat(vk::PhysicalDevice physical, int bits);

DeviceInfo describe(vk::PhysicalDevice physical, std::uint32_t index);

} // namespace cdr::gpu
