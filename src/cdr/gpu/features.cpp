#include "device_query.h"

#include <cdr/base/format_error.h>
#include <cdr/gpu/features.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace cdr::gpu {

namespace {

/// The struct of a pNext chain that has this type; null where there is none.
template <typename Struct>
const Struct* inChain(const VkPhysicalDeviceFeatures2& features) {
    for (auto* next = static_cast<const VkBaseInStructure*>(features.pNext); next != nullptr;
         next = next->pNext) {
        if (vk::StructureType(next->sType) == Struct::structureType) {
            return reinterpret_cast<const Struct*>(next);
        }
    }
    return nullptr;
}

template <typename Struct>
Struct* inChain(VkPhysicalDeviceFeatures2& features) {
    return const_cast<Struct*>(inChain<Struct>(std::as_const(features)));
}

/// Engines that came before Vulkan 1.3 may name its features one by one.
template <typename Core, typename Alone>
bool isOn(const VkPhysicalDeviceFeatures2& features, vk::Bool32 Core::*inCore, vk::Bool32 Alone::*inAlone) {
    const Core* core = inChain<Core>(features);
    const Alone* alone = inChain<Alone>(features);
    return (core != nullptr && core->*inCore != 0) || (alone != nullptr && alone->*inAlone != 0);
}

} // namespace

std::vector<std::string> missingFeatures(const VkPhysicalDeviceFeatures2& features) {
    const VkPhysicalDeviceFeatures& core = features.features;
    return thoseOff({{isOn(features, &vk::PhysicalDeviceVulkan13Features::dynamicRendering,
                           &vk::PhysicalDeviceDynamicRenderingFeatures::dynamicRendering),
                      "dynamicRendering"},
                     {isOn(features, &vk::PhysicalDeviceVulkan13Features::synchronization2,
                           &vk::PhysicalDeviceSynchronization2Features::synchronization2),
                      "synchronization2"},
                     {isOn(features, &vk::PhysicalDeviceVulkan12Features::timelineSemaphore,
                           &vk::PhysicalDeviceTimelineSemaphoreFeatures::timelineSemaphore),
                      "timelineSemaphore"},
                     {core.depthClamp, "depthClamp"},
                     {core.shaderClipDistance, "shaderClipDistance"}});
}

std::vector<std::string> missingGpuDrivenFeatures(const VkPhysicalDeviceFeatures2& features) {
    const VkPhysicalDeviceFeatures& core = features.features;
    const auto* v12 = inChain<vk::PhysicalDeviceVulkan12Features>(features);
    return thoseOff({{core.shaderFloat64, "shaderFloat64"},
                     {core.multiDrawIndirect, "multiDrawIndirect"},
                     {core.drawIndirectFirstInstance, "drawIndirectFirstInstance"},
                     {v12 != nullptr && v12->drawIndirectCount != 0, "drawIndirectCount"}});
}

bool hasConditionalRendering(const VkPhysicalDeviceFeatures2& features) {
    const auto* conditional = inChain<vk::PhysicalDeviceConditionalRenderingFeaturesEXT>(features);
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
    auto* v12 = inChain<vk::PhysicalDeviceVulkan12Features>(features);
    auto* v13 = inChain<vk::PhysicalDeviceVulkan13Features>(features);
    if (v12 == nullptr || v13 == nullptr) {
        throw base::inputError("the feature chain lacks VkPhysicalDeviceVulkan{}Features",
                               v12 == nullptr ? "12" : "13");
    }
    VkPhysicalDeviceFeatures& core = features.features;
    v13->dynamicRendering = VK_TRUE;
    v13->synchronization2 = VK_TRUE;
    v12->timelineSemaphore = VK_TRUE; // by which frames that a host records say that they are done
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
    auto* conditional = inChain<vk::PhysicalDeviceConditionalRenderingFeaturesEXT>(features);
    if (conditional != nullptr && info.hasConditionalRendering) {
        conditional->conditionalRendering = VK_TRUE;
    }
}

} // namespace cdr::gpu
