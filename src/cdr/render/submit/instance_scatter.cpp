#include <cdr/render/submit/instance_scatter.h>
#include <cdr/shaders/binning.h>

#include <algorithm>
#include <vector>

namespace cdr::render {

namespace {

constexpr auto kChangesType = vk::DescriptorType::eStorageBuffer;
constexpr std::uint32_t kChangesBindings = 3;
/// Groups that every device runs.
constexpr std::size_t kMostGroups = 65'535;

} // namespace

InstanceScatter::InstanceScatter(const gpu::Device& device)
    : m_device(device),
      m_setLayout(gpu::makeSetLayout(
          device, {std::vector(kChangesBindings, kChangesType), vk::ShaderStageFlagBits::eCompute},
          "scatter set")),
      m_layout(gpu::makePipelineLayout(
          device,
          {{m_setLayout}, {{.stageFlags = vk::ShaderStageFlagBits::eCompute, .size = sizeof(std::uint32_t)}}},
          "scatter layout")),
      m_pipeline(gpu::makeComputePipeline(device, {"scatter", gpu::Spirv(kScatterComp), m_layout})) {}

std::size_t InstanceScatter::most() const {
    return std::min<std::size_t>(m_device.info().maxStorageBufferBytes / sizeof(shaders::InstanceChange),
                                 kMostGroups * shaders::kChangesBlock);
}

void InstanceScatter::stage(const Changes& changes, const Buffers& buffers, Slot& slot) const {
    slot.count = static_cast<std::uint32_t>(changes.instances.size());
    if (slot.count == 0) {
        slot.changes = {}; // a scene that stands still keeps no copy of itself
        return;
    }
    constexpr std::size_t kBytes = sizeof(shaders::InstanceChange);
    if (slot.changes.size() < slot.count * kBytes) {
        const std::size_t room =
            gpu::roomToGrow(m_device, {.count = slot.count, .bytes = kBytes, .most = most()},
                            gpu::MemoryUse::hostWrites, "changes of a gpu-driven scene");
        slot.changes = gpu::Buffer(m_device, room * kBytes, vk::BufferUsageFlagBits::eStorageBuffer,
                                   gpu::MemoryUse::hostWrites, "changed instances");
    }
    const std::span staged = slot.changes.as<shaders::InstanceChange>(slot.count);
    for (std::size_t i = 0; i < staged.size(); ++i) {
        const std::uint32_t instance = changes.instances[i];
        staged[i] = {changes.spheres[instance], changes.looks[instance], instance, 0};
    }
    slot.changes.flush();
    slot.set.setBuffer(0, slot.changes);
    slot.set.setBuffer(1, buffers.spheres);
    slot.set.setBuffer(2, buffers.looks);
}

void InstanceScatter::record(vk::CommandBuffer commands, const Slot& slot) const {
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *m_pipeline);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *m_layout, 0, *slot.set, {});
    commands.pushConstants<std::uint32_t>(*m_layout, vk::ShaderStageFlagBits::eCompute, 0, slot.count);
    commands.dispatch((slot.count + shaders::kChangesBlock - 1) / shaders::kChangesBlock, 1, 1);
}

} // namespace cdr::render
