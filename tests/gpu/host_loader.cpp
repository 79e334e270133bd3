#include "host_loader.h"

#include "../support/own_loader.h"

#include <cdr/gpu/vulkan_hpp.h>

#include <gtest/gtest.h>

#include <string_view>
#include <utility>

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

PFN_vkVoidFunction VKAPI_PTR hostsLoader(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction found = systemsLoader()(instance, name);
    if (std::string_view(name) != "vkGetPhysicalDeviceFeatures2" || found == nullptr) {
        return found;
    }
    realFeatures2 = reinterpret_cast<PFN_vkGetPhysicalDeviceFeatures2>(found);
    return reinterpret_cast<PFN_vkVoidFunction>(&withholdingFeatures2);
}

const testing::Environment* const kBringLoader =
    testing::AddGlobalTestEnvironment(new OwnLoader(&hostsLoader));

} // namespace

std::vector<std::string>& withheldFeatures() {
    static std::vector<std::string> names;
    return names;
}

} // namespace cdr::test
