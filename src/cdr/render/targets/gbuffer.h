#pragma once

#include <cdr/depth/format.h>
#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/targets/gbuffer_pixel.h>
#include <cdr/shaders/shared.h>

#include <cstdint>
#include <string>

namespace cdr::render {

/// Format of the geometry buffer, what shading, picking and effects read: one image, 16 bytes per pixel, laid
/// out as shaders/targets/gbuffer.glsl says. Vulkan requires every device to render to it and to sample it.
inline constexpr vk::Format kGBufferFormat = vk::Format::eR32G32B32A32Uint;

/// Format of a visibility buffer, which takes the geometry buffer's place where surfaces are facets. 0 for
/// background, else 1 + the index of a shaders::FacetRecord. Vulkan requires it likewise.
inline constexpr vk::Format kVisibilityFormat = vk::Format::eR32Uint;

/// Format of the picture, which facets that are lit while they are drawn write. Vulkan requires it likewise.
inline constexpr vk::Format kPictureFormat = vk::Format::eR8G8B8A8Srgb;

/// Format of the emission buffer, which lies beside the geometry buffer of scenes that need one: see
/// shaders/targets/emission.glsl. Vulkan requires it likewise.
inline constexpr vk::Format kEmissionFormat = vk::Format::eR32Uint;

static_assert(GBufferPixel::kIdBits == shaders::kIdBits &&
              GBufferPixel::kCascadeMask == shaders::kCascadeMask);

/// Of an image that rendering scopes write, shaders read and copies take.
gpu::ImageOptions colorOptions(vk::Extent2D extent, vk::Format format);
/// Such an image.
/// @param format kGBufferFormat, kVisibilityFormat, kPictureFormat or kEmissionFormat.
gpu::Image makeGBuffer(const gpu::Device& device, vk::Extent2D extent, const std::string& name,
                       vk::Format format = kGBufferFormat);

/// Whether surfaces are in a visibility buffer.
bool isVisibilityBuffer(const gpu::Image& surfaces);

/// Of the depth attachment beside a geometry buffer or a visibility buffer. Beside the latter it has a stencil
/// plane that marks what is drawn, where the device has one. base::InputError where the device lacks the
/// format.
vk::Format depthAttachmentFormat(const gpu::Device& device, depth::DepthFormat format, vk::Format surfaces);
/// Whether a format has a stencil plane, used or not.
bool hasStencil(vk::Format depthAttachment);
/// Whether a depth attachment of that format beside those surfaces marks what is drawn.
bool marksDrawn(vk::Format depthAttachment, vk::Format surfaces);

/// Of a depth attachment. base::InputError where the device lacks the format.
gpu::ImageOptions depthBufferOptions(const gpu::Device& device, vk::Extent2D extent,
                                     depth::DepthFormat format, vk::Format surfaces = kGBufferFormat);
gpu::Image makeDepthBuffer(const gpu::Device& device, vk::Extent2D extent, depth::DepthFormat format,
                           const std::string& name, vk::Format surfaces = kGBufferFormat);

/// Device bytes of a geometry buffer and a depth buffer.
std::uint64_t predictLayerBytes(const gpu::Device& device, vk::Extent2D extent,
                                depth::DepthFormat depthFormat, vk::Format format = kGBufferFormat);

} // namespace cdr::render
