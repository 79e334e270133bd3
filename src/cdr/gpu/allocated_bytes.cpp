#include <cdr/gpu/allocated_bytes.h>

#include <vk_mem_alloc.h>

namespace cdr::gpu {

std::uint64_t allocatedDeviceBytes(const Device& device) {
    VmaTotalStatistics statistics{};
    vmaCalculateStatistics(device.allocator(), &statistics);
    const VkPhysicalDeviceMemoryProperties* memory = nullptr;
    vmaGetMemoryProperties(device.allocator(), &memory);
    std::uint64_t bytes = 0;
    for (std::uint32_t heap = 0; heap < memory->memoryHeapCount; ++heap) {
        if (memory->memoryHeaps[heap].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) {
            bytes += statistics.memoryHeap[heap].statistics.allocationBytes;
        }
    }
    return bytes;
}

} // namespace cdr::gpu
