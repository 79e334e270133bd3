// cdr draws with memory of an allocator that the program made, and gives all of it back.
#include <cdr/gpu/features.h>
#include <cdr/render/renderer.h>

#include <vk_mem_alloc.h>

#include <cstdint>
#include <cstdio>
#include <stdexcept>

namespace {

void check(VkResult result, const char* what) {
    if (result != VK_SUCCESS) {
        throw std::runtime_error(what);
    }
}

VkInstance makeInstance() {
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

VkDevice makeDevice(VkPhysicalDevice physical, const VkPhysicalDeviceFeatures2& features) {
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1; // of family 0, which does graphics and compute on the devices that this is run on
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    VkDevice device = VK_NULL_HANDLE;
    check(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
    return device;
}

VmaAllocator makeAllocator(VkInstance instance, VkPhysicalDevice physical, VkDevice device) {
    VmaAllocatorCreateInfo info{};
    info.instance = instance;
    info.physicalDevice = physical;
    info.device = device;
    info.vulkanApiVersion = VK_API_VERSION_1_3;
    VmaAllocator allocator = nullptr;
    check(vmaCreateAllocator(&info, &allocator), "vmaCreateAllocator");
    return allocator;
}

unsigned allocationsOf(VmaAllocator allocator) {
    VmaTotalStatistics statistics{};
    vmaCalculateStatistics(allocator, &statistics);
    return statistics.total.statistics.allocationCount;
}

/// Draws a box, and prints what the allocator held meanwhile.
void drawOneBox(const cdr::gpu::Device& device, VmaAllocator allocator) {
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
    std::printf("from the host's allocator: %s\n", allocationsOf(allocator) > 10 ? "yes" : "no");
}

} // namespace

int main() try {
    const VkInstance instance = makeInstance();
    std::uint32_t count = 1;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    vkEnumeratePhysicalDevices(instance, &count, &physical); // the first will do
    VkPhysicalDeviceVulkan13Features v13{};
    v13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    VkPhysicalDeviceVulkan12Features v12{};
    v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    v12.pNext = &v13;
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &v12;
    cdr::gpu::enableFeatures(instance, physical, features);
    const VkDevice device = makeDevice(physical, features);
    const VmaAllocator allocator = makeAllocator(instance, physical, device);

    VkBufferCreateInfo bufferInfo{};
    bufferInfo.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    bufferInfo.size = 64;
    bufferInfo.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    VmaAllocationCreateInfo memory{};
    memory.usage = VMA_MEMORY_USAGE_AUTO;
    VkBuffer buffer = VK_NULL_HANDLE;
    VmaAllocation allocation = nullptr;
    check(vmaCreateBuffer(allocator, &bufferInfo, &memory, &buffer, &allocation, nullptr), "vmaCreateBuffer");

    cdr::gpu::BorrowedDevice borrowed{.instance = instance,
                                      .physical = physical,
                                      .device = device,
                                      .features = &features,
                                      .allocator = allocator};
    vkGetDeviceQueue(device, 0, 0, &borrowed.queue);
    drawOneBox(cdr::gpu::Device(borrowed), allocator);
    std::printf("left: %u, the host's own\n", allocationsOf(allocator));

    vmaDestroyBuffer(allocator, buffer, allocation);
    vmaDestroyAllocator(allocator); // asserts that nothing is left
    vkDestroyDevice(device, nullptr);
    vkDestroyInstance(instance, nullptr);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
