#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cdr::gpu {

/// Most storage buffers that shaders of gpu-driven draws bind, and most invocations of their workgroups: DeviceInfo::gpuDrivenMissing
/// asks for them.
inline constexpr std::uint32_t kGpuDrivenStorageBuffers = 14;
inline constexpr std::uint32_t kGpuDrivenInvocations = 256;

/// The names of those that are off.
std::vector<std::string> thoseOff(std::initializer_list<std::pair<vk::Bool32, const char*>> features);

/// The first queue family that does graphics and compute.
std::optional<std::uint32_t> findQueueFamily(vk::PhysicalDevice physical);

/// The Vulkan format of depth attachments for `format`, if the device has one.
std::optional<vk::Format> findDepthFormat(vk::PhysicalDevice physical, depth::DepthFormat format);

/// Whether a device can be made with this extension.
bool hasExtension(vk::PhysicalDevice physical, std::string_view name);

/// The extensions that a device must be made with. Drivers that lack a part of Vulkan say so by one, and ask for it.
std::vector<const char*> extensionsAskedFor(vk::PhysicalDevice physical);

DeviceInfo describe(vk::PhysicalDevice physical, std::uint32_t index);

/// Whether --device, a number or a part of a name in any case, means this device. An empty choice means all.
bool isChosen(const DeviceInfo& info, const std::string& choice);

} // namespace cdr::gpu
