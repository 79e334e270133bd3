#include "failing_calls.h"

#include "../support/own_loader.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <optional>
#include <string>
#include <type_traits>

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

/// What Vulkan says in the place of what it would say.
struct Said {
    std::optional<std::uint64_t> heapBytes;
    std::optional<std::uint32_t> storageBuffers;
    std::optional<std::uint32_t> mostIndices;
    std::optional<std::uint64_t> bufferBytes;
    std::optional<std::uint64_t> allocationBytes;
    std::optional<VkFormat> withheldFormat;
    std::optional<std::uint32_t> firstCount;
};

Said& said() {
    static Said only;
    return only;
}

PFN_vkGetPhysicalDeviceMemoryProperties realMemory = nullptr;

void VKAPI_PTR memoryOf(VkPhysicalDevice physical, VkPhysicalDeviceMemoryProperties* memory) {
    realMemory(physical, memory);
    for (std::uint32_t heap = 0; heap < memory->memoryHeapCount; ++heap) {
        VkDeviceSize& size = memory->memoryHeaps[heap].size;
        size = std::min<VkDeviceSize>(size, said().heapBytes.value_or(size));
    }
}

PFN_vkGetPhysicalDeviceProperties realProperties = nullptr;

void VKAPI_PTR propertiesOf(VkPhysicalDevice physical, VkPhysicalDeviceProperties* properties) {
    realProperties(physical, properties);
    std::uint32_t& most = properties->limits.maxPerStageDescriptorStorageBuffers;
    most = std::min(most, said().storageBuffers.value_or(most));
}

PFN_vkGetPhysicalDeviceProperties2 realProperties2 = nullptr;

void VKAPI_PTR properties2Of(VkPhysicalDevice physical, VkPhysicalDeviceProperties2* properties) {
    realProperties2(physical, properties);
    std::uint32_t& last = properties->properties.limits.maxDrawIndexedIndexValue;
    last = said().mostIndices ? std::min(last, *said().mostIndices - 1) : last;
    for (auto* next = static_cast<VkBaseOutStructure*>(properties->pNext); next != nullptr;
         next = next->pNext) {
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES && said().bufferBytes) {
            reinterpret_cast<VkPhysicalDeviceVulkan13Properties*>(next)->maxBufferSize = *said().bufferBytes;
        }
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES &&
            said().allocationBytes) {
            reinterpret_cast<VkPhysicalDeviceVulkan11Properties*>(next)->maxMemoryAllocationSize =
                *said().allocationBytes;
        }
    }
}

PFN_vkGetPhysicalDeviceFormatProperties realFormat = nullptr;

void VKAPI_PTR formatOf(VkPhysicalDevice physical, VkFormat format, VkFormatProperties* properties) {
    realFormat(physical, format, properties);
    if (format == said().withheldFormat) {
        properties->optimalTilingFeatures &=
            ~VkFormatFeatureFlags{VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT};
    }
}

PFN_vkCmdFillBuffer realFill = nullptr;

void VKAPI_PTR fillFrom(VkCommandBuffer commands, VkBuffer buffer, VkDeviceSize offset, VkDeviceSize bytes,
                        std::uint32_t data) {
    const bool isCounter = bytes == sizeof(std::uint32_t) && data == 0;
    realFill(commands, buffer, offset, bytes, isCounter ? said().firstCount.value_or(0) : data);
}

PFN_vkCmdPipelineBarrier2 realBarrier = nullptr;
// Threads record at once.
std::atomic<std::size_t> separateLayoutsSeen = 0;
std::atomic<std::size_t> attachmentLayoutsSeen = 0;

void VKAPI_PTR seenBarrier(VkCommandBuffer commands, const VkDependencyInfo* dependency) {
    for (std::uint32_t i = 0; i < dependency->imageMemoryBarrierCount; ++i) {
        const VkImageLayout layout = dependency->pImageMemoryBarriers[i].newLayout;
        if (layout >= VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL &&
            layout <= VK_IMAGE_LAYOUT_STENCIL_READ_ONLY_OPTIMAL) { // four numbers in a row
            ++separateLayoutsSeen;
        } else if (layout == VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL) {
            ++attachmentLayoutsSeen;
        }
    }
    realBarrier(commands, dependency);
}

PFN_vkCmdDrawIndexed realDrawIndexed = nullptr;
std::atomic<std::size_t> indexedDrawsSeen = 0;

