// A Vulkan layer that makes one kind of call fail, to test what a program does then.
//
// The environment variable CDR_FAULT chooses it: "CALL DEVICE AFTER TIMES RESULT", for instance
// "vkQueueSubmit2 render 5 1 -4".
// - CALL is one of the functions below, or "each". Then the calls of all of them are counted together, except those that
//   cannot return RESULT by the specification.
// - DEVICE is "window" (devices with a swapchain), "render" (devices without) or "any".
// - Calls are counted over all such devices. The first AFTER succeed, the next TIMES return RESULT, a VkResult.
// - For vkGetPhysicalDeviceSurfaceCapabilitiesKHR by its name, RESULT replaces both sides of currentExtent; -1 is "any".
// - For vkGetPhysicalDeviceProperties2, RESULT replaces the type of the device.
// - Calls on the instance and its physical devices count as calls of "render", those on surfaces as calls of "window".
// - For vkCmdSetViewport, RESULT moves the viewport to the right, in 1/16 of a pixel: a driver that draws beside the place.
//
// A lost device stays lost, and so does the surface of the last swapchain.
//
// The environment variable CDR_FAULT_LOG names a file. When the process ends, the number of calls that were counted and the
// name of the first that failed are written to it.

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr const char* kSurfaceCapabilities = "vkGetPhysicalDeviceSurfaceCapabilitiesKHR";
constexpr const char* kCreateSwapchain = "vkCreateSwapchainKHR";
constexpr const char* kSetViewport = "vkCmdSetViewport";
constexpr const char* kProperties = "vkGetPhysicalDeviceProperties2";

/// Whether a function can return a result, by the specification. Those that wait, submit or read results tell of a lost
/// device; those do not run out of device memory that never take any.
bool canReturn(std::string_view name, long result) {
    constexpr std::array kOfLoss{
        "vkQueueSubmit",       "vkQueueSubmit2",        "vkQueueWaitIdle",   "vkDeviceWaitIdle",
        "vkWaitForFences",     "vkWaitSemaphores",      "vkGetFenceStatus",  "vkGetSemaphoreCounterValue",
        "vkCreateDevice",      "vkGetQueryPoolResults", "vkQueuePresentKHR", "vkAcquireNextImageKHR",
        "vkCreateSwapchainKHR"};
    constexpr std::array kOfHostAlone{"vkCreatePipelineCache"};
    constexpr std::array kOfDeviceAlone{"vkResetFences", "vkResetCommandPool"};
    const auto isIn = [&](const auto& names) { return std::ranges::find(names, name) != names.end(); };
    switch (result) {
    case VK_ERROR_DEVICE_LOST:
        return isIn(kOfLoss);
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return !isIn(kOfHostAlone);
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return !isIn(kOfDeviceAlone);
    default:
        return false;
    }
}

struct Fault {
    std::string call, device;
    long after = 0, times = 0, result = 0;
    std::atomic<long> calls{0};
    std::atomic<const char*> failed{nullptr};

    Fault() {
        const char* text = std::getenv("CDR_FAULT");
        std::istringstream(text != nullptr ? text : "") >> call >> device >> after >> times >> result;
    }
    ~Fault() {
        if (const char* log = std::getenv("CDR_FAULT_LOG")) {
            const char* first = failed;
            std::ofstream(log) << calls << ' ' << (first != nullptr ? first : "none") << '\n';
        }
    }
    Fault(const Fault&) = delete;
    Fault& operator=(const Fault&) = delete;

    /// Counts a call. True when it must fail.
    bool hits(const char* name, bool hasSwapchain) {
        const bool isMeant = call == name || (call == "each" && canReturn(name, result));
        if (!isMeant || (device != "any" && device != (hasSwapchain ? "window" : "render"))) {
            return false;
        }
        const long number = calls++;
        const bool isHit = number >= after && number - after < times;
        if (const char* none = nullptr; isHit) {
            failed.compare_exchange_strong(none, name);
        }
        return isHit;
    }
};

Fault& fault() {
    static Fault only;
    return only;
}

/// Makes a surface, whichever the window system is.
using CreateSurface = VkResult(VKAPI_PTR*)(VkInstance, const void*, const VkAllocationCallbacks*,
                                           VkSurfaceKHR*);

