#pragma once

#include <cdr/base/export.h>
#include <cdr/depth/format.h>
#include <cdr/gpu/instance.h>

#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct VmaAllocator_T;

/// Vulkan instances and devices, made or lent.
/// @threads Functions may be called by many threads at once, each with structs of its own.
namespace cdr::gpu {

struct PipelineObjects;

/// What a device runs on, the preferred kind first.
enum class DeviceKind : std::uint8_t {
    discrete,   ///< a graphics card
    integrated, ///< a graphics processor that shares main memory
    virtualGpu, ///< one that a virtual machine is lent
    cpu,        ///< a software driver
    other,      ///< what the driver does not say
};

/// All of them.
inline constexpr std::array kDeviceKinds{DeviceKind::discrete, DeviceKind::integrated, DeviceKind::virtualGpu,
                                         DeviceKind::cpu, DeviceKind::other};

/// "discrete", "integrated", "virtual", "cpu" or "other".
/// @errors None.
/// @lifetime That of the program.
CDR_EXPORT std::string_view nameOf(DeviceKind kind);

/// What a device is, and whether cdr can use it.
struct DeviceInfo {
    std::string name;                             ///< as the driver gives it
    std::string driver;                           ///< driver name and its version text
    std::string api;                              ///< "1.3.230"
    DeviceKind kind = DeviceKind::other;          ///< that it is of
    std::uint32_t index = 0;                      ///< as --device takes it
    std::vector<std::string> missing;             ///< why cdr cannot use it; empty when it can
    std::vector<std::string> gpuDrivenMissing;    ///< why it cannot cull and bin; empty when it can
    std::vector<std::string> deformMissing;       ///< why it cannot deform meshes; empty when it can
    std::vector<depth::DepthFormat> depthFormats; ///< that it can draw to
    std::uint32_t queues = 0;                     ///< in the family cdr would use
    std::uint32_t maxImageSide = 0;               ///< pixels, of what is drawn to too
    std::uint64_t maxBufferBytes = 0;             ///< of one buffer
    std::uint64_t maxStorageBufferBytes = 0;      ///< that a shader can address in one buffer
    /// The last vertex of a mesh that draws can name (maxDrawIndexedIndexValue). Of a borrowed device that was made without
    /// fullDrawIndexUint32, at most 2^24 - 1.
    std::uint32_t maxIndex = 0;
    std::uint32_t subPixelBits = 0; ///< that vertices are rounded to at the coarsest (subPixelPrecisionBits)
    bool hasFragmentStores = false; ///< fragment shaders may write buffers (fragmentStoresAndAtomics)
    bool hasFloat64 = false;        ///< shaders may compute in float64 (shaderFloat64)
    /// Shaders may order 64-bit integers in buffers (shaderInt64, shaderBufferInt64Atomics). False of a borrowed device,
    /// since nothing that is drawn for a host needs it.
    bool hasInt64Atomics = false;
    /// Commands may depend on what the device wrote before (VK_EXT_conditional_rendering and its feature).
    bool hasConditionalRendering = false;
    double timestampPeriodNs = 0.0; ///< nanoseconds that one step of a timestamp counts
};

/// Every device of the instance, in the loader's order.
/// @throws std::system_error for Vulkan's errors.
CDR_EXPORT std::vector<DeviceInfo> listDevices(const Instance& instance);

/// Handles of a device that another program part created and owns.
///
/// The instance must have been made for Vulkan 1.3, and the device with the features that enableFeatures() turns on. The queue
/// must support graphics and compute. The owner destroys them after the gpu::Device that borrows them.
struct BorrowedDevice {
    VkInstance instance = VK_NULL_HANDLE;       ///< that the device is of
    VkPhysicalDevice physical = VK_NULL_HANDLE; ///< that the device is of
    VkDevice device = VK_NULL_HANDLE;           ///< to draw on
    VkQueue queue = VK_NULL_HANDLE;             ///< that frames are submitted to
    std::uint32_t queueFamily = 0;              ///< of `queue`
    /// The owner's vkGetInstanceProcAddr, by which cdr finds every function that it calls. Null: the system's loader, or the
    /// one that an earlier device brought. A process has one for all its devices.
    PFN_vkGetInstanceProcAddr loader = nullptr;
    bool hasDebugNames = false; ///< the instance has VK_EXT_debug_utils
    /// What the device was created with; read while the gpu::Device is made. A feature that cdr needs and this leaves off
    /// is refused. Null: only what `physical` lacks is, and the two below say what else is on. With
    /// VkPhysicalDeviceConditionalRenderingFeaturesEXT in the chain, its extension must be on too where the feature is.
    const VkPhysicalDeviceFeatures2* features = nullptr;
    /// shaderFloat64, multiDrawIndirect, drawIndirectFirstInstance and drawIndirectCount are on too.
    bool hasGpuDrivenFeatures = false;
    bool hasFragmentStores = false; ///< fragmentStoresAndAtomics is on too
    /// The owner's VmaAllocator of this device, which is then used and stays; null: one of its own is made. Made by the
    /// version of Vulkan Memory Allocator that cdr was built with, compiled with the same settings, and it must outlive the
    /// gpu::Device.
    VmaAllocator_T* allocator = nullptr;
    /// The owner's, which then also keeps what pipelines of cdr were compiled to; so the owner can store it for the next start.
    /// Null: one of its own is made. Not made with VK_PIPELINE_CACHE_CREATE_EXTERNALLY_SYNCHRONIZED_BIT, and it must outlive the
    /// gpu::Device.
    VkPipelineCache pipelineCache = VK_NULL_HANDLE;
    /// Takes the place of vkQueueSubmit2() on `queue`, for a queue that others submit to as well: it takes their lock. cdr calls
    /// nothing else that Vulkan wants this lock for.
    std::function<VkResult(const VkSubmitInfo2& submission, VkFence done)> submit{};
};

/// Whether the error says that the device was lost. What was made on the device is of no use then. Destroy its renderers and
/// GpuScenes, then the gpu::Device, and make all of them anew on another. Scenes and worlds stay as they are.
/// @errors None.
CDR_EXPORT bool isDeviceLost(const std::exception& error);

/// A logical device with one queue and a memory allocator. Frees what it created; what it borrowed stays. It must outlive
/// what is made on it, and its Instance must outlive it.
/// @threads Any number at once may call the functions that ask for a property. submit() belongs to one thread at a time. A
///          function that takes a handle or a command buffer belongs to the thread that owns that object.
/// @errors None but those that a function names.
/// @lifetime Handles, pointers and references are valid as long as the device; moving it takes them along.
class CDR_EXPORT Device {
  public:
    /// @param choice index ("0") or part of a name in any case. Empty takes the best usable device: discrete,
    ///        integrated, virtual, then CPU.
    /// @throws base::InputError that says of each device why it was refused, when none fits.
    /// @throws base::RunError when there is no device at all.
    /// @throws std::system_error for Vulkan's other errors.
    Device(const Instance& instance, const std::string& choice);
    /// Of handles that stay the caller's.
    /// @throws base::InputError for a null handle, and for a queue family that does not do graphics and compute.
    /// @throws base::InputError that names the features which the physical device lacks, or which BorrowedDevice::features
    ///         leaves off.
    /// @throws base::InputError for a loader that is not the one in use, or that does not know all of Vulkan 1.3.
    /// @throws base::InputError for an instance that was made for an earlier version than Vulkan 1.3.
    /// @throws base::RunError when there is no loader.
    /// @throws std::system_error for Vulkan's other errors.
    explicit Device(const BorrowedDevice& borrowed);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    /// What is moved from may only be destroyed or assigned to. What was made on it refers to it, and must be gone.
    Device(Device&&) noexcept;
    /// As the constructor that moves. What uses this device must be gone.
    Device& operator=(Device&&) noexcept;