void VKAPI_PTR seenDrawIndexed(VkCommandBuffer commands, std::uint32_t indices, std::uint32_t instances,
                               std::uint32_t firstIndex, std::int32_t vertexOffset,
                               std::uint32_t firstInstance) {
    ++indexedDrawsSeen;
    realDrawIndexed(commands, indices, instances, firstIndex, vertexOffset, firstInstance);
}

PFN_vkGetDeviceProcAddr realDeviceLoader = nullptr;

PFN_vkVoidFunction VKAPI_PTR failableDeviceLoader(VkDevice device, const char* name);

/// The function to call in the place of what was found. It calls what was found last.
template <auto* real, auto* call>
PFN_vkVoidFunction standIn(PFN_vkVoidFunction found) {
    *real = reinterpret_cast<std::remove_pointer_t<decltype(real)>>(found);
    return reinterpret_cast<PFN_vkVoidFunction>(call);
}

struct Call {
    std::string_view name;
    PFN_vkVoidFunction (*standIn)(PFN_vkVoidFunction found);
    bool canFail = false; ///< only these are replaced where a device is asked for them too
};

constexpr Call kCalls[] = {
    {kAllocateDescriptorSets, Failable<kAllocateDescriptorSets, PFN_vkAllocateDescriptorSets>::standIn, true},
    {kCreateBuffer, Failable<kCreateBuffer, PFN_vkCreateBuffer>::standIn, true},
    {kCreateDescriptorPool, Failable<kCreateDescriptorPool, PFN_vkCreateDescriptorPool>::standIn, true},
    {kCreateFence, Failable<kCreateFence, PFN_vkCreateFence>::standIn, true},
    {kCreateSampler, Failable<kCreateSampler, PFN_vkCreateSampler>::standIn, true},
    {kQueueSubmit2, Failable<kQueueSubmit2, PFN_vkQueueSubmit2>::standIn, true},
    {kGetQueryPoolResults, Failable<kGetQueryPoolResults, PFN_vkGetQueryPoolResults>::standIn, true},
    // By which memory is allocated.
    {"vkGetDeviceProcAddr", standIn<&realDeviceLoader, &failableDeviceLoader>},
    {"vkGetPhysicalDeviceMemoryProperties", standIn<&realMemory, &memoryOf>},
    {"vkGetPhysicalDeviceProperties", standIn<&realProperties, &propertiesOf>},
    {"vkGetPhysicalDeviceProperties2", standIn<&realProperties2, &properties2Of>},
    {"vkGetPhysicalDeviceFormatProperties", standIn<&realFormat, &formatOf>},
    {"vkCmdFillBuffer", standIn<&realFill, &fillFrom>},
    {"vkCmdPipelineBarrier2", standIn<&realBarrier, &seenBarrier>},
    {"vkCmdDrawIndexed", standIn<&realDrawIndexed, &seenDrawIndexed>},
};

/// What stands in for a function that was found; itself where nothing does.
PFN_vkVoidFunction inPlaceOf(PFN_vkVoidFunction found, std::string_view name, bool isOfDevice) {
    const auto* call = std::ranges::find(kCalls, name, &Call::name);
    const bool isReplaced = found != nullptr && call != std::end(kCalls) && (call->canFail || !isOfDevice);
    return isReplaced ? call->standIn(found) : found;
}

PFN_vkVoidFunction VKAPI_PTR failableDeviceLoader(VkDevice device, const char* name) {
    return inPlaceOf(realDeviceLoader(device, name), name, true);
}

PFN_vkVoidFunction VKAPI_PTR failableLoader(VkInstance instance, const char* name) {
    return inPlaceOf(test::systemsLoader()(instance, name), name, false);
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
    return {said().heapBytes, bytes};
}

StandIn<std::uint32_t> fewStorageBuffers(std::uint32_t most) {
    return {said().storageBuffers, most};
}

StandIn<std::uint32_t> fewIndices(std::uint32_t most) {
    return {said().mostIndices, most};
}

StandIn<std::uint64_t> smallBuffers(std::uint64_t bytes) {
    return {said().bufferBytes, bytes};
}

StandIn<std::uint64_t> smallAllocations(std::uint64_t bytes) {
    return {said().allocationBytes, bytes};
}

StandIn<VkFormat> noDepthFormat(VkFormat format) {
    return {said().withheldFormat, format};
}

DepthLayouts depthLayouts() {
    return {.separate = separateLayoutsSeen, .whole = attachmentLayoutsSeen};
}

std::size_t indexedDraws() {
    return indexedDrawsSeen;
}

StandIn<std::uint32_t> counterFrom(std::uint32_t first) {
    return {said().firstCount, first};
}

} // namespace cdr::render_test
