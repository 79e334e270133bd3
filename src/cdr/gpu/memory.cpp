#include <cdr/base/format_error.h>
#include <cdr/gpu/memory.h>

#include <fmt/format.h>
#include <vk_mem_alloc.h>
#include <vulkan/vulkan_format_traits.hpp>

#include <algorithm>
#include <array>

namespace cdr::gpu {

namespace {

void check(VkResult result, const char* call, const std::string& name, std::uint64_t bytes) {
    if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY) {
        throw base::runError("{}: out of memory for {} ({} bytes)", call, name, bytes);
    }
    vk::resultCheck(static_cast<vk::Result>(result), call);
}

/// Buffers of this size or more have memory of their own, as have all images except textures. They are made
/// again when the picture's size changes, and their memory is then freed, which a shared block would not be.
constexpr std::size_t kOwnMemoryBytes = std::size_t{256} << 10;
constexpr vk::ImageUsageFlags kTexture =
    vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst;

VmaAllocationCreateFlags hostAccess(MemoryUse use) {
    switch (use) {
    case MemoryUse::hostWrites:
        return VMA_ALLOCATION_CREATE_MAPPED_BIT | VMA_ALLOCATION_CREATE_HOST_ACCESS_SEQUENTIAL_WRITE_BIT;
    case MemoryUse::hostReads:
        return VMA_ALLOCATION_CREATE_MAPPED_BIT | VMA_ALLOCATION_CREATE_HOST_ACCESS_RANDOM_BIT;
    default:
        return 0;
    }
}

/// Whether what is made lies in memory with others.
enum class MemoryBlock : std::uint8_t { shared, own };

VmaAllocationCreateInfo allocationInfo(MemoryUse use, MemoryBlock block) {
    VmaAllocationCreateInfo info{};
    info.usage = VMA_MEMORY_USAGE_AUTO;
    info.flags = hostAccess(use);
    if (block == MemoryBlock::own) {
        info.flags |= VMA_ALLOCATION_CREATE_DEDICATED_MEMORY_BIT;
    }
    return info;
}

vk::ImageCreateInfo createInfo(const ImageOptions& options) {
    return {.imageType = vk::ImageType::e2D,
            .format = options.format,
            .extent = {options.extent.width, options.extent.height, 1},
            .mipLevels = options.levels,
            .arrayLayers = 1,
            .usage = options.usage};
}

std::uint64_t bytesOfPixels(const ImageOptions& options) {
    vk::Extent2D extent = options.extent;
    std::uint64_t pixels = 0;
    for (std::uint32_t level = 0; level < options.levels; ++level) {
        pixels += std::uint64_t{extent.width} * extent.height;
        extent = smallerLevel(extent);
    }
    return pixels * vk::blockSize(options.format);
}

const VkPhysicalDeviceMemoryProperties& memoryOf(const Device& device) {
    const VkPhysicalDeviceMemoryProperties* memory = nullptr;
    vmaGetMemoryProperties(device.allocator(), &memory);
    return *memory;
}

/// Visits the index of each heap that is device-local.
template <typename Visit>
void forEachDeviceHeap(const Device& device, const Visit& visit) {
    const VkPhysicalDeviceMemoryProperties& memory = memoryOf(device);
    for (std::uint32_t heap = 0; heap < memory.memoryHeapCount; ++heap) {
        if (memory.memoryHeaps[heap].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) {
            visit(heap);
        }
    }
}

} // namespace

vk::Extent2D smallerLevel(vk::Extent2D extent) {
    return vk::Extent2D{.width = std::max(extent.width / 2, 1u), .height = std::max(extent.height / 2, 1u)};
}

void AllocationDeleter::operator()(VkBuffer buffer) const {
    vmaDestroyBuffer(allocator, buffer, allocation);
}

void AllocationDeleter::operator()(VkImage image) const {
    vmaDestroyImage(allocator, image, allocation);
}

Buffer::Buffer(const Device& device, std::size_t bytes, vk::BufferUsageFlags usage, MemoryUse use,
               const std::string& name)
    : m_bytes(bytes) {
    if (bytes > device.info().maxBufferBytes) {
        throw base::runError("{}: {} bytes, where {} has buffers of at most {}", name, bytes,
                             device.info().name, device.info().maxBufferBytes);
    }
    // Vulkan has no buffers of no bytes; an empty scene still gets its buffers.
    const vk::BufferCreateInfo bufferInfo{.size = std::max<std::size_t>(bytes, 4), .usage = usage};
    const VmaAllocationCreateInfo memory =
        allocationInfo(use, bytes >= kOwnMemoryBytes ? MemoryBlock::own : MemoryBlock::shared);
    VkBuffer buffer = VK_NULL_HANDLE;
    VmaAllocation allocation = nullptr;
    VmaAllocationInfo info{};
    check(vmaCreateBuffer(device.allocator(), &static_cast<const VkBufferCreateInfo&>(bufferInfo), &memory,
                          &buffer, &allocation, &info),
          "vmaCreateBuffer", name, bytes);
    m_buffer = {buffer, AllocationDeleter{device.allocator(), allocation}};
    m_mapped = info.pMappedData;
    device.setName(handle(), name);
}

void Buffer::flush() const {
    check(vmaFlushAllocation(m_buffer.get_deleter().allocator, m_buffer.get_deleter().allocation, 0,
                             VK_WHOLE_SIZE),
          "vmaFlushAllocation", "a buffer", m_bytes);
}

