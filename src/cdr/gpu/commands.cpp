#include <cdr/gpu/commands.h>

#include <limits>

namespace cdr::gpu {

namespace {

/// Where a wait fails, what it was for may still be in work, and who waited is about to destroy what that uses. So the queue
/// is waited for first.
/// @param call names it in messages
void waitOrFinish(const Device& device, const char* call, const std::function<vk::Result()>& wait) {
    try {
        vk::resultCheck(wait(), call);
    } catch (const vk::Error&) {
        try {
            finishQueue(device);
        } catch (const vk::Error&) { // the first failure is told
        }
        throw;
    }
}

} // namespace

CommandPool::CommandPool(const Device& device, vk::CommandBufferLevel level, const std::string& name)
    : m_device(device.handle()),
      m_level(level),
      m_pool(m_device.createCommandPoolUnique(
          {.flags = vk::CommandPoolCreateFlagBits::eTransient, .queueFamilyIndex = device.queueFamily()})) {
    device.setName(*m_pool, name);
}

void CommandPool::reset() {
    m_device.resetCommandPool(*m_pool);
    m_used = 0;
}

vk::CommandBuffer CommandPool::next() {
    if (m_used == m_buffers.size()) {
        m_buffers.push_back(
            m_device
                .allocateCommandBuffers({.commandPool = *m_pool, .level = m_level, .commandBufferCount = 1})
                .front());
    }
    return m_buffers[m_used++];
}

vk::CommandBuffer beginOnce(CommandPool& pool) {
    const vk::CommandBuffer commands = pool.next();
    commands.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    return commands;
}

void submit(const Device& device, std::span<const vk::CommandBuffer> commands, vk::Fence done,
            std::span<const VkSemaphoreSubmitInfo> waits, std::span<const VkSemaphoreSubmitInfo> signals) {
    std::vector<vk::CommandBufferSubmitInfo> buffers;
    for (const vk::CommandBuffer buffer : commands) {
        buffers.push_back({.commandBuffer = buffer});
    }
    VkSubmitInfo2 submission =
        vk::SubmitInfo2{.commandBufferInfoCount = static_cast<std::uint32_t>(buffers.size()),
                        .pCommandBufferInfos = buffers.data()};
    submission.waitSemaphoreInfoCount = static_cast<std::uint32_t>(waits.size());
    submission.pWaitSemaphoreInfos = waits.data();
    submission.signalSemaphoreInfoCount = static_cast<std::uint32_t>(signals.size());
    submission.pSignalSemaphoreInfos = signals.data();
    device.submit(submission, done);
}

void waitForQueue(const Device& device) {
    // A fence is signalled after all that was submitted before it.
    runOnce(device, [](vk::CommandBuffer) {});
}

// A queue that others submit to is waited for by a fence, since vkQueueWaitIdle() needs their lock.
void finishQueue(const Device& device) {
    if (!device.isQueueShared()) {
        vk::Queue(device.queue()).waitIdle();
        return;
    }
    const vk::UniqueFence done = vk::Device(device.handle()).createFenceUnique({});
    submit(device, {}, *done);
    vk::resultCheck(
        vk::Device(device.handle()).waitForFences(*done, VK_TRUE, std::numeric_limits<std::uint64_t>::max()),
        "vkWaitForFences");
}

void waitAndReset(const Device& device, vk::Fence done) {
    const vk::Device handle(device.handle());
    waitOrFinish(device, "vkWaitForFences", [&] {
        return handle.waitForFences(done, VK_TRUE, std::numeric_limits<std::uint64_t>::max());
    });
    handle.resetFences(done);
}

void waitForTimeline(const Device& device, vk::Semaphore timeline, std::uint64_t value) {
    waitOrFinish(device, "vkWaitSemaphores", [&] {
        return vk::Device(device.handle())
            .waitSemaphores({.semaphoreCount = 1, .pSemaphores = &timeline, .pValues = &value},
                            std::numeric_limits<std::uint64_t>::max());
    });
}

void runOnce(const Device& device, const std::function<void(vk::CommandBuffer)>& record) {
    CommandPool pool(device, vk::CommandBufferLevel::ePrimary, "one-time pool");
    const vk::CommandBuffer commands = beginOnce(pool);
    record(commands);
    // A fence makes what was copied available to the device, and no more.
    memoryBarrier(commands, vk::PipelineStageFlagBits2::eAllTransfer, vk::AccessFlagBits2::eTransferWrite,
                  vk::PipelineStageFlagBits2::eAllCommands,
                  vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite);
    commands.end();
    const vk::UniqueFence done = vk::Device(device.handle()).createFenceUnique({});
    submit(device, {&commands, 1}, *done);
    waitAndReset(device, *done);
}

vk::ImageMemoryBarrier2 imageBarrier(vk::Image image, vk::ImageAspectFlags aspect, const ImageUse& before,
                                     const ImageUse& after) {
    return {.srcStageMask = before.stages,
            .srcAccessMask = before.access,
            .dstStageMask = after.stages,
            .dstAccessMask = after.access,
            .oldLayout = before.layout,
            .newLayout = after.layout,
            .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
            .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
            .image = image,
            .subresourceRange = {aspect, 0, VK_REMAINING_MIP_LEVELS, 0, 1}};
}

void pipelineBarrier(vk::CommandBuffer commands, const std::vector<vk::ImageMemoryBarrier2>& images,
                     const std::vector<vk::MemoryBarrier2>& memory) {
    commands.pipelineBarrier2({.memoryBarrierCount = static_cast<std::uint32_t>(memory.size()),
                               .pMemoryBarriers = memory.data(),
                               .imageMemoryBarrierCount = static_cast<std::uint32_t>(images.size()),
                               .pImageMemoryBarriers = images.data()});
}

void memoryBarrier(vk::CommandBuffer commands, vk::PipelineStageFlags2 stagesBefore, vk::AccessFlags2 written,
                   vk::PipelineStageFlags2 stagesAfter, vk::AccessFlags2 used) {
    pipelineBarrier(commands, {},
                    {{.srcStageMask = stagesBefore,
                      .srcAccessMask = written,
                      .dstStageMask = stagesAfter,
                      .dstAccessMask = used}});
}

} // namespace cdr::gpu
