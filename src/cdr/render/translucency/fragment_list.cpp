#include <cdr/gpu/commands.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/stages.h>
#include <cdr/render/translucency/fragment_list.h>
#include <cdr/shaders/translucent_shared.h>

#include <fmt/format.h>

#include <algorithm>

namespace cdr::render {

namespace {

using Usage = vk::BufferUsageFlagBits;

constexpr std::uint64_t kNodeBytes = sizeof(shaders::FragmentNode);

std::uint64_t pixelsOf(vk::Extent2D extent) {
    return std::uint64_t{extent.width} * extent.height;
}

/// Of the nodes for so many fragments; the first node is nobody's.
std::uint64_t bytesFor(std::uint64_t fragments) {
    return (fragments + 1) * kNodeBytes;
}

} // namespace

std::optional<ListRefusal> FragmentList::refusal(const gpu::Device& device, vk::Extent2D extent,
                                                 std::uint64_t maxBytes, std::uint32_t otherBuffers) {
    const auto refused = [](ListRefusal::Cause cause, std::uint64_t needed, std::uint64_t allowed) {
        return ListRefusal{.cause = cause, .fragments = 0, .neededBytes = needed, .allowedBytes = allowed};
    };
    if (!device.info().hasFragmentStores) {
        return refused(ListRefusal::Cause::noFragmentStores, 0, 0);
    }
    const vk::PhysicalDeviceLimits limits = vk::PhysicalDevice(device.physical()).getProperties().limits;
    if (limits.maxPerStageDescriptorStorageBuffers < kBindings + otherBuffers) {
        return refused(ListRefusal::Cause::storageBuffers, 0, 0);
    }
    const std::uint64_t heads = pixelsOf(extent) * sizeof(std::uint32_t);
    if (heads + bytesFor(1) > maxBytes) {
        return refused(ListRefusal::Cause::bound, heads, maxBytes);
    }
    if (heads > device.info().maxStorageBufferBytes) {
        return refused(ListRefusal::Cause::bufferSize, heads, device.info().maxStorageBufferBytes);
    }
    const std::uint64_t first = std::min(maxBytes, heads + bytesFor(pixelsOf(extent)));
    if (const std::uint64_t available = gpu::freeDeviceBytes(device); first > available) {
        return refused(ListRefusal::Cause::memory, first, available);
    }
    return std::nullopt;
}

FragmentList::FragmentList(const gpu::Device& device, const gpu::SetLayout& layout, vk::Extent2D extent,
                           std::uint64_t maxBytes)
    : m_device(device),
      m_maxBytes(maxBytes),
      m_heads(device, pixelsOf(extent) * sizeof(std::uint32_t), Usage::eStorageBuffer | Usage::eTransferDst,
              gpu::MemoryUse::deviceOnly, "fragment list heads"),
      m_count(device, sizeof(std::uint32_t),
              Usage::eStorageBuffer | Usage::eTransferDst | Usage::eTransferSrc, gpu::MemoryUse::deviceOnly,
              "fragment count"),
      m_readCount(device, sizeof(std::uint32_t), Usage::eTransferDst, gpu::MemoryUse::hostReads,
                  "fragment count, copied"),
      m_set(device, layout) {
    m_set.setBuffer(0, m_heads);
    m_set.setBuffer(2, m_count);
}

std::uint64_t FragmentList::mostFragments() const {
    const std::uint64_t left = m_maxBytes - std::min<std::uint64_t>(m_maxBytes, m_heads.size());
    constexpr std::uint64_t kMaxNodes =
        shaders::kMostCounted; // so that more fragments than fit are told apart
    const std::uint64_t nodes =
        std::min({left / kNodeBytes, m_device.info().maxStorageBufferBytes / kNodeBytes, kMaxNodes});
    return nodes - std::min<std::uint64_t>(nodes, 1);
}

void FragmentList::makeNodes(std::uint64_t fragments) {
    const std::uint64_t bytes = bytesFor(fragments);
    m_nodes = {}; // first, so that both need not fit
    m_capacity = 0;
    gpu::requireDeviceBytes(m_device, bytes, fmt::format("{} translucent fragments", fragments));
    m_nodes = gpu::Buffer(m_device, bytes, Usage::eStorageBuffer, gpu::MemoryUse::deviceOnly,
                          "fragment list nodes");
    m_capacity = static_cast<std::uint32_t>(fragments);
    m_set.setBuffer(1, m_nodes);
}

void FragmentList::recordClear(vk::CommandBuffer primary) const {
    gpu::memoryBarrier(primary, PipelineStage::eFragmentShader | PipelineStage::eTransfer,
                       Access::eShaderStorageWrite, PipelineStage::eTransfer, Access::eTransferWrite);
    primary.fillBuffer(m_heads.handle(), 0, VK_WHOLE_SIZE, shaders::kNoNode);
    primary.fillBuffer(m_count.handle(), 0, sizeof(std::uint32_t), 0);
    gpu::memoryBarrier(primary, PipelineStage::eTransfer, Access::eTransferWrite,
                       PipelineStage::eFragmentShader,
                       Access::eShaderStorageRead | Access::eShaderStorageWrite);
}

void FragmentList::recordCount(vk::CommandBuffer primary) const {
    primary.copyBuffer(m_count.handle(), m_readCount.handle(), {{0, 0, sizeof(std::uint32_t)}});
    gpu::memoryBarrier(primary, PipelineStage::eTransfer, Access::eTransferWrite, PipelineStage::eHost,
                       Access::eHostRead);
}

std::uint32_t FragmentList::count() const {
    m_readCount.invalidate();
    return m_readCount.as<std::uint32_t>(1).front();
}

std::optional<ListRefusal> FragmentList::begin() {
    const std::uint64_t pixels = m_heads.size() / sizeof(std::uint32_t);
    if (m_capacity > 0) {
        return std::nullopt;
    }
    std::optional<ListRefusal> refused = makeRoom(std::clamp<std::uint64_t>(mostFragments(), 1, pixels), 0);
    if (refused) {
        refused->fragments = 0; // no frame has said how many there are
    }
    return refused;
}

std::optional<ListRefusal> FragmentList::grow(std::uint64_t fragments) {
    // A quarter more, so that a camera that moves does not draw every frame twice.
    return makeRoom(fragments, fragments / 4);
}

std::optional<ListRefusal> FragmentList::makeRoom(std::uint64_t fragments, std::uint64_t spare) {
    const auto refused = [&](ListRefusal::Cause cause, std::uint64_t needed, std::uint64_t allowed) {
        return ListRefusal{.cause = cause,
                           .fragments = fragments,
                           .neededBytes = needed,
                           .allowedBytes = allowed,
                           .mayBeMore = fragments >= shaders::kMostCounted};
    };
    const std::uint64_t wanted = bytesFor(fragments);
    if (m_heads.size() + wanted > m_maxBytes) {
        return refused(ListRefusal::Cause::bound, m_heads.size() + wanted, m_maxBytes);
    }
    if (fragments > mostFragments()) {
        return refused(ListRefusal::Cause::bufferSize, wanted, m_device.info().maxStorageBufferBytes);
    }
    const std::uint64_t available = gpu::freeDeviceBytes(m_device) + m_nodes.size();
    if (wanted > available) {
        return refused(ListRefusal::Cause::memory, wanted, available);
    }
    makeNodes(std::min({mostFragments(), available / kNodeBytes - 1, fragments + spare}));
    return std::nullopt;
}

} // namespace cdr::render
