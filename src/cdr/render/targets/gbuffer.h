#pragma once

#include <cdr/depth/format.h>
#include <cdr/gpu/memory.h>
#include <cdr/render/targets/gbuffer_pixel.h>
#include <cdr/shaders/shared.h>

#include <glm/glm.hpp>
#include <vulkan/vulkan.hpp>

#include <cstdint>
#include <string>

namespace cdr::render {

/// Format of the geometry buffer, what shading, picking and effects read: one image, 16 bytes per pixel, laid
/// out as shaders/targets/gbuffer.glsl says. Vulkan requires every device to render to it and to sample it.
inline constexpr vk::Format kGBufferFormat = vk::Format::eR32G32B32A32Uint;

static_assert(GBufferPixel::kIdBits == shaders::kIdBits &&
              GBufferPixel::kCascadeMask == shaders::kCascadeMask);

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
