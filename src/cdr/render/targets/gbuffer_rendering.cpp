#include <cdr/gpu/commands.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/render/targets/scope_commands.h>

#include <array>
#include <vector>

namespace cdr::render {

namespace {

constexpr gpu::ImageUse kAttachedColor{PipelineStage::eColorAttachmentOutput,
                                       Access::eColorAttachmentRead | Access::eColorAttachmentWrite,
                                       vk::ImageLayout::eColorAttachmentOptimal};

/// Barriers only take whole formats, so a stencil plane that comes along is transitioned too.
vk::ImageAspectFlags depthAspects(const gpu::Image& depth) {
    return hasStencil(depth.options().format)
               ? vk::ImageAspectFlagBits::eDepth | vk::ImageAspectFlagBits::eStencil
               : vk::ImageAspectFlags(vk::ImageAspectFlagBits::eDepth);
}

vk::AttachmentLoadOp loadOf(const GBufferScope& scope) {
    if (scope.keepsColors) {
        return vk::AttachmentLoadOp::eLoad;
    }
    return scope.zeroFill != nullptr ? vk::AttachmentLoadOp::eDontCare : vk::AttachmentLoadOp::eClear;
}

/// Makes the images of a scope attachments. @param colorBarrier of the colours. @param depthLayout of depth before
void handOver(vk::CommandBuffer commands, const GBufferScope& scope,
              vk::ImageMemoryBarrier2 (*colorBarrier)(const gpu::Image&), vk::ImageLayout depthLayout) {
    std::vector<vk::ImageMemoryBarrier2> barriers{
        colorBarrier(scope.gbuffer),
        gpu::imageBarrier(scope.depth.handle(), depthAspects(scope.depth),
                          {kDepthStages, Access::eDepthStencilAttachmentWrite, depthLayout},
                          {kDepthStages, kDepthAccess, vk::ImageLayout::eAttachmentOptimal})};
    if (scope.emission != nullptr) {
        barriers.push_back(colorBarrier(*scope.emission));
    }
    gpu::pipelineBarrier(commands, barriers);
}

vk::ClearColorValue clearValueOf(const glm::vec4& color) {
    return std::array{color.r, color.g, color.b, color.a};
}

} // namespace

const gpu::Image* marksOf(const gpu::Image& depth, const gpu::Image& surfaces) {
    return marksDrawn(depth.options().format, surfaces.options().format) ? &depth : nullptr;
}

vk::ImageMemoryBarrier2 marksBarrier(const gpu::Image& marks) {
    return gpu::imageBarrier(
        marks.handle(), depthAspects(marks),
        {kDepthStages, Access::eDepthStencilAttachmentWrite, vk::ImageLayout::eAttachmentOptimal},
        {kDepthStages, Access::eDepthStencilAttachmentRead, vk::ImageLayout::eAttachmentOptimal});
}

void beginSecondary(vk::CommandBuffer secondary, const ScopeFormats& formats,
                    vk::CommandBufferUsageFlags usage) {
    const bool marks = !formats.colors.empty() && marksDrawn(formats.depth, formats.colors.front());
    const vk::CommandBufferInheritanceRenderingInfo rendering{
        .colorAttachmentCount = static_cast<std::uint32_t>(formats.colors.size()),
        .pColorAttachmentFormats = formats.colors.data(),
        .depthAttachmentFormat = formats.depth,
        .stencilAttachmentFormat = marks ? formats.depth : vk::Format::eUndefined,
        .rasterizationSamples = vk::SampleCountFlagBits::e1};
    const vk::CommandBufferInheritanceInfo inheritance{.pNext = &rendering};
    secondary.begin({.flags = usage | vk::CommandBufferUsageFlagBits::eRenderPassContinue,
                     .pInheritanceInfo = &inheritance});
}

vk::RenderingAttachmentInfo colorAttachment(vk::ImageView view, vk::AttachmentLoadOp load,
                                            const vk::ClearValue& clear) {
    return {.imageView = view,
            .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
            .loadOp = load,
            .storeOp = vk::AttachmentStoreOp::eStore,
            .clearValue = clear};
}

vk::RenderingAttachmentInfo depthAttachment(vk::ImageView view, vk::AttachmentLoadOp load,
                                            vk::AttachmentStoreOp store) {
    return {.imageView = view,
            .imageLayout = vk::ImageLayout::eAttachmentOptimal,
            .loadOp = load,
            .storeOp = store,
            .clearValue = vk::ClearDepthStencilValue{.depth = 0.0f}};
}

void beginRendering(vk::CommandBuffer commands, vk::Extent2D extent,
                    std::span<const vk::RenderingAttachmentInfo> colors,
                    const vk::RenderingAttachmentInfo* depth, const vk::RenderingAttachmentInfo* stencil,
                    vk::RenderingFlags flags) {
    commands.beginRendering({.flags = flags,
                             .renderArea = {{0, 0}, extent},
                             .layerCount = 1,
                             .colorAttachmentCount = static_cast<std::uint32_t>(colors.size()),
                             .pColorAttachments = colors.data(),
                             .pDepthAttachment = depth,
                             .pStencilAttachment = stencil});
}

vk::ImageMemoryBarrier2 attachBarrier(const gpu::Image& gbuffer) {
    // The last frame's was shaded from or copied, and nobody need have read it at all.
    constexpr auto kUsers =
        PipelineStage::eColorAttachmentOutput | PipelineStage::eFragmentShader | PipelineStage::eAllTransfer;
    return gpu::imageBarrier(gbuffer.handle(), vk::ImageAspectFlagBits::eColor,
                             {kUsers, Access::eColorAttachmentWrite, vk::ImageLayout::eUndefined},
                             kAttachedColor);
}

vk::ImageMemoryBarrier2 chainBarrier(const gpu::Image& gbuffer) {
    return gpu::imageBarrier(gbuffer.handle(), vk::ImageAspectFlagBits::eColor, kDrawnColor, kAttachedColor);
}

vk::ImageMemoryBarrier2 readBarrier(const gpu::Image& gbuffer) {
    return gpu::imageBarrier(gbuffer.handle(), vk::ImageAspectFlagBits::eColor, kDrawnColor, kShaderRead);
}

vk::ImageMemoryBarrier2 copyBarrier(const gpu::Image& image, const gpu::ImageUse& before) {
    return gpu::imageBarrier(image.handle(), vk::ImageAspectFlagBits::eColor, before, kCopied);
}

void waitForHostReads(vk::CommandBuffer primary) {
    gpu::memoryBarrier(primary, PipelineStage::eAllCommands, Access::eNone,
                       PipelineStage::eColorAttachmentOutput, Access::eNone);
}

void beginGBuffer(vk::CommandBuffer primary, const GBufferScope& scope) {
    handOver(primary, scope, attachBarrier, vk::ImageLayout::eUndefined);
}

void chainGBufferScopes(vk::CommandBuffer commands, const GBufferScope& scope) {
    handOver(commands, scope, chainBarrier, vk::ImageLayout::eAttachmentOptimal);
}

void beginGBufferScope(vk::CommandBuffer primary, const GBufferScope& scope, vk::RenderingFlags flags) {
    std::vector colors{colorAttachment(scope.gbuffer.view(), loadOf(scope), clearValueOf(scope.clearColor))};
    if (scope.emission != nullptr) {
        colors.push_back(colorAttachment(scope.emission->view(), scope.keepsColors
                                                                     ? vk::AttachmentLoadOp::eLoad
                                                                     : vk::AttachmentLoadOp::eDontCare));
    }
    const vk::RenderingAttachmentInfo depth{
        .imageView = scope.depth.view(),
        .imageLayout = vk::ImageLayout::eAttachmentOptimal,
        .loadOp = vk::AttachmentLoadOp::eClear,
        .storeOp = vk::AttachmentStoreOp::eDontCare,
        .clearValue = vk::ClearDepthStencilValue{.depth = scope.reversedDepth ? 0.0f : 1.0f}};
    const vk::RenderingAttachmentInfo stencil{.imageView = scope.depth.view(),
                                              .imageLayout = vk::ImageLayout::eAttachmentOptimal,
                                              .loadOp = scope.keepsColors ? vk::AttachmentLoadOp::eLoad
                                                                          : vk::AttachmentLoadOp::eClear,
                                              .storeOp = vk::AttachmentStoreOp::eStore};
    const bool marks = marksOf(scope.depth, scope.gbuffer) != nullptr;
    beginRendering(primary, scope.gbuffer.options().extent, colors, &depth, marks ? &stencil : nullptr,
                   flags);
    if (!scope.keepsColors && scope.zeroFill != nullptr) {
        scope.zeroFill->putInto(primary, flags);
    }
}

} // namespace cdr::render
