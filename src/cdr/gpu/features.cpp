#include "device_query.h"

#include <cdr/base/format_error.h>
#include <cdr/gpu/features.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cdr::gpu {

namespace {

/// The struct of a pNext chain that has this type; null where there is none.
template <typename Struct>
const Struct* inChain(const VkPhysicalDeviceFeatures2& features, VkStructureType type) {
    for (auto* next = static_cast<const VkBaseInStructure*>(features.pNext); next != nullptr;
         next = next->pNext) {
        if (next->sType == type) {
            return reinterpret_cast<const Struct*>(next);
        }
    }
    return nullptr;
}

const VkPhysicalDeviceVulkan12Features* vulkan12(const VkPhysicalDeviceFeatures2& features) {
    return inChain<VkPhysicalDeviceVulkan12Features>(features,
                                                     VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
}

const VkPhysicalDeviceVulkan13Features* vulkan13(const VkPhysicalDeviceFeatures2& features) {
    return inChain<VkPhysicalDeviceVulkan13Features>(features,
                                                     VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);
}

const VkPhysicalDeviceConditionalRenderingFeaturesEXT*
conditionalRendering(const VkPhysicalDeviceFeatures2& features) {
    return inChain<VkPhysicalDeviceConditionalRenderingFeaturesEXT>(
        features, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_CONDITIONAL_RENDERING_FEATURES_EXT);
}

/// Engines that came before Vulkan 1.3 may name its features one by one.
template <typename Core, typename Alone>
bool isOn(const Core* core, VkBool32 Core::*inCore, const Alone* alone, VkBool32 Alone::*inAlone) {
    return (core != nullptr && core->*inCore != 0) || (alone != nullptr && alone->*inAlone != 0);
}

bool hasDynamicRendering(const VkPhysicalDeviceFeatures2& features) {
    using Alone = VkPhysicalDeviceDynamicRenderingFeatures;
    return isOn(vulkan13(features), &VkPhysicalDeviceVulkan13Features::dynamicRendering,
                inChain<Alone>(features, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES),
                &Alone::dynamicRendering);
}

bool hasSynchronization2(const VkPhysicalDeviceFeatures2& features) {
    using Alone = VkPhysicalDeviceSynchronization2Features;
    return isOn(vulkan13(features), &VkPhysicalDeviceVulkan13Features::synchronization2,
                inChain<Alone>(features, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SYNCHRONIZATION_2_FEATURES),
                &Alone::synchronization2);
}

bool hasTimelineSemaphore(const VkPhysicalDeviceFeatures2& features) {
    using Alone = VkPhysicalDeviceTimelineSemaphoreFeatures;
    return isOn(vulkan12(features), &VkPhysicalDeviceVulkan12Features::timelineSemaphore,
                inChain<Alone>(features, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_TIMELINE_SEMAPHORE_FEATURES),
                &Alone::timelineSemaphore);
}

} // namespace

std::vector<std::string> missingFeatures(const VkPhysicalDeviceFeatures2& features) {
    const VkPhysicalDeviceFeatures& core = features.features;
    return thoseOff({{hasDynamicRendering(features), "dynamicRendering"},
                     {hasSynchronization2(features), "synchronization2"},
                     {hasTimelineSemaphore(features), "timelineSemaphore"},
                     {core.depthClamp, "depthClamp"},
                     {core.shaderClipDistance, "shaderClipDistance"}});
}

std::vector<std::string> missingGpuDrivenFeatures(const VkPhysicalDeviceFeatures2& features) {
    const VkPhysicalDeviceFeatures& core = features.features;
    const auto* v12 = vulkan12(features);
    return thoseOff({{core.shaderFloat64, "shaderFloat64"},
                     {core.multiDrawIndirect, "multiDrawIndirect"},
                     {core.drawIndirectFirstInstance, "drawIndirectFirstInstance"},
                     {v12 != nullptr && v12->drawIndirectCount != 0, "drawIndirectCount"}});
}

bool hasConditionalRendering(const VkPhysicalDeviceFeatures2& features) {
    const auto* conditional = conditionalRendering(features);
    return conditional != nullptr && conditional->conditionalRendering != 0;
}

void enableFeatures(VkInstance instance, VkPhysicalDevice physical, VkPhysicalDeviceFeatures2& features,
                    PFN_vkGetInstanceProcAddr loader) {
    if (instance == VK_NULL_HANDLE || physical == VK_NULL_HANDLE) {
        throw base::inputError("the {} whose features are to be enabled is null",
                               instance == VK_NULL_HANDLE ? "VkInstance" : "VkPhysicalDevice");
    }
    loadFunctions(loader, instance);
    const DeviceInfo info = describe(physical, 0);
    if (!info.missing.empty()) {
        throw base::inputError("{} lacks {}", info.name, fmt::join(info.missing, ", "));
    }
    auto* v12 = const_cast<VkPhysicalDeviceVulkan12Features*>(vulkan12(features));
    auto* v13 = const_cast<VkPhysicalDeviceVulkan13Features*>(vulkan13(features));
    if (v12 == nullptr || v13 == nullptr) {
        throw base::inputError("the feature chain lacks VkPhysicalDeviceVulkan{}Features",
                               v12 == nullptr ? "12" : "13");
    }
    VkPhysicalDeviceFeatures& core = features.features;
    v13->dynamicRendering = VK_TRUE;
    v13->synchronization2 = VK_TRUE;
    v12->separateDepthStencilLayouts = VK_TRUE; // each device of Vulkan 1.2 has it
    v12->timelineSemaphore = VK_TRUE;           // by which frames that a host records say that they are done
    core.depthClamp = VK_TRUE;
    core.shaderClipDistance = VK_TRUE;
    if (vk::PhysicalDevice(physical).getFeatures().fullDrawIndexUint32 != 0) {
        core.fullDrawIndexUint32 = VK_TRUE; // for meshes of more than 2^24 vertices
    }
    if (info.gpuDrivenMissing.empty()) {
        core.shaderFloat64 = VK_TRUE;
        core.multiDrawIndirect = VK_TRUE;
        core.drawIndirectFirstInstance = VK_TRUE;
        v12->drawIndirectCount = VK_TRUE;
    }
    if (info.deformMissing.empty()) {
        core.shaderFloat64 = VK_TRUE;
    }
    if (info.hasFragmentStores) {
        core.fragmentStoresAndAtomics = VK_TRUE;
    }
    auto* conditional =
        const_cast<VkPhysicalDeviceConditionalRenderingFeaturesEXT*>(conditionalRendering(features));
    if (conditional != nullptr && info.hasConditionalRendering) {
        conditional->conditionalRendering = VK_TRUE;
    }
}

} // namespace cdr::gpu
