#include "device_query.h"

#include <cdr/base/format_error.h>
#include <cdr/gpu/features.h>
#include <cdr/gpu/functions.h>
#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vk_mem_alloc.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>
#include <utility>

namespace cdr::gpu {

namespace {

/// Size of the memory blocks that small resources share; the first is an eighth of it. Large resources have
/// memory of their own (memory.cpp).
constexpr vk::DeviceSize kBlockBytes = vk::DeviceSize{32} << 20;

/// What each device draws without fullDrawIndexUint32.
constexpr std::uint32_t kSureIndex = (std::uint32_t{1} << 24u) - 1;

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::uint32_t chooseDevice(const std::vector<DeviceInfo>& infos, const std::string& choice) {
    if (infos.empty()) {
        throw base::RunError(
            "no Vulkan device found; install a driver, for a software one mesa-vulkan-drivers");
    }
    std::vector<std::string> refused;
    const DeviceInfo* best = nullptr;
    for (const DeviceInfo& info : infos) {
        if (!isChosen(info, choice)) {
            refused.push_back(fmt::format("{} {} (not the one asked for)", info.index, info.name));
        } else if (!info.missing.empty()) {
            refused.push_back(
                fmt::format("{} {} (lacks {})", info.index, info.name, fmt::join(info.missing, ", ")));
        } else if (best == nullptr || info.kind < best->kind) {
            best = &info;
        }
    }
    if (best == nullptr) {
        throw base::inputError("no usable Vulkan device{}: {}",
                               choice.empty() ? "" : fmt::format(" matches '{}'", choice.substr(0, 60)),
                               fmt::join(refused, "; "));
    }
    return best->index;
}

/// Those that cdr uses or has to.
std::vector<const char*> extensionsOf(vk::PhysicalDevice physical, const DeviceInfo& info) {
    std::vector<const char*> extensions = extensionsAskedFor(physical);
    if (info.hasConditionalRendering) {
        extensions.push_back(VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME);
    }
    return extensions;
}

vk::UniqueDevice makeDevice(const Instance& instance, vk::PhysicalDevice physical, std::uint32_t queueFamily,
                            const DeviceInfo& info) {
    constexpr float kPriority = 1.0f;
    const vk::DeviceQueueCreateInfo queue{
        .queueFamilyIndex = queueFamily, .queueCount = 1, .pQueuePriorities = &kPriority};
    const std::vector<const char*> extensions = extensionsOf(physical, info);
    vk::PhysicalDeviceConditionalRenderingFeaturesEXT conditional;
    vk::PhysicalDeviceVulkan13Features v13{.pNext = info.hasConditionalRendering ? &conditional : nullptr};
    vk::PhysicalDeviceVulkan12Features v12{.pNext = &v13,
                                           .shaderBufferInt64Atomics = info.hasInt64Atomics,
                                           // Not for cdr::render, but for who draws beside it.
                                           .separateDepthStencilLayouts = true};
    vk::PhysicalDeviceFeatures2 features{
        .pNext = &v12, .features = {.shaderFloat64 = info.hasFloat64, .shaderInt64 = info.hasInt64Atomics}};
    enableFeatures(instance.handle(), physical, features);
    return physical.createDeviceUnique(
        {.pNext = &features,
         .queueCreateInfoCount = 1,
         .pQueueCreateInfos = &queue,
         .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
         .ppEnabledExtensionNames = extensions.data()});
}

/// What can be asked of Vulkan, which does not say what a device was created with.
void requireSuitable(const BorrowedDevice& borrowed, const DeviceInfo& info) {
    if (!info.missing.empty()) {
        throw base::inputError("the borrowed device {} lacks {}", info.name, fmt::join(info.missing, ", "));
    }
    constexpr auto kNeeded = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    const auto families = vk::PhysicalDevice(borrowed.physical).getQueueFamilyProperties();
    if (borrowed.queueFamily >= families.size() ||
        (families[borrowed.queueFamily].queueFlags & kNeeded) != kNeeded) {
        throw base::inputError("the borrowed device {} has no queue family {} that does graphics and compute",
                               info.name, borrowed.queueFamily);
    }
}

void requireHandles(const BorrowedDevice& borrowed) {
    const std::array<std::pair<const char*, bool>, 4> handles{
        {{"VkInstance", borrowed.instance != VK_NULL_HANDLE},
         {"VkPhysicalDevice", borrowed.physical != VK_NULL_HANDLE},
         {"VkDevice", borrowed.device != VK_NULL_HANDLE},
         {"VkQueue", borrowed.queue != VK_NULL_HANDLE}}};
    for (const auto& [name, isThere] : handles) {
        if (!isThere) {
            throw base::inputError("the {} of a borrowed device is null", name);
        }
    }
}

} // namespace

bool isChosen(const DeviceInfo& info, const std::string& choice) {
    const bool isNumber =
        !choice.empty() && std::ranges::all_of(choice, [](unsigned char c) { return std::isdigit(c) != 0; });
    if (isNumber) {
        return std::to_string(info.index) == choice;
    }
    // Mesa's software device calls itself llvmpipe; people know the driver as lavapipe.
    const std::string wanted = lower(choice) == "lavapipe" ? "llvmpipe" : lower(choice);
    return lower(info.name).find(wanted) != std::string::npos;
}

struct Device::Handles {
    struct AllocatorDeleter {
        void operator()(VmaAllocator_T* allocator) const { vmaDestroyAllocator(allocator); }
    };

