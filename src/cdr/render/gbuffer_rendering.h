#pragma once

#include <cdr/render/gbuffer.h>

#include <vulkan/vulkan.hpp>

#include <span>
#include <vector>

namespace cdr::render {

/// How a rendering scope over a G-buffer and a depth buffer begins.
struct GBufferScope {
    const GBuffer& gbuffer;
    const gpu::Image& depth;
    bool clearColor = true; ///< else what earlier scopes drew stays
    bool reversedDepth = false;
};

/// Makes a G-buffer's images colour attachments, waiting for whoever used them before in this queue. Contents
/// are lost.
std::vector<vk::ImageMemoryBarrier2> attachBarriers(const GBuffer& gbuffer);
/// Lets colour attachments that a rendering scope wrote be attachments of the next one.
std::vector<vk::ImageMemoryBarrier2> chainBarriers(const GBuffer& gbuffer);
/// Hands colour attachments that a rendering scope wrote to fragment shaders that read them.
std::vector<vk::ImageMemoryBarrier2> readBarriers(const GBuffer& gbuffer);

/// Makes the images attachments, waiting for whoever used them before in this queue. Contents are lost.
void beginGBuffer(vk::CommandBuffer primary, const GBufferScope& scope);

/// Lets a further scope over the same images follow one that ended.
void chainGBufferScopes(vk::CommandBuffer primary, const GBufferScope& scope);

/// One rendering scope that clears depth, runs the secondaries and stores the colours.
void runGBufferScope(vk::CommandBuffer primary, const GBufferScope& scope,
                     std::span<const vk::CommandBuffer> secondaries);

} // namespace cdr::render
