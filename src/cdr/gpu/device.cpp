#include "device_query.h"

#include <cdr/base/error.h>
#include <cdr/gpu/memory.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vk_mem_alloc.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace cdr::gpu {

namespace {

/// Size of the memory blocks that small resources share; the first is an eighth of it. Large resources have
/// memory of their own (memory.cpp).
constexpr vk::DeviceSize kBlockBytes = vk::DeviceSize{32} << 20;

constexpr const char* kPortabilitySubset = "VK_KHR_portability_subset"; // its own macro is a beta one

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Lower is better when the user has no preference.
int rankOf(const DeviceInfo& info) {
    constexpr std::array<std::string_view, 4> kOrder{"discrete", "integrated", "virtual", "cpu"};
    return static_cast<int>(std::find(kOrder.begin(), kOrder.end(), info.kind) - kOrder.begin());
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
        } else if (best == nullptr || rankOf(info) < rankOf(*best)) {
            best = &info;
        }
    }
    if (best == nullptr) {
        throw base::InputError(
            fmt::format("no usable Vulkan device{}: {}",
                        choice.empty() ? "" : fmt::format(" matches '{}'", choice.substr(0, 60)),
                        fmt::join(refused, "; ")));
    }
    return best->index;
}

/// Drivers that lack a part of Vulkan say so by this extension, and ask that it be enabled.
bool hasPortabilitySubset(vk::PhysicalDevice physical) {
    const auto extensions = physical.enumerateDeviceExtensionProperties();
    return std::any_of(extensions.begin(), extensions.end(), [](const vk::ExtensionProperties& extension) {
        return std::string_view(extension.extensionName.data()) == kPortabilitySubset;
    });
}

vk::UniqueDevice makeDevice(vk::PhysicalDevice physical, std::uint32_t queueFamily, const DeviceInfo& info) {
    const bool gpuDriven = info.gpuDrivenMissing.empty();
    constexpr float kPriority = 1.0f;
    const vk::DeviceQueueCreateInfo queue{
        .queueFamilyIndex = queueFamily, .queueCount = 1, .pQueuePriorities = &kPriority};
    vk::PhysicalDeviceVulkan13Features v13{.synchronization2 = true, .dynamicRendering = true};
    vk::PhysicalDeviceVulkan12Features v12{.pNext = &v13, .drawIndirectCount = gpuDriven};
    const vk::PhysicalDeviceFeatures2 features{
        .pNext = &v12,
        .features = {.multiDrawIndirect = gpuDriven,
                     .drawIndirectFirstInstance = gpuDriven,
                     .depthClamp = true,
                     .fragmentStoresAndAtomics = info.hasFragmentStores,
                     .shaderClipDistance = true,
                     .shaderFloat64 = gpuDriven}};
    return physical.createDeviceUnique({.pNext = &features,
                                        .queueCreateInfoCount = 1,
                                        .pQueueCreateInfos = &queue,
                                        .enabledExtensionCount = hasPortabilitySubset(physical) ? 1u : 0u,
                                        .ppEnabledExtensionNames = &kPortabilitySubset});
}

} // namespace

bool isChosen(const DeviceInfo& info, const std::string& choice) {
    const bool isNumber = !choice.empty() && std::all_of(choice.begin(), choice.end(), [](unsigned char c) {
        return std::isdigit(c) != 0;
    });
    if (isNumber) {
        return std::to_string(info.index) == choice;
    }
    // Mesa's software device calls itself llvmpipe; people know the driver as lavapipe.
    const std::string wanted = lower(choice) == "lavapipe" ? "llvmpipe" : lower(choice);
    return lower(info.name).find(wanted) != std::string::npos;
}

void Device::AllocatorDeleter::operator()(VmaAllocator_T* allocator) const {
    vmaDestroyAllocator(allocator);
}

