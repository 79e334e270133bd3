#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/stages.h>
#include <cdr/render/targets/gbuffer.h>

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace cdr::render {

class ScopeCommands;

/// How a rendering scope over a G-buffer and a depth buffer begins.
struct GBufferScope {
    const gpu::Image& gbuffer;
    const gpu::Image& depth;
    const gpu::Image* emission = nullptr; ///< beside the G-buffer, and never cleared; null: there is none
    bool keepsColors = false;             ///< that an earlier scope over these images drew
    bool reversedDepth = false;
    glm::vec4 clearColor{0.0f}; ///< of the colours; zeros are 0 in formats of integers too
    const ScopeCommands* zeroFill =
        nullptr; ///< clears the colours, where there is one, as the scope's first draw
    const ScopeCommands* depthClear = nullptr; ///< clears depth between cascades; null: they share it
};

/// The depth attachment if it marks what is drawn, else null.
const gpu::Image* marksOf(const gpu::Image& depth, const gpu::Image& surfaces);

/// Of the attachments of a rendering scope; the colours of surfaces come first. A stencil plane that marks what is drawn is
/// attached too.
struct ScopeFormats {
    std::vector<vk::Format> colors{};
    vk::Format depth = vk::Format::eUndefined;
};

/// Begins a secondary that draws inside such a scope.
void beginSecondary(vk::CommandBuffer secondary, const ScopeFormats& formats,
                    vk::CommandBufferUsageFlags usage);

/// A colour attachment that is kept when its rendering scope ends.
vk::RenderingAttachmentInfo colorAttachment(vk::ImageView view, vk::AttachmentLoadOp load,
                                            const vk::ClearValue& clear = {});

/// A depth attachment, without a stencil plane. @param load what clears, clears to 0.
vk::RenderingAttachmentInfo depthAttachment(vk::ImageView view, vk::AttachmentLoadOp load,
                                            vk::AttachmentStoreOp store = vk::AttachmentStoreOp::eStore);

/// Begins a rendering scope over all of its attachments.
/// @param depth null: there is none; as `stencil`. @param flags whether draws follow in secondaries or in line.
void beginRendering(vk::CommandBuffer commands, vk::Extent2D extent,
                    std::span<const vk::RenderingAttachmentInfo> colors,
                    const vk::RenderingAttachmentInfo* depth = nullptr,
                    const vk::RenderingAttachmentInfo* stencil = nullptr, vk::RenderingFlags flags = {});

/// Makes a G-buffer a colour attachment, waiting for the passes and copies of the renderer that used it before in this queue.
/// Contents are lost. What a host may have read needs waitForHostReads() before.
vk::ImageMemoryBarrier2 attachBarrier(const gpu::Image& gbuffer);
/// Lets a colour attachment that a rendering scope wrote be the attachment of the next one.
vk::ImageMemoryBarrier2 chainBarrier(const gpu::Image& gbuffer);
/// Hands a colour attachment that a rendering scope wrote to fragment shaders that read it.
vk::ImageMemoryBarrier2 readBarrier(const gpu::Image& gbuffer);

/// Hands an image that fragment shaders read, or that a rendering scope wrote, to copies.
vk::ImageMemoryBarrier2 copyBarrier(const gpu::Image& image, const gpu::ImageUse& before = kShaderRead);

/// Lets fragments be tested against marks that a rendering scope made.
vk::ImageMemoryBarrier2 marksBarrier(const gpu::Image& marks);

/// Lets colour attachments that a host may have read, in any stage, be written by what follows. Outside a rendering scope.
void waitForHostReads(vk::CommandBuffer primary);

/// Makes the images attachments, waiting for whoever used them before in this queue. Contents are lost.
void beginGBuffer(vk::CommandBuffer primary, const GBufferScope& scope);

/// Lets a further scope over the same images follow one that ended.
void chainGBufferScopes(vk::CommandBuffer commands, const GBufferScope& scope);

/// Begins a rendering scope that clears depth, and colours unless they are kept, and stores the colours.
/// @param flags whether draws follow in secondaries or in line.
void beginGBufferScope(vk::CommandBuffer primary, const GBufferScope& scope, vk::RenderingFlags flags);

} // namespace cdr::render
