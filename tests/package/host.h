#pragma once

// What hosts of the package test share. A host that has Vulkan's functions from elsewhere includes their header before this one.
#include <cdr/gpu/features.h>
#include <cdr/render/renderer.h>

#include <cstdint>
#include <cstdio>
#include <stdexcept>

namespace host {

inline void check(VkResult result, const char* what) {
    if (result != VK_SUCCESS) {
        throw std::runtime_error(what);
    }
}

inline VkInstance makeInstance() {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    VkInstance instance = VK_NULL_HANDLE;
    check(vkCreateInstance(&info, nullptr, &instance), "vkCreateInstance");
    return instance;
}

/// The first will do.
inline VkPhysicalDevice firstDevice(VkInstance instance) {
    std::uint32_t count = 1;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    vkEnumeratePhysicalDevices(instance, &count, &physical);
    return physical;
}

/// The features of a device, one chain.
struct Features {
    VkPhysicalDeviceVulkan13Features v13{};
    VkPhysicalDeviceVulkan12Features v12{};
    VkPhysicalDeviceFeatures2 all{};

    Features() {
        v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
        v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
        v12.pNext = &v13;
        all.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
        all.pNext = &v12;
    }
    Features(const Features&) = delete;
    Features& operator=(const Features&) = delete;
};

inline VkDevice makeDevice(VkPhysicalDevice physical, const Features& features) {
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1; // of family 0, which does graphics and compute on the devices that this is run on
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &features.all;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    VkDevice device = VK_NULL_HANDLE;
    check(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
    return device;
}

/// Draws a box, prints what is seen of it, and calls `meanwhile` while all that it takes is there.
template <typename Call>
void drawOneBox(const cdr::gpu::Device& device, Call meanwhile) {
    cdr::scene::Scene scene;
    scene.meshes.push_back(cdr::scene::makeBox(glm::vec3(1.0f)));
    scene.materials.push_back({.name = "white"});
    cdr::scene::addInstance(scene, 0, 0, 41, {0.0, 0.0, -5.0}, glm::mat3(1.0f));
    const cdr::render::GpuScene onDevice(device, scene);
    cdr::render::Renderer renderer(
        device, scene, onDevice,
        {.width = 64, .height = 64, .technique = cdr::depth::parseTechnique("anchored")});
    const cdr::render::Frame frame = renderer.render(cdr::scene::Camera{});
    std::printf("id %u at %.6f\n", frame.id(32, 32), frame.distanceView(32, 32));
    meanwhile();
}

} // namespace host