void Buffer::invalidate() const {
    check(vmaInvalidateAllocation(m_buffer.get_deleter().allocator, m_buffer.get_deleter().allocation, 0,
                                  VK_WHOLE_SIZE),
          "vmaInvalidateAllocation", "a buffer", m_bytes);
}

Image::Image(const Device& device, const ImageOptions& options, const std::string& name)
    : m_options(options) {
    const std::uint32_t most = device.info().maxImageSide;
    if (std::max(options.extent.width, options.extent.height) > most) {
        throw base::inputError("{}: {}x{} pixels, where {} has images of at most {} a side", name,
                               options.extent.width, options.extent.height, device.info().name, most);
    }
    const vk::ImageCreateInfo imageInfo = createInfo(options);
    const std::uint64_t bytes = bytesOfPixels(options);
    const MemoryBlock block = options.usage & ~kTexture ? MemoryBlock::own : MemoryBlock::shared;
    const VmaAllocationCreateInfo memory = allocationInfo(MemoryUse::deviceOnly, block);
    VkImage image = VK_NULL_HANDLE;
    VmaAllocation allocation = nullptr;
    check(vmaCreateImage(device.allocator(), &static_cast<const VkImageCreateInfo&>(imageInfo), &memory,
                         &image, &allocation, nullptr),
          "vmaCreateImage", name, bytes);
    m_image = {image, AllocationDeleter{device.allocator(), allocation}};
    m_view = vk::Device(device.handle())
                 .createImageViewUnique({.image = image,
                                         .viewType = vk::ImageViewType::e2D,
                                         .format = options.format,
                                         .subresourceRange = range()});
    device.setName(handle(), name);
    device.setName(*m_view, name + " view");
}

std::uint64_t predictBytes(const Device& device, const ImageOptions& options) {
    const vk::ImageCreateInfo info = createInfo(options);
    const vk::MemoryRequirements2 needed =
        vk::Device(device.handle())
            .getImageMemoryRequirements(vk::DeviceImageMemoryRequirements{.pCreateInfo = &info});
    // lavapipe says 0 for an image that it could not make.
    return std::max<std::uint64_t>(needed.memoryRequirements.size, bytesOfPixels(options));
}

bool takesDeviceBytes(const Device& device, MemoryUse use) {
    const vk::BufferCreateInfo buffer{.size = kOwnMemoryBytes,
                                      .usage = vk::BufferUsageFlagBits::eTransferDst};
    const VmaAllocationCreateInfo memory = allocationInfo(use, MemoryBlock::shared);
    std::uint32_t type = 0;
    check(vmaFindMemoryTypeIndexForBufferInfo(
              device.allocator(), &static_cast<const VkBufferCreateInfo&>(buffer), &memory, &type),
          "vmaFindMemoryTypeIndexForBufferInfo", "a buffer", kOwnMemoryBytes);
    const VkPhysicalDeviceMemoryProperties& all = memoryOf(device);
    return (all.memoryHeaps[all.memoryTypes[type].heapIndex].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0;
}

std::uint64_t freeDeviceBytes(const Device& device) {
    std::array<VmaBudget, VK_MAX_MEMORY_HEAPS> budgets{};
    vmaGetHeapBudgets(device.allocator(), budgets.data());
    std::uint64_t most = 0;
    forEachDeviceHeap(device, [&](std::uint32_t heap) {
        const VmaBudget& budget = budgets[heap];
        most = std::max<std::uint64_t>(most, budget.budget - std::min(budget.usage, budget.budget));
    });
    return most;
}

std::uint64_t allocatedDeviceBytes(const Device& device) {
    VmaTotalStatistics statistics{};
    vmaCalculateStatistics(device.allocator(), &statistics);
    std::uint64_t bytes = 0;
    forEachDeviceHeap(
        device, [&](std::uint32_t heap) { bytes += statistics.memoryHeap[heap].statistics.allocationBytes; });
    return bytes;
}

void requireDeviceBytes(const Device& device, std::uint64_t bytes, const std::string& what) {
    const std::uint64_t available = freeDeviceBytes(device);
    if (bytes > available) {
        throw base::runError("{} needs {:.1f} MiB of device memory, {:.1f} MiB are free on {}", what,
                             static_cast<double>(bytes) / 0x1p20, static_cast<double>(available) / 0x1p20,
                             device.info().name);
    }
}

std::uint64_t roomToGrow(const Device& device, const Records& records, MemoryUse use,
                         const std::string& what) {
    constexpr std::uint64_t kFew = 64; // which cost nothing
    const std::uint64_t wanted = std::max(records.count + records.count / 2, kFew);
    const std::uint64_t room = std::max(records.count, std::min(wanted, records.most));
    if (room * records.bytes <= freeDeviceBytes(device)) {
        return room;
    }
    if (takesDeviceBytes(device, use)) {
        requireDeviceBytes(device, records.count * records.bytes, what);
    }
    return records.count;
}

void growRecords(const Device& device, Buffer& records, std::size_t count, std::size_t recordBytes,
                 const std::string& what, vk::BufferUsageFlagBits usage) {
    if (records.size() > 0 && count <= records.size() / recordBytes) {
        return;
    }
    const Records held{.count = std::max<std::size_t>(count, 1),
                       .bytes = recordBytes,
                       .most = device.info().maxBufferBytes / recordBytes};
    const std::uint64_t room =
        roomToGrow(device, held, MemoryUse::hostWrites, fmt::format("the records of {} {}", count, what));
    records = Buffer(device, room * recordBytes, usage, MemoryUse::hostWrites, what);
}

} // namespace cdr::gpu
