#include "host_loader.h"

#include "../support/own_loader.h"

#include <cdr/gpu/vulkan_hpp.h>

#include <gtest/gtest.h>

#include <string_view>

namespace cdr::test {

namespace {

PFN_vkGetPhysicalDeviceFeatures2 realFeatures2 = nullptr;

void VKAPI_PTR withholdingFeatures2(VkPhysicalDevice physical, VkPhysicalDeviceFeatures2* features) {
    realFeatures2(physical, features);
    const auto turnOff = [](VkBool32& feature, std::string_view name) {
        for (const std::string& withheld : withheldFeatures()) {
            if (withheld == name) {
                feature = VK_FALSE;
            }
        }
    };
    turnOff(features->features.depthClamp, "depthClamp");
    turnOff(features->features.shaderClipDistance, "shaderClipDistance");
    for (auto* next = static_cast<VkBaseOutStructure*>(features->pNext); next != nullptr;
         next = next->pNext) {
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES) {
            auto* const v13 = reinterpret_cast<VkPhysicalDeviceVulkan13Features*>(next);
            turnOff(v13->dynamicRendering, "dynamicRendering");
            turnOff(v13->synchronization2, "synchronization2");
        }
    }
}

PFN_vkWaitForFences realWaitForFences = nullptr;
PFN_vkQueueWaitIdle realQueueWaitIdle = nullptr;

VkResult VKAPI_PTR failingWaitForFences(VkDevice device, std::uint32_t count, const VkFence* fences,
                                        VkBool32 all, std::uint64_t timeout) {
    if (waits().fencesToFail > 0) {
        --waits().fencesToFail;
        return VK_ERROR_OUT_OF_HOST_MEMORY;
    }
    return realWaitForFences(device, count, fences, all, timeout);
}

VkResult VKAPI_PTR countingQueueWaitIdle(VkQueue queue) {
    ++waits().idle;
    return realQueueWaitIdle(queue);
}

/// Keeps what was found, and gives what takes its place.
template <typename Function>
PFN_vkVoidFunction replaced(PFN_vkVoidFunction found, Function& kept, Function replacement) {
    kept = reinterpret_cast<Function>(found);
    return reinterpret_cast<PFN_vkVoidFunction>(replacement);
}

PFN_vkVoidFunction VKAPI_PTR hostsLoader(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction found = systemsLoader()(instance, name);
    const std::string_view asked(found != nullptr ? name : "");
    if (asked == "vkGetPhysicalDeviceFeatures2") {
        return replaced(found, realFeatures2, &withholdingFeatures2);
    }
    if (asked == "vkWaitForFences") {
        return replaced(found, realWaitForFences, &failingWaitForFences);
    }
    if (asked == "vkQueueWaitIdle") {
        return replaced(found, realQueueWaitIdle, &countingQueueWaitIdle);
    }
    return found;
}

const testing::Environment* const kBringLoader =
    testing::AddGlobalTestEnvironment(new OwnLoader(&hostsLoader));

} // namespace

std::vector<std::string>& withheldFeatures() {
    static std::vector<std::string> names;
    return names;
}

Waits& waits() {
    static Waits counted;
    return counted;
}

} // namespace cdr::test