    vk::PhysicalDevice physical;
    vk::UniqueDevice owned; ///< empty when borrowed
    vk::Device device;
    std::uint32_t queueFamily = 0;
    vk::Queue queue;
    std::function<VkResult(const VkSubmitInfo2&, VkFence)> submit; ///< empty: to the queue itself
    DeviceInfo info;
    PFN_vkSetDebugUtilsObjectNameEXT setName = nullptr;
    PFN_vkCmdBeginDebugUtilsLabelEXT beginLabel = nullptr;
    PFN_vkCmdEndDebugUtilsLabelEXT endLabel = nullptr;
    std::unique_ptr<VmaAllocator_T, AllocatorDeleter> ownedAllocator; ///< empty when borrowed
    VmaAllocator_T* allocator = nullptr;
    vk::UniquePipelineCache ownedPipelineCache; ///< empty when borrowed
    vk::PipelineCache pipelineCache;
    PipelineObjects pipelineObjects;
};

bool isDeviceLost(const std::exception& error) {
    const auto* system = dynamic_cast<const std::system_error*>(&error);
    // By name: each shared library and program has a category of its own.
    return system != nullptr && system->code().value() == VK_ERROR_DEVICE_LOST &&
           system->code().category().name() == std::string_view(vk::errorCategory().name());
}

Device::~Device() = default;
Device::Device(Device&&) noexcept = default;
Device& Device::operator=(Device&&) noexcept = default;

VkDevice Device::handle() const {
    return m_handles->device;
}

VkPhysicalDevice Device::physical() const {
    return m_handles->physical;
}

VkQueue Device::queue() const {
    return m_handles->queue;
}

std::uint32_t Device::queueFamily() const {
    return m_handles->queueFamily;
}

void Device::submit(const VkSubmitInfo2& submission, VkFence done) const {
    const VkResult result = m_handles->submit
                                ? m_handles->submit(submission, done)
                                : functions().vkQueueSubmit2(m_handles->queue, 1, &submission, done);
    vk::resultCheck(static_cast<vk::Result>(result), "vkQueueSubmit2");
}

bool Device::isQueueShared() const {
    return m_handles->submit != nullptr;
}

VmaAllocator_T* Device::allocator() const {
    return m_handles->allocator;
}

VkPipelineCache Device::pipelineCache() const {
    return m_handles->pipelineCache;
}

PipelineObjects& pipelineObjects(const Device& device) {
    return device.m_handles->pipelineObjects;
}

const DeviceInfo& Device::info() const {
    return m_handles->info;
}

Device::Device(const Instance& instance, const std::string& choice) : m_handles(std::make_unique<Handles>()) {
    const std::uint32_t index = chooseDevice(listDevices(instance), choice);
    m_handles->physical = vk::Instance(instance.handle()).enumeratePhysicalDevices()[index];
    m_handles->info = describe(m_handles->physical, index);
    m_handles->queueFamily = findQueueFamily(m_handles->physical).value();
    m_handles->owned = makeDevice(instance, m_handles->physical, m_handles->queueFamily, m_handles->info);
    m_handles->device = *m_handles->owned;
    m_handles->queue = m_handles->device.getQueue(m_handles->queueFamily, 0);
    if (instance.hasDebugNames()) {
        loadDebugNames();
    }
    finish(instance.handle());
}

Device::Device(const BorrowedDevice& borrowed) : m_handles(std::make_unique<Handles>()) {
    requireHandles(borrowed);
    loadFunctions(borrowed.loader, borrowed.instance);
    m_handles->physical = borrowed.physical;
    m_handles->device = borrowed.device;
    m_handles->queueFamily = borrowed.queueFamily;
    m_handles->queue = borrowed.queue;
    m_handles->submit = borrowed.submit;
    m_handles->allocator = borrowed.allocator;
    m_handles->pipelineCache = borrowed.pipelineCache;
    DeviceInfo& info = m_handles->info = describe(borrowed.physical, 0);
    requireSuitable(borrowed, info);
    requireDeviceFunctions(borrowed.device);
    if (borrowed.features != nullptr) {
        if (const auto missing = missingFeatures(*borrowed.features); !missing.empty()) {
            throw base::inputError("the borrowed device {} was made without {}", info.name,
                                   fmt::join(missing, ", "));
        }
        if (info.gpuDrivenMissing.empty()) { // else it was never on
            info.gpuDrivenMissing = missingGpuDrivenFeatures(*borrowed.features);
        }
    } else if (!borrowed.hasGpuDrivenFeatures) {
        info.gpuDrivenMissing = {"features that the device's maker left off"};
    }
    const bool hasFragmentStores = borrowed.features != nullptr
                                       ? borrowed.features->features.fragmentStoresAndAtomics != 0
                                       : borrowed.hasFragmentStores;
    info.hasFragmentStores = info.hasFragmentStores && hasFragmentStores;
    const bool hasFloat64 = borrowed.features != nullptr ? borrowed.features->features.shaderFloat64 != 0
                                                         : borrowed.hasGpuDrivenFeatures;
    info.hasFloat64 = info.hasFloat64 && hasFloat64;
    if (info.deformMissing.empty() && !info.hasFloat64) {
        info.deformMissing = {"shaderFloat64"};
    }
    if (borrowed.features == nullptr || borrowed.features->features.fullDrawIndexUint32 == 0) {
        info.maxIndex = std::min(info.maxIndex, kSureIndex);
    }
    info.hasInt64Atomics = false;
    info.hasConditionalRendering = info.hasConditionalRendering && borrowed.features != nullptr &&
                                   hasConditionalRendering(*borrowed.features);
    if (borrowed.hasDebugNames) {
        loadDebugNames();
    }
    finish(borrowed.instance);
}

void Device::loadDebugNames() {
    m_handles->setName = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
        m_handles->device.getProcAddr("vkSetDebugUtilsObjectNameEXT"));
    m_handles->beginLabel = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(
        m_handles->device.getProcAddr("vkCmdBeginDebugUtilsLabelEXT"));
    m_handles->endLabel = reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(
        m_handles->device.getProcAddr("vkCmdEndDebugUtilsLabelEXT"));
}

