#pragma once

#include <cdr/depth/format.h>
#include <cdr/gpu/instance.h>

#include <vulkan/vulkan.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

struct VmaAllocator_T;

namespace cdr::gpu {

/// What a device is, and whether cdr can use it.
struct DeviceInfo {
    std::string name;
    std::string driver;                           ///< driver name and its version text
    std::string api;                              ///< "1.3.230"
    std::string kind;                             ///< "cpu", "integrated", "discrete", "virtual" or "other"
    std::uint32_t index = 0;                      ///< as --device takes it
    std::vector<std::string> missing;             ///< why cdr cannot use it; empty when it can
    std::vector<std::string> gpuDrivenMissing;    ///< why it cannot cull and bin; empty when it can
    std::vector<depth::DepthFormat> depthFormats; ///< that it can draw to
    std::uint32_t queues = 0;                     ///< in the family cdr would use
    std::uint32_t maxImageSide = 0;
    std::uint64_t maxStorageBufferBytes = 0;
    std::uint32_t subPixelBits = 0; ///< that vertices are rounded to at the coarsest (subPixelPrecisionBits)
    bool hasFragmentStores = false; ///< fragment shaders may write buffers (fragmentStoresAndAtomics)
    double timestampPeriodNs = 0.0;
};

/// Every device of the instance, in the loader's order.
std::vector<DeviceInfo> listDevices(const Instance& instance);

/// Handles of a device that another program part created and owns.
///
/// It must have been created for Vulkan 1.3 with dynamicRendering, synchronization2, depthClamp and
/// shaderClipDistance on, and the queue must support graphics and compute. The owner destroys it after the
/// gpu::Device that borrows it.
struct BorrowedDevice {
    vk::Instance instance;
    vk::PhysicalDevice physical;
    vk::Device device;
    vk::Queue queue;
    std::uint32_t queueFamily = 0;
    bool hasDebugNames = false; ///< the instance has VK_EXT_debug_utils
    /// shaderFloat64, multiDrawIndirect, drawIndirectFirstInstance and drawIndirectCount are on too.
    bool hasGpuDrivenFeatures = false;
    bool hasFragmentStores = false; ///< fragmentStoresAndAtomics is on too
};

/// A logical device with one queue and a memory allocator. Frees what it created; what it borrowed stays.
class Device {
  public:
    /// @param choice index ("0") or part of a name in any case. Empty takes the best usable device: discrete,
    ///        integrated, virtual, then CPU.
    /// base::InputError, with each device and why it was refused, when none fits.
    Device(const Instance& instance, const std::string& choice);
    explicit Device(const BorrowedDevice& borrowed);

    vk::Device handle() const { return m_device; }
    vk::PhysicalDevice physical() const { return m_physical; }
    vk::Queue queue() const { return m_queue; }
    std::uint32_t queueFamily() const { return m_queueFamily; }
    VmaAllocator_T* allocator() const { return m_allocator.get(); }
    /// Pipelines that renderers of one device share are compiled once. Lives as long as the device.
    vk::PipelineCache pipelineCache() const { return *m_pipelineCache; }
    const DeviceInfo& info() const { return m_info; }

    /// The Vulkan format of optimally tiled depth attachments for `format`.
    /// base::InputError, naming what the device has, when it lacks one.
    vk::Format depthFormat(depth::DepthFormat format) const;

    /// Names an object for captures and validation messages; does nothing without VK_EXT_debug_utils.
    template <typename Handle>
    void setName(Handle handle, const std::string& name) const {
        setObjectName(Handle::objectType, reinterpret_cast<std::uint64_t>(typename Handle::CType(handle)),
                      name);
    }
    /// Opens and closes a labelled region in a command buffer, for captures.
    void beginLabel(vk::CommandBuffer commands, const char* label) const;
    void endLabel(vk::CommandBuffer commands) const;

  private:
    struct AllocatorDeleter {
        void operator()(VmaAllocator_T* allocator) const;
    };
    void finish(vk::Instance instance, bool hasDebugNames);
    void setObjectName(vk::ObjectType type, std::uint64_t handle, const std::string& name) const;

    vk::PhysicalDevice m_physical;
    vk::UniqueDevice m_owned; ///< empty when borrowed
    vk::Device m_device;
    std::uint32_t m_queueFamily = 0;
    vk::Queue m_queue;
    DeviceInfo m_info;
    PFN_vkSetDebugUtilsObjectNameEXT m_setName = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT m_beginLabel = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT m_endLabel = nullptr;
    std::unique_ptr<VmaAllocator_T, AllocatorDeleter> m_allocator;
    vk::UniquePipelineCache m_pipelineCache;
};

} // namespace cdr::gpu