struct NextInstance {
    PFN_vkGetInstanceProcAddr get = nullptr;
    VkInstance handle = VK_NULL_HANDLE;
    /// Fetched while the instance is made: later the loader would return this layer's own functions.
    std::map<std::string_view, PFN_vkVoidFunction> functions;

    template <typename Function>
    Function call(const char* name) const {
        return reinterpret_cast<Function>(functions.at(name));
    }
};

struct NextDevice {
    PFN_vkGetDeviceProcAddr get = nullptr;
    VkDevice handle = VK_NULL_HANDLE;
    bool hasSwapchain = false;
    std::atomic<bool> isLost{false};

    template <typename Function>
    Function call(const char* name) const {
        return reinterpret_cast<Function>(get(handle, name));
    }
    /// What a call must return instead of being made; VK_SUCCESS when it is made.
    VkResult interfere(const char* name) {
        if (!isLost && fault().hits(name, hasSwapchain)) {
            const auto result = static_cast<VkResult>(fault().result);
            if (result != VK_ERROR_DEVICE_LOST) {
                return result;
            }
            // A lost device has stopped working. This one must stop too.
            call<PFN_vkDeviceWaitIdle>("vkDeviceWaitIdle")(handle);
            isLost = true;
        }
        return isLost && canReturn(name, VK_ERROR_DEVICE_LOST) ? VK_ERROR_DEVICE_LOST : VK_SUCCESS;
    }
};

std::mutex lock;
VkSurfaceKHR lastSurface = VK_NULL_HANDLE;            // of the last swapchain that was created
VkSurfaceKHR lostSurface = VK_NULL_HANDLE;            // no swapchain can be created for it any more
std::map<void*, NextInstance> instances;              // by dispatch table, which physical devices share
std::map<void*, std::shared_ptr<NextDevice>> devices; // and queues

void* tableOf(const void* handle) {
    void* table = nullptr;
    std::memcpy(&table, handle, sizeof(table));
    return table;
}

/// None for null, and for an instance that is being made.
std::optional<NextInstance> findInstance(VkInstance instance) {
    const std::lock_guard guard(lock);
    const auto found = instance != VK_NULL_HANDLE ? instances.find(tableOf(instance)) : instances.end();
    return found != instances.end() ? std::optional(found->second) : std::nullopt;
}

NextInstance instanceOf(const void* handle) {
    const std::lock_guard guard(lock);
    return instances.at(tableOf(handle));
}

std::shared_ptr<NextDevice> deviceOf(const void* handle) {
    const std::lock_guard guard(lock);
    return devices.at(tableOf(handle));
}

template <typename Link, typename Info>
Link* linkOf(const Info* info, VkStructureType type) {
    auto* link = static_cast<const Link*>(info->pNext);
    while (link != nullptr && (link->sType != type || link->function != VK_LAYER_LINK_INFO)) {
        link = static_cast<const Link*>(link->pNext);
    }
    return const_cast<Link*>(link);
}

constexpr std::array kOfInstances{kSurfaceCapabilities,
                                  kProperties,
                                  "vkDestroySurfaceKHR",
                                  "vkEnumeratePhysicalDevices",
                                  "vkEnumerateDeviceExtensionProperties",
                                  "vkGetPhysicalDeviceSurfaceFormatsKHR",
                                  "vkGetPhysicalDeviceSurfacePresentModesKHR",
                                  "vkGetPhysicalDeviceSurfaceSupportKHR",
                                  "vkCreateWaylandSurfaceKHR",
                                  "vkCreateXcbSurfaceKHR",
                                  "vkCreateXlibSurfaceKHR"};

