#pragma once

#include <cdr/depth/format.h>
#include <cdr/gpu/memory.h>
#include <cdr/shaders/shared.h>

#include <glm/glm.hpp>
#include <vulkan/vulkan.hpp>

#include <cstdint>
#include <string>

namespace cdr::render {

/// Format of the geometry buffer, what shading, picking and effects read: one image, 16 bytes per pixel, laid
/// out as shaders/targets/gbuffer.glsl says. Vulkan requires every device to render to it and to sample it.
inline constexpr vk::Format kGBufferFormat = vk::Format::eR32G32B32A32Uint;

/// One pixel of it.
struct GBufferPixel {
    std::uint32_t albedo = 0; ///< square root of linear, three unorm8; above them shineCode() or occlusion
    std::uint32_t normal = 0; ///< view space, octahedral, two snorm16
    float ahead = 0.0f; ///< view distance beyond the cascade's anchor plane: metric, whatever the mapping
    std::uint32_t idAndCascade = 0; ///< shaders::kIdBits; 0 is background

    /// Object index + 1, 0 for background.
    std::uint32_t id() const { return idAndCascade & shaders::kIdMask; }
    /// The cascade that drew it; 0 for background.
    std::uint32_t cascade() const { return (idAndCascade >> shaders::kIdBits) & shaders::kCascadeMask; }
    /// Unit normal in view space; zero for background.
    glm::vec3 normalView() const;
};
static_assert(sizeof(GBufferPixel) == 16);

gpu::ImageOptions gbufferOptions(vk::Extent2D extent);
gpu::Image makeGBuffer(const gpu::Device& device, vk::Extent2D extent, const std::string& name);

/// Of a depth attachment. base::InputError where the device lacks the format.
gpu::ImageOptions depthBufferOptions(const gpu::Device& device, vk::Extent2D extent,
                                     depth::DepthFormat format);
gpu::Image makeDepthBuffer(const gpu::Device& device, vk::Extent2D extent, depth::DepthFormat format,
                           const std::string& name);

/// Device bytes of a geometry buffer and a depth buffer.
std::uint64_t predictLayerBytes(const gpu::Device& device, vk::Extent2D extent, depth::DepthFormat format);

} // namespace cdr::render
