#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <cstdint>

namespace cdr::test {

/// A host's timeline semaphore, of which value 1 is all that counts.
class Timeline {
  public:
    explicit Timeline(const gpu::Device& device) : m_device(device.handle()) {
        const vk::SemaphoreTypeCreateInfo type{.semaphoreType = vk::SemaphoreType::eTimeline};
        m_semaphore = m_device.createSemaphoreUnique({.pNext = &type});
    }

    /// To wait for it, or to signal it.
    VkSemaphoreSubmitInfo info() const {
        return vk::SemaphoreSubmitInfo{
            .semaphore = *m_semaphore, .value = 1, .stageMask = vk::PipelineStageFlagBits2::eAllCommands};
    }

    /// Whether it is signalled within this time.
    bool isSignalled(std::uint64_t nanoseconds) const {
        const std::uint64_t value = 1;
        return m_device.waitSemaphores({.semaphoreCount = 1, .pSemaphores = &*m_semaphore, .pValues = &value},
                                       nanoseconds) == vk::Result::eSuccess;
    }

    void signal() const {
        const auto signal =
            reinterpret_cast<PFN_vkSignalSemaphore>(m_device.getProcAddr("vkSignalSemaphore"));
        const VkSemaphoreSignalInfo now = vk::SemaphoreSignalInfo{.semaphore = *m_semaphore, .value = 1};
        vk::resultCheck(static_cast<vk::Result>(signal(m_device, &now)), "vkSignalSemaphore");
    }

  private:
    vk::Device m_device;
    vk::UniqueSemaphore m_semaphore;
};

} // namespace cdr::test