    /// For calls beside cdr's.
    VkDevice handle() const;
    /// What the device was made of.
    VkPhysicalDevice physical() const;
    /// The one queue; submit() is how cdr reaches it.
    VkQueue queue() const;
    /// Of queue().
    std::uint32_t queueFamily() const;
    /// vkQueueSubmit2() on queue(), or what takes its place.
    /// @param done may be null.
    /// @throws std::system_error for Vulkan's errors, a lost device among them.
    void submit(const VkSubmitInfo2& submission, VkFence done) const;
    /// Whether others submit to queue() too: BorrowedDevice::submit is there, and holds the lock.
    bool isQueueShared() const;
    /// Of all memory that cdr takes; lent, or one of its own.
    VmaAllocator_T* allocator() const;
    /// What all pipelines of cdr are made with; lent, or one of its own.
    VkPipelineCache pipelineCache() const;
    /// What listDevices() says of it; of a borrowed device with index 0.
    const DeviceInfo& info() const;

    /// The Vulkan format of optimally tiled depth attachments for `format`.
    /// @throws base::InputError that names what the device has, when it lacks one.
    VkFormat depthFormat(depth::DepthFormat format) const;

    /// Names an object for captures and validation messages; does nothing without VK_EXT_debug_utils.
    /// @tparam Handle of vulkan.hpp
    /// @throws std::system_error when memory does not suffice.
    template <typename Handle>
    void setName(Handle handle, const std::string& name) const {
        setObjectName(static_cast<VkObjectType>(Handle::objectType),
                      reinterpret_cast<std::uint64_t>(typename Handle::CType(handle)), name);
    }
    /// Opens a labelled region in a command buffer, for captures.
    /// @param label is copied.
    void beginLabel(VkCommandBuffer commands, const char* label) const;
    /// Closes what beginLabel() opened.
    void endLabel(VkCommandBuffer commands) const;

  private:
    friend PipelineObjects& pipelineObjects(const Device& device);

    struct Handles;
    void loadDebugNames();
    void finish(VkInstance instance);
    void setObjectName(VkObjectType type, std::uint64_t handle, const std::string& name) const;

    std::unique_ptr<Handles> m_handles;
};

} // namespace cdr::gpu
