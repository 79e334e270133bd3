#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>

struct VmaAllocation_T;

namespace cdr::gpu {

/// Where a buffer's memory is, and who reads and writes it.
enum class MemoryUse {
    deviceOnly, ///< written by transfers and shaders
    hostWrites, ///< mapped, written once and in order by the CPU, read by the device
    hostReads,  ///< mapped, cached, written by the device, read by the CPU
};

/// Frees a buffer or an image together with its memory.
struct AllocationDeleter {
    VmaAllocator_T* allocator = nullptr;
    VmaAllocation_T* allocation = nullptr;
    void operator()(VkBuffer buffer) const;
    void operator()(VkImage image) const;
};

/// A buffer and its memory, freed together. Empty when default-made.
class Buffer {
  public:
    Buffer() = default;
    /// @throws base::RunError with both figures where the device has no buffers of that size.
    Buffer(const Device& device, std::size_t bytes, vk::BufferUsageFlags usage, MemoryUse use,
           const std::string& name);

    vk::Buffer handle() const { return m_buffer.get(); }
    std::size_t size() const { return m_bytes; }
    /// Start of the mapping; null for MemoryUse::deviceOnly.
    void* mapped() const { return m_mapped; }
    /// The mapping as values; the buffer must hold `count` of them.
    template <typename T>
    std::span<T> as(std::size_t count) const {
        return {static_cast<T*>(m_mapped), count};
    }
    /// flush() makes the CPU's writes visible to the device, invalidate() device writes to the CPU, where memory
    /// is not coherent.
    void flush() const;
    void invalidate() const;

  private:
    std::unique_ptr<VkBuffer_T, AllocationDeleter> m_buffer;
    void* m_mapped = nullptr;
    std::size_t m_bytes = 0;
};

struct ImageOptions {
    vk::Extent2D extent;
    vk::Format format = vk::Format::eUndefined;
    vk::ImageUsageFlags usage;
    vk::ImageAspectFlags aspect = vk::ImageAspectFlagBits::eColor;
    std::uint32_t levels = 1; ///< each the smallerLevel() of the one before
};

/// Half as wide and high, rounded down, but at least 1.
vk::Extent2D smallerLevel(vk::Extent2D extent);

/// A 2D image, its memory and its view, freed together. Empty when default-made.
class Image {
  public:
    Image() = default;
    Image(const Device& device, const ImageOptions& options, const std::string& name);

    vk::Image handle() const { return m_image.get(); }
    vk::ImageView view() const { return *m_view; }
    const ImageOptions& options() const { return m_options; }
    vk::ImageSubresourceRange range() const { return {m_options.aspect, 0, m_options.levels, 0, 1}; }

  private:
    ImageOptions m_options;
    std::unique_ptr<VkImage_T, AllocationDeleter> m_image;
    vk::UniqueImageView m_view;
};

/// Device bytes of an image, by the driver, which is asked without making it.
std::uint64_t predictBytes(const Device& device, const ImageOptions& options);

/// Whether buffers of this use find no other memory than device-local, as where all memory is the host's too.
bool takesDeviceBytes(const Device& device, MemoryUse use);

/// Device-local bytes that are still free, as the device's allocator estimates them. Where that asks for no budget, what other
/// processes hold does not count.
std::uint64_t freeDeviceBytes(const Device& device);

/// Device-local bytes of all buffers and images that the device's allocator holds now, each as large as the driver made it.
/// Counts what others made where the allocator is lent (BorrowedDevice::allocator). What a graphics card keeps in the host's
/// memory, such as what is read back, is not counted.
std::uint64_t allocatedDeviceBytes(const Device& device);

/// base::RunError with both figures when `bytes` for `what` exceed what is free. Call before allocating.
void requireDeviceBytes(const Device& device, std::uint64_t bytes, const std::string& what);

/// Records that are to be held, and how many there may be.
struct Records {
    std::uint64_t count = 0;
    std::uint64_t bytes = 1;                                        ///< of each
    std::uint64_t most = std::numeric_limits<std::uint64_t>::max(); ///< that there is ever room for
};

/// For how many records to make room: for half as many again, so that what grows need not be made again each time, or for `count`
/// alone where the device has less memory free. Call before allocating.
/// base::RunError as requireDeviceBytes() where that does not suffice, unless such buffers find other memory.
std::uint64_t roomToGrow(const Device& device, const Records& records, MemoryUse use,
                         const std::string& what);

/// Makes a buffer that the host writes again where it has no room for `count` records. It holds nothing then.
/// @param what the records are of, in the plural. base::RunError names it where memory is missing.
void growRecords(const Device& device, Buffer& records, std::size_t count, std::size_t recordBytes,
                 const std::string& what,
                 vk::BufferUsageFlagBits usage = vk::BufferUsageFlagBits::eVertexBuffer);

} // namespace cdr::gpu
