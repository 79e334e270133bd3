#include <cdr/gpu/device_clock.h>

#include <array>
#include <limits>

namespace cdr::gpu {

namespace {

constexpr double kMsPerNs = 1e-6;

/// Of a timestamp; 0 where the queue has none.
std::uint32_t validBits(const Device& device) {
    return vk::PhysicalDevice(device.physical())
        .getQueueFamilyProperties()
        .at(device.queueFamily())
        .timestampValidBits;
}

} // namespace

std::uint64_t timestampSteps(std::uint64_t begin, std::uint64_t end, std::uint32_t bits) {
    return (end - begin) & (std::numeric_limits<std::uint64_t>::max() >> (64 - bits));
}

bool DeviceClock::isThere(const Device& device) {
    return validBits(device) > 0 && device.info().timestampPeriodNs > 0.0;
}

DeviceClock::DeviceClock(const Device& device, const std::string& name)
    : m_device(device.handle()),
      m_bits(validBits(device)),
      m_msPerStep(device.info().timestampPeriodNs * kMsPerNs),
      m_queries(m_device.createQueryPoolUnique({.queryType = vk::QueryType::eTimestamp, .queryCount = 2})),
      m_pool(m_device.createCommandPoolUnique({.queueFamilyIndex = device.queueFamily()})) {
    device.setName(*m_queries, name + " timestamps");
    device.setName(*m_pool, name + " timestamp pool");
    const std::vector<vk::CommandBuffer> buffers =
        m_device.allocateCommandBuffers({.commandPool = *m_pool, .commandBufferCount = 2});
    m_begin = buffers[0];
    m_begin.begin(vk::CommandBufferBeginInfo{});
    m_begin.resetQueryPool(*m_queries, 0, 2);
    m_begin.writeTimestamp2(vk::PipelineStageFlagBits2::eTopOfPipe, *m_queries, 0);
    m_begin.end();
    m_end = buffers[1];
    m_end.begin(vk::CommandBufferBeginInfo{});
    m_end.writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, *m_queries, 1);
    m_end.end();
}

std::vector<vk::CommandBuffer> DeviceClock::around(std::span<const vk::CommandBuffer> commands) const {
    std::vector<vk::CommandBuffer> all{m_begin};
    all.insert(all.end(), commands.begin(), commands.end());
    all.push_back(m_end);
    return all;
}

double DeviceClock::lastMs() const {
    std::array<std::uint64_t, 2> steps{};
    const vk::Result result =
        m_device.getQueryPoolResults(*m_queries, 0, 2, sizeof steps, steps.data(), sizeof steps[0],
                                     vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
    vk::resultCheck(result, "vkGetQueryPoolResults");
    return m_msPerStep * static_cast<double>(timestampSteps(steps[0], steps[1], m_bits));
}

} // namespace cdr::gpu
