#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cdr::gpu {

/// The names of those that are off.
std::vector<std::string> thoseOff(std::initializer_list<std::pair<vk::Bool32, const char*>> features);

/// The first queue family that does graphics and compute.
std::optional<std::uint32_t> findQueueFamily(vk::PhysicalDevice physical);

/// The Vulkan format of depth attachments for `format`, if the device has one.
std::optional<vk::Format> findDepthFormat(vk::PhysicalDevice physical, depth::DepthFormat format);

/// Whether a device can be made with this extension.
bool hasExtension(vk::PhysicalDevice physical, std::string_view name);

DeviceInfo describe(vk::PhysicalDevice physical, std::uint32_t index);

/// Whether --device, a number or a part of a name in any case, means this device. An empty choice means all.
bool isChosen(const DeviceInfo& info, const std::string& choice);

} // namespace cdr::gpu
