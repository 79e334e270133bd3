#include "depth_attachments.h"
#include "device_query.h"

#include <cdr/base/enum_names.h>
#include <cdr/gpu/features.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

namespace cdr::gpu {

namespace {

constexpr base::EnumNames<DeviceKind, kDeviceKinds.size()> kKindNames{
    "kind", {"discrete", "integrated", "virtual", "cpu", "other"}};

DeviceKind kindOf(vk::PhysicalDeviceType type) {
    switch (type) {
    case vk::PhysicalDeviceType::eCpu:
        return DeviceKind::cpu;
    case vk::PhysicalDeviceType::eIntegratedGpu:
        return DeviceKind::integrated;
    case vk::PhysicalDeviceType::eDiscreteGpu:
        return DeviceKind::discrete;
    case vk::PhysicalDeviceType::eVirtualGpu:
        return DeviceKind::virtualGpu;
    default:
        return DeviceKind::other;
    }
}

std::string versionText(std::uint32_t version) {
    return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                       VK_API_VERSION_PATCH(version));
}

std::vector<std::string> missingFrom(vk::PhysicalDevice physical, const VkPhysicalDeviceFeatures2& features,
                                     const vk::PhysicalDeviceVulkan13Features& v13) {
    if (!v13.dynamicRendering && !v13.synchronization2 && !v13.maintenance4) {
        // Vulkan 1.3 demands all three, but an instance of 1.0 is not told of them.
        return {"Vulkan 1.3, for which the instance must be made"};
    }
    std::vector<std::string> missing = missingFeatures(features);
    if (!findQueueFamily(physical)) {
        missing.emplace_back("a queue that does graphics and compute");
    }
    return missing;
}

/// What only culling and binning on the device needs.
std::vector<std::string> missingForGpuDriven(const VkPhysicalDeviceFeatures2& features,
                                             const std::vector<std::string>& missingRoundings,
                                             const vk::PhysicalDeviceLimits& limits) {
    std::vector<std::string> missing = missingGpuDrivenFeatures(features);
    missing.insert(missing.end(), missingRoundings.begin(), missingRoundings.end());
    if (limits.maxPerStageDescriptorStorageBuffers < kGpuDrivenStorageBuffers ||
        limits.maxComputeWorkGroupInvocations < kGpuDrivenInvocations ||
        limits.maxComputeWorkGroupSize[0] < kGpuDrivenInvocations) {
        missing.push_back(fmt::format("{} storage buffers and {} invocations a workgroup",
                                      kGpuDrivenStorageBuffers, kGpuDrivenInvocations));
    }
    return missing;
}

/// What a device of Vulkan 1.3 says of itself. Older ones do not know all of these structs.
void describeFurther(vk::PhysicalDevice physical, const vk::PhysicalDeviceLimits& limits, DeviceInfo& info) {
    using Properties11 = vk::PhysicalDeviceVulkan11Properties;
    using Properties12 = vk::PhysicalDeviceVulkan12Properties;
    using Properties13 = vk::PhysicalDeviceVulkan13Properties;
    using Features12 = vk::PhysicalDeviceVulkan12Features;
    using Features13 = vk::PhysicalDeviceVulkan13Features;
    const auto chain = physical.getFeatures2<vk::PhysicalDeviceFeatures2, Features12, Features13>();
    const auto told =
        physical.getProperties2<vk::PhysicalDeviceProperties2, Properties11, Properties12, Properties13>();
    const VkPhysicalDeviceFeatures2& features = chain.get<vk::PhysicalDeviceFeatures2>();
    const auto& v12 = told.get<Properties12>();
    const auto missingRoundings =
        thoseOff({{v12.shaderRoundingModeRTEFloat32, "shaderRoundingModeRTEFloat32"},
                  {v12.shaderRoundingModeRTEFloat64, "shaderRoundingModeRTEFloat64"}});
    info.missing = missingFrom(physical, features, chain.get<Features13>());
    info.gpuDrivenMissing = missingForGpuDriven(features, missingRoundings, limits);
    // Compute passes that deform compute in float64 as the CPU does, to the bit.
    info.deformMissing = thoseOff({{features.features.shaderFloat64, "shaderFloat64"}});
    info.deformMissing.insert(info.deformMissing.end(), missingRoundings.begin(), missingRoundings.end());
    // A buffer lies in one allocation.
    for (const std::uint64_t most :
         {told.get<Properties11>().maxMemoryAllocationSize, told.get<Properties13>().maxBufferSize}) {
        if (most != 0) {
            info.maxBufferBytes = std::min(info.maxBufferBytes, most);
        }
    }
    info.hasInt64Atomics =
        features.features.shaderInt64 != 0 && chain.get<Features12>().shaderBufferInt64Atomics != 0;
}

bool hasConditionalRendering(vk::PhysicalDevice physical) {
    return functions().vkCmdBeginConditionalRenderingEXT != nullptr &&
           hasExtension(physical, VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME) &&
           physical.getFeatures2<vk::PhysicalDeviceFeatures2,
                                 vk::PhysicalDeviceConditionalRenderingFeaturesEXT>()
                   .get<vk::PhysicalDeviceConditionalRenderingFeaturesEXT>()
                   .conditionalRendering != 0;
}

} // namespace

