#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <optional>

namespace cdr::gpu {

/// The first queue family that does graphics and compute.
std::optional<std::uint32_t> findQueueFamily(vk::PhysicalDevice physical);

/// The Vulkan format of depth attachments for `format`, if the device has one.
std::optional<vk::Format> findDepthFormat(vk::PhysicalDevice physical, depth::DepthFormat format);

DeviceInfo describe(vk::PhysicalDevice physical, std::uint32_t index);

/// Whether --device, a number or a part of a name in any case, means this device. An empty choice means all.
bool isChosen(const DeviceInfo& info, const std::string& choice);

} // namespace cdr::gpu
