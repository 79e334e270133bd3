#include "weakened_barriers.h"

#include "../support/own_loader.h"

#include <cdr/gpu/vulkan_hpp.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace cdr::test {

namespace {

struct Counter {
    std::optional<std::size_t> wanted;
    std::size_t counted = 0;
    std::string weakened;

    /// Whether the next barrier is the one to weaken.
    bool takes() { return wanted == counted++; }
};

/// Barriers are recorded by the thread that calls the renderer alone.
Counter& counter() {
    static Counter only;
    return only;
}

template <typename Barrier>
std::string stagesOf(const Barrier& barrier) {
    return fmt::format("{} of {} before {} of {}", vk::to_string(vk::AccessFlags2(barrier.srcAccessMask)),
                       vk::to_string(vk::PipelineStageFlags2(barrier.srcStageMask)),
                       vk::to_string(vk::AccessFlags2(barrier.dstAccessMask)),
                       vk::to_string(vk::PipelineStageFlags2(barrier.dstStageMask)));
}

std::string wordsOf(const VkMemoryBarrier2& barrier) {
    return "memory: " + stagesOf(barrier);
}

std::string wordsOf(const VkImageMemoryBarrier2& barrier) {
    return fmt::format("image, {} to {}: {}", vk::to_string(vk::ImageLayout(barrier.oldLayout)),
                       vk::to_string(vk::ImageLayout(barrier.newLayout)), stagesOf(barrier));
}

template <typename Barrier>
std::vector<Barrier> taken(const Barrier* barriers, std::uint32_t count) {
    std::vector<Barrier> copies(barriers, barriers + count);
    for (Barrier& barrier : copies) {
        if (counter().takes()) {
            counter().weakened = wordsOf(barrier);
            barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_NONE;
            barrier.srcAccessMask = barrier.dstAccessMask = VK_ACCESS_2_NONE;
        }
    }
    return copies;
}

PFN_vkCmdPipelineBarrier2 realBarrier = nullptr;

void VKAPI_PTR weakeningBarrier(VkCommandBuffer commands, const VkDependencyInfo* info) {
    const std::vector<VkMemoryBarrier2> memory = taken(info->pMemoryBarriers, info->memoryBarrierCount);
    const std::vector<VkImageMemoryBarrier2> images =
        taken(info->pImageMemoryBarriers, info->imageMemoryBarrierCount);
    VkDependencyInfo weaker = *info;
    weaker.pMemoryBarriers = memory.data();
    weaker.pImageMemoryBarriers = images.data();
    realBarrier(commands, &weaker);
}

PFN_vkVoidFunction VKAPI_PTR weakeningLoader(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction found = systemsLoader()(instance, name);
    if (std::string_view(name) != "vkCmdPipelineBarrier2" || found == nullptr) {
        return found;
    }
    realBarrier = reinterpret_cast<PFN_vkCmdPipelineBarrier2>(found);
    return reinterpret_cast<PFN_vkVoidFunction>(&weakeningBarrier);
}

const testing::Environment* const kBringLoader =
    testing::AddGlobalTestEnvironment(new OwnLoader(&weakeningLoader));

} // namespace

void WeakenedBarriers::begin(std::optional<std::size_t> weakened) {
    counter() = {.wanted = weakened, .counted = 0, .weakened = {}};
}

std::size_t WeakenedBarriers::counted() {
    return counter().counted;
}

const std::string& WeakenedBarriers::weakened() {
    return counter().weakened;
}

} // namespace cdr::test
