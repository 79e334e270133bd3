#include <cdr/base/format_error.h>
#include <cdr/gpu/commands.h>
#include <cdr/render/output/motion_pass.h>
#include <cdr/render/output/motion_records.h>
#include <cdr/render/stages.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/output.h>

#include <algorithm>
#include <span>

namespace cdr::render {

namespace {

constexpr std::uint32_t kRecordsBinding = 2;
constexpr std::uint32_t kTableBinding = 3;

constexpr std::uint64_t kRoomStep = 16; ///< bytes; of what records and tables hold

std::size_t bytesOf(std::size_t records) {
    return sizeof(shaders::MotionHeader) + records * sizeof(shaders::MotionRecord);
}

/// A buffer with room to grow on, as far as the device has such buffers.
/// @throws base::RunError with both figures where it has none of `bytes`.
gpu::Buffer makeInput(const gpu::Device& device, std::uint64_t bytes, const char* name) {
    const gpu::Records steps{.count = (bytes + kRoomStep - 1) / kRoomStep,
                             .bytes = kRoomStep,
                             .most = device.info().maxStorageBufferBytes / kRoomStep};
    if (steps.count > steps.most) {
        throw base::runError("motion: {} take {} bytes, more than the {} of a buffer of {}", name, bytes,
                             steps.most * kRoomStep, device.info().name);
    }
    const std::uint64_t room = gpu::roomToGrow(device, steps, gpu::MemoryUse::hostWrites, name) * kRoomStep;
    return {device, room, vk::BufferUsageFlagBits::eStorageBuffer, gpu::MemoryUse::hostWrites, name};
}

} // namespace

MotionPass::MotionPass(const gpu::Device& device, const gpu::Image& gbuffer, std::uint32_t subPixelBits)
    : m_device(device),
      m_gbuffer(gbuffer),
      m_image(device, colorOptions(gbuffer.options().extent, kMotionFormat), "motion"),
      m_pass(device,
             {.name = "motion",
              .fragmentSpirv = kOutputMotionFrag,
              .bindings = {vk::DescriptorType::eCombinedImageSampler, vk::DescriptorType::eStorageBuffer,
                           vk::DescriptorType::eStorageBuffer, vk::DescriptorType::eStorageBuffer},
              .format = kMotionFormat}),
      m_deformed(device, m_pass.setLayout(), kMotionFormat, subPixelBits) {}

MotionPass::Inputs MotionPass::makeInputs(const ShadingInputs& shading) const {
    Inputs inputs;
    inputs.m_inputs = m_pass.makeInputs(m_gbuffer, shading.lights());
    makeRoom(inputs, 1, 1); // no buffer is empty
    return inputs;
}

void MotionPass::makeRoom(Inputs& inputs, std::size_t records, std::size_t objects) const {
    if (inputs.m_records.size() < bytesOf(records)) {
        inputs.m_records = makeInput(m_device, bytesOf(records), "motion records");
        inputs.m_inputs.setBuffer(kRecordsBinding, inputs.m_records);
    }
    if (inputs.m_table.size() < objects * sizeof(std::uint32_t)) {
        inputs.m_table = makeInput(m_device, objects * sizeof(std::uint32_t), "motion table");
        const std::span<std::uint32_t> table =
            inputs.m_table.as<std::uint32_t>(inputs.m_table.size() / sizeof(std::uint32_t));
        std::fill(table.begin(), table.end(), 0u);
        inputs.m_inTable.clear();
        inputs.m_inputs.setBuffer(kTableBinding, inputs.m_table);
    }
}

void MotionPass::update(Inputs& inputs, const DrawnScene& drawn, const FrameView& view,
                        const FrameMotion& motion) const {
    const std::size_t objects = motion.moved.empty() ? 1 : motion.moved.back().object + std::size_t{1};
    makeRoom(inputs, motion.moved.size(), objects);
    const std::size_t covered = inputs.m_table.size() / sizeof(std::uint32_t);
    const std::span<std::uint32_t> table = inputs.m_table.as<std::uint32_t>(covered);
    for (const std::uint32_t object : inputs.m_inTable) {
        table[object] = 0;
    }
    inputs.m_inTable.clear();
    const MotionMaker maker(view, motion.cameraBefore, m_image.options().extent);
    auto& header = inputs.m_records.as<shaders::MotionHeader>(1).front();
    header = maker.header(static_cast<std::uint32_t>(covered));
    auto* records = reinterpret_cast<shaders::MotionRecord*>(&header + 1);
    for (const MovedObject& moved : motion.moved) {
        *records++ = maker.record(moved);
        inputs.m_inTable.push_back(moved.object);
        table[moved.object] = static_cast<std::uint32_t>(inputs.m_inTable.size());
    }
    inputs.m_records.flush();
    inputs.m_table.flush();
    inputs.m_deformed = deformedDraws(drawn, motion, maker);
}

void MotionPass::record(vk::CommandBuffer primary, const Inputs& inputs) const {
    m_device.beginLabel(primary, "motion");
    gpu::pipelineBarrier(primary, {attachBarrier(m_image)});
    m_pass.record(primary, inputs.m_inputs, m_image);
    if (!inputs.m_deformed.draws.empty()) {
        gpu::pipelineBarrier(primary, {chainBarrier(m_image)});
        m_deformed.record(primary, inputs.m_deformed, *inputs.m_inputs, m_image);
    }
    gpu::pipelineBarrier(primary, {copyBarrier(m_image, kDrawnColor)});
    m_device.endLabel(primary);
}

std::uint64_t MotionPass::predictBytes(const gpu::Device& device, vk::Extent2D extent) {
    return gpu::predictBytes(device, colorOptions(extent, kMotionFormat));
}

} // namespace cdr::render
