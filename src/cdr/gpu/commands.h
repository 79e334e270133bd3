#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace cdr::gpu {

/// A command pool of one thread and one frame slot. next() hands out buffers in turn, and reset() takes all
/// of them back at once. That is much cheaper than freeing buffers one by one (Khronos Vulkan-Samples,
/// command_buffer_usage).
class CommandPool {
  public:
    CommandPool(const Device& device, vk::CommandBufferLevel level, const std::string& name);

    /// Takes back every buffer handed out. None may be pending on the device.
    void reset();
    /// A buffer in the initial state; valid until the next reset().
    vk::CommandBuffer next();

  private:
    vk::Device m_device;
    vk::CommandBufferLevel m_level;
    vk::UniqueCommandPool m_pool;
    std::vector<vk::CommandBuffer> m_buffers;
    std::size_t m_used = 0;
};

/// A buffer of the pool that is recording, to be submitted once.
vk::CommandBuffer beginOnce(CommandPool& pool);

/// Submits command buffers that run in this order, after `waits`, and signals `signals` and `done`. `done` is
/// unsignalled until then, or null. std::system_error when the device is lost.
void submit(const Device& device, std::span<const vk::CommandBuffer> commands, vk::Fence done,
            std::span<const VkSemaphoreSubmitInfo> waits = {},
            std::span<const VkSemaphoreSubmitInfo> signals = {});

/// Waits for all that was submitted to the device's queue before.
void waitForQueue(const Device& device);
/// The same after an error, before what the queue uses is destroyed. Takes no memory, unless others submit to the queue too.
void finishQueue(const Device& device);

/// Waits for a submission and makes its fence unsignalled again. std::system_error when the device is lost.
void waitAndReset(const Device& device, vk::Fence done);

/// Waits until a timeline semaphore reaches a value. std::system_error when the device is lost.
void waitForTimeline(const Device& device, vk::Semaphore timeline, std::uint64_t value);

/// Records commands once, submits them and waits: for uploads, not for frames. What they copy is seen by all that is submitted
/// after.
void runOnce(const Device& device, const std::function<void(vk::CommandBuffer)>& record);

/// How an image is used: in which stages, how, and in which layout.
struct ImageUse {
    vk::PipelineStageFlags2 stages;
    vk::AccessFlags2 access;
    vk::ImageLayout layout = vk::ImageLayout::eUndefined;
};

/// One image barrier in the synchronization2 form, from one use to the next.
vk::ImageMemoryBarrier2 imageBarrier(vk::Image image, vk::ImageAspectFlags aspect, const ImageUse& before,
                                     const ImageUse& after);

/// Puts barriers into a command buffer as one dependency.
void pipelineBarrier(vk::CommandBuffer commands, const std::vector<vk::ImageMemoryBarrier2>& images,
                     const std::vector<vk::MemoryBarrier2>& memory = {});

/// Puts one memory barrier into a command buffer: what was written before is seen by what uses it after.
void memoryBarrier(vk::CommandBuffer commands, vk::PipelineStageFlags2 stagesBefore, vk::AccessFlags2 written,
                   vk::PipelineStageFlags2 stagesAfter, vk::AccessFlags2 used);

} // namespace cdr::gpu