/// This layer's function of a name; null where it has none.
PFN_vkVoidFunction own(const char* name);

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* callbacks, VkInstance* made) {
    if (fault().hits("vkCreateInstance", false)) {
        return static_cast<VkResult>(fault().result);
    }
    auto* link = linkOf<VkLayerInstanceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    const PFN_vkGetInstanceProcAddr get = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto next = reinterpret_cast<PFN_vkCreateInstance>(get(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = next(info, callbacks, made);
    if (result == VK_SUCCESS) {
        NextInstance instance{.get = get, .handle = *made, .functions = {}};
        for (const char* name : kOfInstances) {
            // A loader that lacks a function asks the topmost layer, which may be this one.
            const PFN_vkVoidFunction function = get(*made, name);
            instance.functions[name] = function != own(name) ? function : nullptr;
        }
        const std::lock_guard guard(lock);
        instances[tableOf(*made)] = instance;
    }
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* callbacks, VkDevice* made) {
    auto* link = linkOf<VkLayerDeviceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    const NextInstance instance = instanceOf(physical);
    if (fault().hits("vkCreateDevice", false)) {
        return static_cast<VkResult>(fault().result);
    }
    const PFN_vkGetDeviceProcAddr get = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    const PFN_vkGetInstanceProcAddr getAbove = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto next = reinterpret_cast<PFN_vkCreateDevice>(getAbove(instance.handle, "vkCreateDevice"));
    const VkResult result = next(physical, info, callbacks, made);
    if (result == VK_SUCCESS) {
        auto device = std::make_shared<NextDevice>();
        device->get = get;
        device->handle = *made;
        for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i) {
            device->hasSwapchain |=
                std::strcmp(info->ppEnabledExtensionNames[i], VK_KHR_SWAPCHAIN_EXTENSION_NAME) == 0;
        }
        const std::lock_guard guard(lock);
        devices[tableOf(*made)] = device;
    }
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL surfaceCapabilities(VkPhysicalDevice physical, VkSurfaceKHR surface,
                                                   VkSurfaceCapabilitiesKHR* capabilities) {
    const bool isHit = fault().hits(kSurfaceCapabilities, true);
    if (isHit && fault().call != kSurfaceCapabilities) {
        return static_cast<VkResult>(fault().result);
    }
    const auto next =
        instanceOf(physical).call<PFN_vkGetPhysicalDeviceSurfaceCapabilitiesKHR>(kSurfaceCapabilities);
    const VkResult result = next(physical, surface, capabilities);
    if (isHit) {
        const auto side = static_cast<std::uint32_t>(fault().result);
        capabilities->currentExtent = {side, side};
    }
    return result;
}

VKAPI_ATTR void VKAPI_CALL destroySurface(VkInstance instance, VkSurfaceKHR surface,
                                          const VkAllocationCallbacks* callbacks) {
    {
        const std::lock_guard guard(lock);
        lostSurface = surface == lostSurface ? VK_NULL_HANDLE : lostSurface; // a handle may be reused
    }
    instanceOf(instance).call<PFN_vkDestroySurfaceKHR>("vkDestroySurfaceKHR")(instance, surface, callbacks);
}

/// Remembers the surface of a swapchain that is created; false when the surface was lost.
bool hasSurface(const VkSwapchainCreateInfoKHR& info) {
    const std::lock_guard guard(lock);
    lastSurface = info.surface;
    return info.surface != lostSurface;
}

void loseSurface() {
    const std::lock_guard guard(lock);
    lostSurface = lastSurface;
}

VKAPI_ATTR VkResult VKAPI_CALL createSwapchain(VkDevice handle, const VkSwapchainCreateInfoKHR* info,
                                               const VkAllocationCallbacks* callbacks, VkSwapchainKHR* made) {
    const std::shared_ptr<NextDevice> device = deviceOf(handle);
    if (!hasSurface(*info)) {
        return VK_ERROR_SURFACE_LOST_KHR;
    }
    const VkResult result = device->interfere(kCreateSwapchain);
    if (result == VK_ERROR_SURFACE_LOST_KHR) {
        loseSurface();
    }
    return result != VK_SUCCESS
               ? result
               : device->call<PFN_vkCreateSwapchainKHR>(kCreateSwapchain)(handle, info, callbacks, made);
}

VKAPI_ATTR void VKAPI_CALL setViewport(VkCommandBuffer commands, std::uint32_t first, std::uint32_t count,
                                       const VkViewport* viewports) {
    const std::shared_ptr<NextDevice> device = deviceOf(commands);
    std::vector<VkViewport> moved(viewports, viewports + count);
    if (fault().call == kSetViewport && fault().hits(kSetViewport, device->hasSwapchain)) {
        for (VkViewport& viewport : moved) {
            viewport.x += static_cast<float>(fault().result) / 16.0f;
        }
    }
    device->call<PFN_vkCmdSetViewport>(kSetViewport)(commands, first, count, moved.data());
}

VKAPI_ATTR void VKAPI_CALL deviceProperties(VkPhysicalDevice device, VkPhysicalDeviceProperties2* made) {
    instanceOf(device).call<PFN_vkGetPhysicalDeviceProperties2>(kProperties)(device, made);
    if (fault().call == kProperties && fault().hits(kProperties, false)) {
        made->properties.deviceType = static_cast<VkPhysicalDeviceType>(fault().result);
    }
}

/// `Function` as the layer implements it: fails when it must, else calls the next layer.
template <typename Function>
struct Call;
template <typename Handle, typename... Rest>
struct Call<VkResult(VKAPI_PTR*)(Handle, Rest...)> {
    using Function = VkResult(VKAPI_PTR*)(Handle, Rest...);
    template <const char* name>
    static VKAPI_ATTR VkResult VKAPI_CALL run(Handle handle, Rest... rest) {
        const std::shared_ptr<NextDevice> device = deviceOf(handle);
        const VkResult result = device->interfere(name);
        if (result == VK_ERROR_SURFACE_LOST_KHR) {
            loseSurface();
        }
        // A present that fails has still waited for its semaphores, and a suboptimal image is still an image.
        const bool isMade = result == VK_SUCCESS || result > 0 ||
                            (std::strcmp(name, "vkQueuePresentKHR") == 0 && result != VK_ERROR_DEVICE_LOST);
        const VkResult next = isMade ? device->template call<Function>(name)(handle, rest...) : result;
        return result == VK_SUCCESS || next < 0 ? next : result;
    }
};

/// The same of a function of an instance or a physical device.
template <typename Function>
struct InstanceCall;
template <typename Handle, typename... Rest>
struct InstanceCall<VkResult(VKAPI_PTR*)(Handle, Rest...)> {
    using Function = VkResult(VKAPI_PTR*)(Handle, Rest...);
    template <const char* name>
    static VKAPI_ATTR VkResult VKAPI_CALL run(Handle handle, Rest... rest) {
        if (fault().hits(name, std::strstr(name, "Surface") != nullptr)) {
            return static_cast<VkResult>(fault().result);
        }
        return instanceOf(handle).template call<Function>(name)(handle, rest...);
    }
};

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProc(VkDevice device, const char* name) {
    const PFN_vkVoidFunction found = own(name);
    return found != nullptr ? found : deviceOf(device)->get(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProc(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction found = own(name);
    const std::optional<NextInstance> next = findInstance(instance);
    if (!next) { // none yet, or one that is being made
        return found;
    }
    const auto fetched = next->functions.find(name);
    if (fetched != next->functions.end() && fetched->second == nullptr) {
        return nullptr;
    }
    return found != nullptr ? found : next->get(instance, name);
}

#define CDR_FAULT_INSTANCE_CALL(function, type)                                                              \
    static constexpr char k##function[] = #function;                                                         \
    if (std::strcmp(name, k##function) == 0) {                                                               \
        return reinterpret_cast<PFN_vkVoidFunction>(&InstanceCall<type>::run<k##function>);                  \
    }
#define CDR_FAULT_CALL(function)                                                                             \
    static constexpr char k##function[] = #function;                                                         \
    if (std::strcmp(name, k##function) == 0) {                                                               \
        return reinterpret_cast<PFN_vkVoidFunction>(&Call<PFN_##function>::run<k##function>);                \
    }

PFN_vkVoidFunction own(const char* name) {
    const std::map<std::string, PFN_vkVoidFunction> made{
        {"vkCreateInstance", reinterpret_cast<PFN_vkVoidFunction>(&createInstance)},
        {"vkCreateDevice", reinterpret_cast<PFN_vkVoidFunction>(&createDevice)},
        {"vkGetInstanceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(&getInstanceProc)},
        {"vkGetDeviceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(&getDeviceProc)},
        {kCreateSwapchain, reinterpret_cast<PFN_vkVoidFunction>(&createSwapchain)},
        {kSetViewport, reinterpret_cast<PFN_vkVoidFunction>(&setViewport)},
        {kProperties, reinterpret_cast<PFN_vkVoidFunction>(&deviceProperties)},
        {"vkDestroySurfaceKHR", reinterpret_cast<PFN_vkVoidFunction>(&destroySurface)},
        {kSurfaceCapabilities, reinterpret_cast<PFN_vkVoidFunction>(&surfaceCapabilities)}};
    if (const auto found = made.find(name); found != made.end()) {
        return found->second;
    }
    CDR_FAULT_INSTANCE_CALL(vkEnumeratePhysicalDevices, PFN_vkEnumeratePhysicalDevices)
    CDR_FAULT_INSTANCE_CALL(vkEnumerateDeviceExtensionProperties, PFN_vkEnumerateDeviceExtensionProperties)
    CDR_FAULT_INSTANCE_CALL(vkGetPhysicalDeviceSurfaceFormatsKHR, PFN_vkGetPhysicalDeviceSurfaceFormatsKHR)
    CDR_FAULT_INSTANCE_CALL(vkGetPhysicalDeviceSurfacePresentModesKHR,
                            PFN_vkGetPhysicalDeviceSurfacePresentModesKHR)
    CDR_FAULT_INSTANCE_CALL(vkGetPhysicalDeviceSurfaceSupportKHR, PFN_vkGetPhysicalDeviceSurfaceSupportKHR)
    CDR_FAULT_INSTANCE_CALL(vkCreateWaylandSurfaceKHR, CreateSurface)
    CDR_FAULT_INSTANCE_CALL(vkCreateXcbSurfaceKHR, CreateSurface)
    CDR_FAULT_INSTANCE_CALL(vkCreateXlibSurfaceKHR, CreateSurface)
    CDR_FAULT_CALL(vkAcquireNextImageKHR)
    CDR_FAULT_CALL(vkAllocateCommandBuffers)
    CDR_FAULT_CALL(vkAllocateDescriptorSets)
    CDR_FAULT_CALL(vkAllocateMemory)
    CDR_FAULT_CALL(vkBeginCommandBuffer)
    CDR_FAULT_CALL(vkBindBufferMemory)
    CDR_FAULT_CALL(vkBindBufferMemory2)
    CDR_FAULT_CALL(vkBindImageMemory)
    CDR_FAULT_CALL(vkBindImageMemory2)
    CDR_FAULT_CALL(vkCreateBuffer)
    CDR_FAULT_CALL(vkCreateBufferView)
    CDR_FAULT_CALL(vkCreateCommandPool)
    CDR_FAULT_CALL(vkCreateComputePipelines)
    CDR_FAULT_CALL(vkCreateDescriptorPool)
    CDR_FAULT_CALL(vkCreateDescriptorSetLayout)
    CDR_FAULT_CALL(vkCreateFence)
    CDR_FAULT_CALL(vkCreateFramebuffer)
    CDR_FAULT_CALL(vkCreateGraphicsPipelines)
    CDR_FAULT_CALL(vkCreateImage)
    CDR_FAULT_CALL(vkCreateImageView)
    CDR_FAULT_CALL(vkCreatePipelineCache)
    CDR_FAULT_CALL(vkCreatePipelineLayout)
    CDR_FAULT_CALL(vkCreateQueryPool)
    CDR_FAULT_CALL(vkCreateRenderPass)
    CDR_FAULT_CALL(vkCreateSampler)
    CDR_FAULT_CALL(vkCreateSemaphore)
    CDR_FAULT_CALL(vkCreateShaderModule)
    CDR_FAULT_CALL(vkDeviceWaitIdle)
    CDR_FAULT_CALL(vkEndCommandBuffer)
    CDR_FAULT_CALL(vkFlushMappedMemoryRanges)
    CDR_FAULT_CALL(vkGetFenceStatus)
    CDR_FAULT_CALL(vkGetQueryPoolResults)
    CDR_FAULT_CALL(vkGetSemaphoreCounterValue)
    CDR_FAULT_CALL(vkGetSwapchainImagesKHR)
    CDR_FAULT_CALL(vkInvalidateMappedMemoryRanges)
    CDR_FAULT_CALL(vkMapMemory)
    CDR_FAULT_CALL(vkQueuePresentKHR)
    CDR_FAULT_CALL(vkQueueSubmit)
    CDR_FAULT_CALL(vkQueueSubmit2)
    CDR_FAULT_CALL(vkQueueWaitIdle)
    CDR_FAULT_CALL(vkResetCommandPool)
    CDR_FAULT_CALL(vkResetFences)
    CDR_FAULT_CALL(vkWaitForFences)
    CDR_FAULT_CALL(vkWaitSemaphores)
    return nullptr;
}

} // namespace

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* wanted) {
    wanted->loaderLayerInterfaceVersion = CURRENT_LOADER_LAYER_INTERFACE_VERSION;
    wanted->pfnGetInstanceProcAddr = getInstanceProc;
    wanted->pfnGetDeviceProcAddr = getDeviceProc;
    wanted->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