bool hasExtension(vk::PhysicalDevice physical, std::string_view name) {
    const auto extensions = physical.enumerateDeviceExtensionProperties();
    return std::ranges::any_of(extensions, [name](const vk::ExtensionProperties& extension) {
        return std::string_view(extension.extensionName.data()) == name;
    });
}

std::vector<const char*> extensionsAskedFor(vk::PhysicalDevice physical) {
    constexpr const char* kPortabilitySubset = "VK_KHR_portability_subset"; // its own macro is a beta one
    return hasExtension(physical, kPortabilitySubset) ? std::vector{kPortabilitySubset}
                                                      : std::vector<const char*>();
}

std::vector<std::string> thoseOff(std::initializer_list<std::pair<vk::Bool32, const char*>> features) {
    std::vector<std::string> off;
    for (const auto& [isOn, name] : features) {
        if (!isOn) {
            off.emplace_back(name);
        }
    }
    return off;
}

std::string_view nameOf(DeviceKind kind) {
    return kKindNames.nameOf(kind);
}

std::optional<std::uint32_t> findQueueFamily(vk::PhysicalDevice physical) {
    constexpr auto kNeeded = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    const auto families = physical.getQueueFamilyProperties();
    for (std::uint32_t i = 0; i < families.size(); ++i) {
        if ((families[i].queueFlags & kNeeded) == kNeeded) {
            return i;
        }
    }
    return std::nullopt;
}

std::optional<vk::Format> findDepthFormat(vk::PhysicalDevice physical, depth::DepthFormat format) {
    const DepthAttachments& formats = kDepthAttachments[static_cast<std::size_t>(format)];
    // The smaller one first, where a device has both.
    for (const vk::Format candidate : {formats.alone, formats.withStencil}) {
        if (physical.getFormatProperties(candidate).optimalTilingFeatures &
            vk::FormatFeatureFlagBits::eDepthStencilAttachment) {
            return candidate;
        }
    }
    return std::nullopt;
}

DeviceInfo describe(vk::PhysicalDevice physical, std::uint32_t index) {
    const auto properties =
        physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const auto& core = properties.get<vk::PhysicalDeviceProperties2>().properties;
    const auto& driver = properties.get<vk::PhysicalDeviceDriverProperties>();
    DeviceInfo info;
    info.name = core.deviceName.data();
    info.driver = fmt::format("{} {}", driver.driverName.data(), driver.driverInfo.data());
    info.api = versionText(core.apiVersion);
    info.kind = kindOf(core.deviceType);
    info.index = index;
    const vk::PhysicalDeviceFeatures features = physical.getFeatures();
    info.maxBufferBytes = std::numeric_limits<std::uint64_t>::max();
    if (core.apiVersion < VK_API_VERSION_1_3) {
        info.missing = info.gpuDrivenMissing = info.deformMissing = {"Vulkan 1.3"};
    } else {
        describeFurther(physical, core.limits, info);
    }
    std::copy_if(depth::kDepthFormats.begin(), depth::kDepthFormats.end(),
                 std::back_inserter(info.depthFormats),
                 [&](depth::DepthFormat format) { return findDepthFormat(physical, format).has_value(); });
    if (const auto family = findQueueFamily(physical)) {
        info.queues = physical.getQueueFamilyProperties()[*family].queueCount;
    }
    info.maxImageSide = std::min(
        {core.limits.maxImageDimension2D, core.limits.maxFramebufferWidth, core.limits.maxFramebufferHeight});
    info.maxStorageBufferBytes =
        std::min<std::uint64_t>(core.limits.maxStorageBufferRange, info.maxBufferBytes);
    info.maxIndex = core.limits.maxDrawIndexedIndexValue;
    info.subPixelBits = core.limits.subPixelPrecisionBits;
    info.hasFragmentStores = features.fragmentStoresAndAtomics != 0;
    info.hasFloat64 = features.shaderFloat64 != 0;
    info.hasConditionalRendering = hasConditionalRendering(physical);
    info.timestampPeriodNs = static_cast<double>(core.limits.timestampPeriod);
    return info;
}

std::vector<DeviceInfo> listDevices(const Instance& instance) {
    std::vector<DeviceInfo> infos;
    for (const vk::PhysicalDevice physical : vk::Instance(instance.handle()).enumeratePhysicalDevices()) {
        infos.push_back(describe(physical, static_cast<std::uint32_t>(infos.size())));
    }
    return infos;
}

} // namespace cdr::gpu
