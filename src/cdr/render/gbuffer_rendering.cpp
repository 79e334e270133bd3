#include <cdr/gpu/commands.h>
#include <cdr/render/gbuffer_rendering.h>

#include <array>
#include <vector>

namespace cdr::render {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

constexpr auto kDepthStages = Stage::eEarlyFragmentTests | Stage::eLateFragmentTests;
constexpr auto kDepthAccess = Access::eDepthStencilAttachmentRead | Access::eDepthStencilAttachmentWrite;
constexpr auto kColorAccess = Access::eColorAttachmentRead | Access::eColorAttachmentWrite;

/// Barriers only take whole formats, so a stencil plane that comes along is transitioned too.
vk::ImageAspectFlags depthAspects(const gpu::Image& depth) {
    const bool hasStencil = depth.options().format == vk::Format::eD24UnormS8Uint;
    return hasStencil ? vk::ImageAspectFlagBits::eDepth | vk::ImageAspectFlagBits::eStencil
                      : vk::ImageAspectFlags(vk::ImageAspectFlagBits::eDepth);
}

} // namespace

std::vector<vk::ImageMemoryBarrier2> attachBarriers(const GBuffer& gbuffer) {
    std::vector<vk::ImageMemoryBarrier2> barriers;
    for (const gpu::Image& image : gbuffer.images()) {
        barriers.push_back(
            gpu::imageBarrier(image.handle(), vk::ImageAspectFlagBits::eColor, Stage::eAllCommands,
                              Access::eNone, Stage::eColorAttachmentOutput, kColorAccess,
                              vk::ImageLayout::eUndefined, vk::ImageLayout::eColorAttachmentOptimal));
    }
    return barriers;
}

std::vector<vk::ImageMemoryBarrier2> chainBarriers(const GBuffer& gbuffer) {
    std::vector<vk::ImageMemoryBarrier2> barriers;
    for (const gpu::Image& image : gbuffer.images()) {
        barriers.push_back(gpu::imageBarrier(
            image.handle(), vk::ImageAspectFlagBits::eColor, Stage::eColorAttachmentOutput,
            Access::eColorAttachmentWrite, Stage::eColorAttachmentOutput, kColorAccess,
            vk::ImageLayout::eColorAttachmentOptimal, vk::ImageLayout::eColorAttachmentOptimal));
    }
    return barriers;
}

std::vector<vk::ImageMemoryBarrier2> readBarriers(const GBuffer& gbuffer) {
    std::vector<vk::ImageMemoryBarrier2> barriers;
    for (const gpu::Image& image : gbuffer.images()) {
        barriers.push_back(gpu::imageBarrier(
            image.handle(), vk::ImageAspectFlagBits::eColor, Stage::eColorAttachmentOutput,
            Access::eColorAttachmentWrite, Stage::eFragmentShader, Access::eShaderSampledRead,
            vk::ImageLayout::eColorAttachmentOptimal, vk::ImageLayout::eShaderReadOnlyOptimal));
    }
    return barriers;
}

void beginGBuffer(vk::CommandBuffer primary, const GBufferScope& scope) {
    std::vector<vk::ImageMemoryBarrier2> barriers = attachBarriers(scope.gbuffer);
    barriers.push_back(gpu::imageBarrier(
        scope.depth.handle(), depthAspects(scope.depth), kDepthStages, Access::eDepthStencilAttachmentWrite,
        kDepthStages, kDepthAccess, vk::ImageLayout::eUndefined, vk::ImageLayout::eDepthAttachmentOptimal));
    gpu::pipelineBarrier(primary, barriers);
}

void chainGBufferScopes(vk::CommandBuffer primary, const GBufferScope& scope) {
    std::vector<vk::ImageMemoryBarrier2> barriers = chainBarriers(scope.gbuffer);
    barriers.push_back(gpu::imageBarrier(scope.depth.handle(), depthAspects(scope.depth), kDepthStages,
                                         Access::eDepthStencilAttachmentWrite, kDepthStages, kDepthAccess,
                                         vk::ImageLayout::eDepthAttachmentOptimal,
                                         vk::ImageLayout::eDepthAttachmentOptimal));
    gpu::pipelineBarrier(primary, barriers);
}

void runGBufferScope(vk::CommandBuffer primary, const GBufferScope& scope,
                     std::span<const vk::CommandBuffer> secondaries) {
    std::array<vk::RenderingAttachmentInfo, GBuffer::kAttachments> colors;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        colors[i] = {.imageView = scope.gbuffer.images()[i].view(),
                     .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
                     .loadOp = scope.clearColor ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad,
                     .storeOp = vk::AttachmentStoreOp::eStore};
    }
    const vk::RenderingAttachmentInfo depth{
        .imageView = scope.depth.view(),
        .imageLayout = vk::ImageLayout::eDepthAttachmentOptimal,
        .loadOp = vk::AttachmentLoadOp::eClear,
        .storeOp = vk::AttachmentStoreOp::eDontCare,
        .clearValue = vk::ClearDepthStencilValue{.depth = scope.reversedDepth ? 0.0f : 1.0f}};
    primary.beginRendering({.flags = vk::RenderingFlagBits::eContentsSecondaryCommandBuffers,
                            .renderArea = {{0, 0}, scope.gbuffer.images()[0].options().extent},
                            .layerCount = 1,
                            .colorAttachmentCount = static_cast<std::uint32_t>(colors.size()),
                            .pColorAttachments = colors.data(),
                            .pDepthAttachment = &depth});
    if (!secondaries.empty()) {
        primary.executeCommands(static_cast<std::uint32_t>(secondaries.size()), secondaries.data());
    }
    primary.endRendering();
}

} // namespace cdr::render
