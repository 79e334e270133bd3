#include "failing_calls.h"

#include "../support/own_loader.h"

#include <algorithm>
#include <optional>
#include <string>

namespace cdr::render_test {

namespace {

struct WantedFailure {
    std::string name; ///< empty: none
    std::size_t after = 0;
    bool hasFailed = false;

    bool takes(std::string_view call) {
        if (call != name || hasFailed) {
            return false;
        }
        hasFailed = after == 0;
        after -= hasFailed ? 0 : 1;
        return hasFailed;
    }
};

WantedFailure& wantedFailure() {
    static WantedFailure only;
    return only;
}

constexpr char kAllocateDescriptorSets[] = "vkAllocateDescriptorSets";
constexpr char kCreateBuffer[] = "vkCreateBuffer";
constexpr char kCreateDescriptorPool[] = "vkCreateDescriptorPool";
constexpr char kCreateFence[] = "vkCreateFence";
constexpr char kCreateSampler[] = "vkCreateSampler";
constexpr char kQueueSubmit2[] = "vkQueueSubmit2";
constexpr char kGetQueryPoolResults[] = "vkGetQueryPoolResults";

/// A function of Vulkan as this program calls it.
template <const char* name, typename Function>
struct Failable;
template <const char* name, typename... Parameters>
struct Failable<name, VkResult(VKAPI_PTR*)(Parameters...)> {
    using Function = VkResult(VKAPI_PTR*)(Parameters...);
    static Function& real() {
        static Function only = nullptr;
        return only;
    }
    static VKAPI_ATTR VkResult VKAPI_CALL call(Parameters... parameters) {
        return wantedFailure().takes(name) ? VK_ERROR_OUT_OF_DEVICE_MEMORY : real()(parameters...);
    }
    /// The function to call in the place of what was found. It calls what was found first, the function of the instance. That
    /// serves each device; the function of a device serves no other one.
    static PFN_vkVoidFunction standIn(PFN_vkVoidFunction found) {
        if (real() == nullptr) {
            real() = reinterpret_cast<Function>(found);
        }
        return reinterpret_cast<PFN_vkVoidFunction>(&call);
    }
};

/// The same for any of them; what was found itself where the name is another's.
PFN_vkVoidFunction failableOf(std::string_view name, PFN_vkVoidFunction found) {
    if (name == kAllocateDescriptorSets) {
        return Failable<kAllocateDescriptorSets, PFN_vkAllocateDescriptorSets>::standIn(found);
    }
    if (name == kCreateBuffer) {
        return Failable<kCreateBuffer, PFN_vkCreateBuffer>::standIn(found);
    }
    if (name == kCreateDescriptorPool) {
        return Failable<kCreateDescriptorPool, PFN_vkCreateDescriptorPool>::standIn(found);
    }
    if (name == kCreateFence) {
        return Failable<kCreateFence, PFN_vkCreateFence>::standIn(found);
    }
    if (name == kCreateSampler) {
        return Failable<kCreateSampler, PFN_vkCreateSampler>::standIn(found);
    }
    if (name == kQueueSubmit2) {
        return Failable<kQueueSubmit2, PFN_vkQueueSubmit2>::standIn(found);
    }
    if (name == kGetQueryPoolResults) {
        return Failable<kGetQueryPoolResults, PFN_vkGetQueryPoolResults>::standIn(found);
    }
    return found;
}

std::optional<std::uint64_t>& heapBytes() {
    static std::optional<std::uint64_t> most;
    return most;
}

PFN_vkGetPhysicalDeviceMemoryProperties realMemory = nullptr;

void VKAPI_PTR memoryOf(VkPhysicalDevice physical, VkPhysicalDeviceMemoryProperties* memory) {
    realMemory(physical, memory);
    for (std::uint32_t heap = 0; heap < memory->memoryHeapCount; ++heap) {
        VkDeviceSize& size = memory->memoryHeaps[heap].size;
        size = std::min<VkDeviceSize>(size, heapBytes().value_or(size));
    }
}

std::optional<std::uint32_t>& storageBuffers() {
    static std::optional<std::uint32_t> most;
    return most;
}

PFN_vkGetPhysicalDeviceProperties realProperties = nullptr;

void VKAPI_PTR propertiesOf(VkPhysicalDevice physical, VkPhysicalDeviceProperties* properties) {
    realProperties(physical, properties);
    std::uint32_t& most = properties->limits.maxPerStageDescriptorStorageBuffers;
    most = std::min(most, storageBuffers().value_or(most));
}

std::optional<std::uint32_t>& mostIndices() {
    static std::optional<std::uint32_t> most;
    return most;
}

std::optional<std::uint64_t>& bufferBytes() {
    static std::optional<std::uint64_t> most;
    return most;
}

PFN_vkGetPhysicalDeviceProperties2 realProperties2 = nullptr;

void VKAPI_PTR properties2Of(VkPhysicalDevice physical, VkPhysicalDeviceProperties2* properties) {
    realProperties2(physical, properties);
    std::uint32_t& last = properties->properties.limits.maxDrawIndexedIndexValue;
    last = mostIndices() ? std::min(last, *mostIndices() - 1) : last;
    for (auto* next = static_cast<VkBaseOutStructure*>(properties->pNext); next != nullptr;
         next = next->pNext) {
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES && bufferBytes()) {
            reinterpret_cast<VkPhysicalDeviceVulkan13Properties*>(next)->maxBufferSize = *bufferBytes();
        }
    }
}

std::optional<VkFormat>& withheldFormat() {
    static std::optional<VkFormat> only;
    return only;
}

PFN_vkGetPhysicalDeviceFormatProperties realFormat = nullptr;

void VKAPI_PTR formatOf(VkPhysicalDevice physical, VkFormat format, VkFormatProperties* properties) {
    realFormat(physical, format, properties);
    if (format == withheldFormat()) {
        properties->optimalTilingFeatures &=
            ~VkFormatFeatureFlags{VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT};
    }
}

std::optional<std::uint32_t>& firstCount() {
    static std::optional<std::uint32_t> first;
    return first;
}

PFN_vkCmdFillBuffer realFill = nullptr;

void VKAPI_PTR fillFrom(VkCommandBuffer commands, VkBuffer buffer, VkDeviceSize offset, VkDeviceSize bytes,
                        std::uint32_t data) {
    const bool isCounter = bytes == sizeof(std::uint32_t) && data == 0;
    realFill(commands, buffer, offset, bytes, isCounter ? firstCount().value_or(0) : data);
}

PFN_vkGetDeviceProcAddr realDeviceLoader = nullptr;

PFN_vkVoidFunction VKAPI_PTR failableDeviceLoader(VkDevice device, const char* name) {
    return failableOf(name, realDeviceLoader(device, name));
}

PFN_vkVoidFunction VKAPI_PTR failableLoader(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction found = test::systemsLoader()(instance, name);
    if (found == nullptr) {
        return nullptr;
    }
    if (std::string_view(name) == "vkGetDeviceProcAddr") { // by which memory is allocated
        realDeviceLoader = reinterpret_cast<PFN_vkGetDeviceProcAddr>(found);
        return reinterpret_cast<PFN_vkVoidFunction>(&failableDeviceLoader);
    }
    if (std::string_view(name) == "vkGetPhysicalDeviceMemoryProperties") {
        realMemory = reinterpret_cast<PFN_vkGetPhysicalDeviceMemoryProperties>(found);
        return reinterpret_cast<PFN_vkVoidFunction>(&memoryOf);
    }
    if (std::string_view(name) == "vkGetPhysicalDeviceProperties") {
        realProperties = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties>(found);
        return reinterpret_cast<PFN_vkVoidFunction>(&propertiesOf);
    }
    if (std::string_view(name) == "vkGetPhysicalDeviceProperties2") {
        realProperties2 = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties2>(found);
        return reinterpret_cast<PFN_vkVoidFunction>(&properties2Of);
    }
    if (std::string_view(name) == "vkGetPhysicalDeviceFormatProperties") {
        realFormat = reinterpret_cast<PFN_vkGetPhysicalDeviceFormatProperties>(found);
        return reinterpret_cast<PFN_vkVoidFunction>(&formatOf);
    }
    if (std::string_view(name) == "vkCmdFillBuffer") {
        realFill = reinterpret_cast<PFN_vkCmdFillBuffer>(found);
        return reinterpret_cast<PFN_vkVoidFunction>(&fillFrom);
    }
    return failableOf(name, found);
}

const testing::Environment* const kBringFailableLoader =
    testing::AddGlobalTestEnvironment(new test::OwnLoader(&failableLoader));

} // namespace

FailingCall::FailingCall(std::string_view name, std::size_t after) {
    wantedFailure() = {.name = std::string(name), .after = after};
}

FailingCall::~FailingCall() {
    wantedFailure() = {};
}

bool FailingCall::hasFailed() {
    return wantedFailure().hasFailed;
}

StandIn<std::uint64_t> smallHeaps(std::uint64_t bytes) {
    return {heapBytes(), bytes};
}

StandIn<std::uint32_t> fewStorageBuffers(std::uint32_t most) {
    return {storageBuffers(), most};
}

StandIn<std::uint32_t> fewIndices(std::uint32_t most) {
    return {mostIndices(), most};
}

StandIn<std::uint64_t> smallBuffers(std::uint64_t bytes) {
    return {bufferBytes(), bytes};
}

StandIn<VkFormat> noDepthFormat(VkFormat format) {
    return {withheldFormat(), format};
}

StandIn<std::uint32_t> counterFrom(std::uint32_t first) {
    return {firstCount(), first};
}

} // namespace cdr::render_test
