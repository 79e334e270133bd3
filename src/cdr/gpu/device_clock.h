#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cdr::gpu {

/// How often a clock ticked between two readings of its lowest `bits` bits, 1 to 64; it may have begun again in between.
std::uint64_t timestampSteps(std::uint64_t begin, std::uint64_t end, std::uint32_t bits);

/// Times submissions by the device's own clock, by command buffers that are recorded once.
class DeviceClock {
  public:
    /// Whether the device's queue has a clock.
    static bool isThere(const Device& device);

    /// Of a device whose queue has one.
    DeviceClock(const Device& device, const std::string& name);

    /// The commands with a timestamp in front of and behind them. One submission of them at a time may be pending.
    std::vector<vk::CommandBuffer> around(std::span<const vk::CommandBuffer> commands) const;

    /// Milliseconds from the beginning to the end of the last submission, which must be done.
    double lastMs() const;

  private:
    vk::Device m_device;
    std::uint32_t m_bits;
    double m_msPerStep;
    vk::UniqueQueryPool m_queries;
    vk::UniqueCommandPool m_pool;
    vk::CommandBuffer m_begin;
    vk::CommandBuffer m_end;
};

} // namespace cdr::gpu
