#pragma once

#include "read_spirv.h"

#include <cdr/gpu/commands.h>
#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>

#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace cdr::render_test {

/// What a compute shader of 64 threads a group makes of two storage buffers, bindings 0 and 1, into a third.
template <typename Made, typename Constants, typename Item>
std::vector<Made> compute(const gpu::Device& device, const char* shader, std::span<const Constants> constants,
                          std::span<const Item> items, std::size_t count) {
    const std::vector bindings(3, vk::DescriptorType::eStorageBuffer);
    const auto setLayout =
        gpu::makeSetLayout(device, {bindings, vk::ShaderStageFlagBits::eCompute}, "compute");
    const auto layout = gpu::makePipelineLayout(device, {{setLayout}, {}}, "compute");
    const auto pipeline = gpu::makeComputePipeline(device, {"compute", readSpirv(shader), layout});
    const gpu::DescriptorSet set(device, setLayout);
    constexpr auto kUsage = vk::BufferUsageFlagBits::eStorageBuffer;
    const gpu::Buffer first(device, constants.size_bytes(), kUsage, gpu::MemoryUse::hostWrites, "constants");
    const gpu::Buffer second(device, items.size_bytes(), kUsage, gpu::MemoryUse::hostWrites, "items");
    std::vector<Made> made(count);
    const gpu::Buffer out(device, count * sizeof(Made), kUsage, gpu::MemoryUse::hostReads, "made");
    std::memcpy(first.mapped(), constants.data(), constants.size_bytes());
    std::memcpy(second.mapped(), items.data(), items.size_bytes());
    first.flush();
    second.flush();
    set.setBuffer(0, first);
    set.setBuffer(1, second);
    set.setBuffer(2, out);
    gpu::runOnce(device, [&](vk::CommandBuffer commands) {
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline);
        commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout, 0, *set, {});
        commands.dispatch(static_cast<std::uint32_t>((count + 63) / 64), 1, 1);
        gpu::pipelineBarrier(commands, {},
                             {{.srcStageMask = vk::PipelineStageFlagBits2::eComputeShader,
                               .srcAccessMask = vk::AccessFlagBits2::eShaderStorageWrite,
                               .dstStageMask = vk::PipelineStageFlagBits2::eHost,
                               .dstAccessMask = vk::AccessFlagBits2::eHostRead}});
    });
    out.invalidate();
    std::memcpy(made.data(), out.mapped(), count * sizeof(Made));
    return made;
}

} // namespace cdr::render_test
