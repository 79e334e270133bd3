#pragma once

#include <cdr/base/export.h>

#include <vulkan/vulkan_core.h>

#include <string>
#include <vector>

namespace cdr::gpu {

/// Turns on the features that cdr needs, and those that it can use and the device has. It does so in the structs that the
/// device will be created with. What is on stays on. Of extensions it can use one, VK_EXT_conditional_rendering, by which
/// shadow maps that no pixel reads are not drawn: enable it, and have VkPhysicalDeviceConditionalRenderingFeaturesEXT in the chain.
/// @param instance of the device.
/// @param features whose pNext chain holds VkPhysicalDeviceVulkan12Features and VkPhysicalDeviceVulkan13Features.
/// @param loader as BorrowedDevice::loader.
/// @throws base::InputError for a null instance or physical device.
/// @throws base::InputError that names a feature which the device lacks, or a struct that the chain lacks.
/// @throws base::InputError and base::RunError for the loader, as Device(const BorrowedDevice&).
CDR_EXPORT void enableFeatures(VkInstance instance, VkPhysicalDevice physical,
                               VkPhysicalDeviceFeatures2& features,
                               PFN_vkGetInstanceProcAddr loader = nullptr);

/// The features that cdr needs and `features` leaves off, by their names in Vulkan. Empty when it can draw.
/// @errors None.
CDR_EXPORT std::vector<std::string> missingFeatures(const VkPhysicalDeviceFeatures2& features);

/// The same for Submission::gpuDriven alone.
/// @errors None.
CDR_EXPORT std::vector<std::string> missingGpuDrivenFeatures(const VkPhysicalDeviceFeatures2& features);

/// Whether VkPhysicalDeviceConditionalRenderingFeaturesEXT is in the chain, and its feature on.
/// @errors None.
CDR_EXPORT bool hasConditionalRendering(const VkPhysicalDeviceFeatures2& features);

} // namespace cdr::gpu
