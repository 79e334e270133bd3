// cdr draws with memory of an allocator that the program made, and gives all of it back.
#include "../host.h"

#include <vk_mem_alloc.h>
#include <vulkan/vulkan.h>

#include <cstdio>

namespace {

VmaAllocator makeAllocator(VkInstance instance, VkPhysicalDevice physical, VkDevice device) {
    VmaAllocatorCreateInfo info{};
    info.instance = instance;
    info.physicalDevice = physical;
    info.device = device;
    info.vulkanApiVersion = VK_API_VERSION_1_3;
    VmaAllocator allocator = nullptr;
    host::check(vmaCreateAllocator(&info, &allocator), "vmaCreateAllocator");
    return allocator;
}

unsigned allocationsOf(VmaAllocator allocator) {
    VmaTotalStatistics statistics{};
    vmaCalculateStatistics(allocator, &statistics);
    return statistics.total.statistics.allocationCount;
}

} // namespace

int main() try {
    const VkInstance instance = host::makeInstance();
    const VkPhysicalDevice physical = host::firstDevice(instance);
    host::Features features;
    cdr::gpu::enableFeatures(instance, physical, features.all);
    const VkDevice device = host::makeDevice(physical, features);
    const VmaAllocator allocator = makeAllocator(instance, physical, device);

    VkBufferCreateInfo bufferInfo{};
    bufferInfo.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    bufferInfo.size = 64;
    bufferInfo.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    VmaAllocationCreateInfo memory{};
    memory.usage = VMA_MEMORY_USAGE_AUTO;
    VkBuffer buffer = VK_NULL_HANDLE;
    VmaAllocation allocation = nullptr;
    host::check(vmaCreateBuffer(allocator, &bufferInfo, &memory, &buffer, &allocation, nullptr),
                "vmaCreateBuffer");

    cdr::gpu::BorrowedDevice borrowed{.instance = instance,
                                      .physical = physical,
                                      .device = device,
                                      .features = &features.all,
                                      .allocator = allocator};
    vkGetDeviceQueue(device, 0, 0, &borrowed.queue);
    host::drawOneBox(cdr::gpu::Device(borrowed), [&] {
        std::printf("from the host's allocator: %s\n", allocationsOf(allocator) > 10 ? "yes" : "no");
    });
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
