#include <cdr/gpu/allocated_bytes.h>

#include <vk_mem_alloc.h>

namespace cdr::gpu {

std::uint64_t allocatedBytes(const Device& device) {
    VmaTotalStatistics statistics{};
    vmaCalculateStatistics(device.allocator(), &statistics);
    return statistics.total.statistics.allocationBytes;
}

} // namespace cdr::gpu