void Device::finish(VkInstance instance) {
    if (!m_handles->pipelineCache) {
        m_handles->ownedPipelineCache = m_handles->device.createPipelineCacheUnique({});
        m_handles->pipelineCache = *m_handles->ownedPipelineCache;
    }
    if (m_handles->allocator != nullptr) {
        return;
    }
    VmaVulkanFunctions lookUp{};
    lookUp.vkGetInstanceProcAddr = functions().vkGetInstanceProcAddr;
    lookUp.vkGetDeviceProcAddr = functions().vkGetDeviceProcAddr;
    const VmaAllocatorCreateInfo info{.flags = 0,
                                      .physicalDevice = m_handles->physical,
                                      .device = m_handles->device,
                                      .preferredLargeHeapBlockSize = kBlockBytes,
                                      .pAllocationCallbacks = nullptr,
                                      .pDeviceMemoryCallbacks = nullptr,
                                      .pHeapSizeLimit = nullptr,
                                      .pVulkanFunctions = &lookUp,
                                      .instance = instance,
                                      .vulkanApiVersion = VK_API_VERSION_1_3,
                                      .pTypeExternalMemoryHandleTypes = nullptr};
    vk::resultCheck(static_cast<vk::Result>(vmaCreateAllocator(&info, &m_handles->allocator)),
                    "vmaCreateAllocator");
    m_handles->ownedAllocator.reset(m_handles->allocator);
}

VkFormat Device::depthFormat(depth::DepthFormat format) const {
    const auto found = findDepthFormat(m_handles->physical, format);
    if (!found) {
        throw base::inputError("{} has no {}-bit depth buffer; it has {}", m_handles->info.name,
                               traitsOf(format).bits,
                               fmt::join(depth::namesOf(m_handles->info.depthFormats), ", "));
    }
    return static_cast<VkFormat>(*found);
}

void Device::setObjectName(VkObjectType type, std::uint64_t handle, const std::string& name) const {
    if (m_handles->setName != nullptr) {
        const VkDebugUtilsObjectNameInfoEXT info{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                                                 .pNext = nullptr,
                                                 .objectType = type,
                                                 .objectHandle = handle,
                                                 .pObjectName = name.c_str()};
        vk::resultCheck(static_cast<vk::Result>(m_handles->setName(m_handles->device, &info)),
                        "vkSetDebugUtilsObjectNameEXT");
    }
}

void Device::beginLabel(VkCommandBuffer commands, const char* label) const {
    if (m_handles->beginLabel != nullptr) {
        const VkDebugUtilsLabelEXT info{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT,
                                        .pNext = nullptr,
                                        .pLabelName = label,
                                        .color = {}};
        m_handles->beginLabel(commands, &info);
    }
}

void Device::endLabel(VkCommandBuffer commands) const {
    if (m_handles->endLabel != nullptr) {
        m_handles->endLabel(commands);
    }
}

} // namespace cdr::gpu