Device::Device(const Instance& instance, const std::string& choice) {
    const std::uint32_t index = chooseDevice(listDevices(instance), choice);
    m_physical = instance.handle().enumeratePhysicalDevices()[index];
    m_info = describe(m_physical, index);
    m_queueFamily = findQueueFamily(m_physical).value();
    m_owned = makeDevice(m_physical, m_queueFamily, m_info);
    m_device = *m_owned;
    m_queue = m_device.getQueue(m_queueFamily, 0);
    finish(instance.handle(), instance.hasDebugNames());
}

Device::Device(const BorrowedDevice& borrowed)
    : m_physical(borrowed.physical),
      m_device(borrowed.device),
      m_queueFamily(borrowed.queueFamily),
      m_queue(borrowed.queue),
      m_info(describe(borrowed.physical, 0)) {
    if (!borrowed.hasGpuDrivenFeatures) {
        m_info.gpuDrivenMissing = {"features that the device's maker left off"};
    }
    m_info.hasFragmentStores = m_info.hasFragmentStores && borrowed.hasFragmentStores;
    finish(borrowed.instance, borrowed.hasDebugNames);
}

void Device::finish(vk::Instance instance, bool hasDebugNames) {
    if (hasDebugNames) {
        m_setName = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
            m_device.getProcAddr("vkSetDebugUtilsObjectNameEXT"));
        m_beginLabel = reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(
            m_device.getProcAddr("vkCmdBeginDebugUtilsLabelEXT"));
        m_endLabel = reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(
            m_device.getProcAddr("vkCmdEndDebugUtilsLabelEXT"));
    }
    const VmaAllocatorCreateInfo info{.flags = 0,
                                      .physicalDevice = m_physical,
                                      .device = m_device,
                                      .preferredLargeHeapBlockSize = kBlockBytes,
                                      .pAllocationCallbacks = nullptr,
                                      .pDeviceMemoryCallbacks = nullptr,
                                      .pHeapSizeLimit = nullptr,
                                      .pVulkanFunctions = nullptr,
                                      .instance = instance,
                                      .vulkanApiVersion = VK_API_VERSION_1_3,
                                      .pTypeExternalMemoryHandleTypes = nullptr};
    VmaAllocator allocator = nullptr;
    vk::resultCheck(static_cast<vk::Result>(vmaCreateAllocator(&info, &allocator)), "vmaCreateAllocator");
    m_allocator.reset(allocator);
    m_pipelineCache = m_device.createPipelineCacheUnique({});
}

vk::Format Device::depthFormat(depth::DepthFormat format) const {
    const auto found = findDepthFormat(m_physical, format);
    if (!found) {
        throw base::InputError(fmt::format("{} has no {}-bit depth buffer; it has {}", m_info.name,
                                           traitsOf(format).bits,
                                           fmt::join(depth::namesOf(m_info.depthFormats), ", ")));
    }
    return *found;
}

void Device::setObjectName(vk::ObjectType type, std::uint64_t handle, const std::string& name) const {
    if (m_setName != nullptr) {
        const VkDebugUtilsObjectNameInfoEXT info{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                                                 .pNext = nullptr,
                                                 .objectType = static_cast<VkObjectType>(type),
                                                 .objectHandle = handle,
                                                 .pObjectName = name.c_str()};
        vk::resultCheck(static_cast<vk::Result>(m_setName(m_device, &info)), "vkSetDebugUtilsObjectNameEXT");
    }
}

void Device::beginLabel(vk::CommandBuffer commands, const char* label) const {
    if (m_beginLabel != nullptr) {
        const VkDebugUtilsLabelEXT info{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT,
                                        .pNext = nullptr,
                                        .pLabelName = label,
                                        .color = {}};
        m_beginLabel(commands, &info);
    }
}

void Device::endLabel(vk::CommandBuffer commands) const {
    if (m_endLabel != nullptr) {
        m_endLabel(commands);
    }
}

} // namespace cdr::gpu
