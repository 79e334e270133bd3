#pragma once

#include <vulkan/vulkan_core.h>

#include <span>
#include <vector>

namespace cdr::render {

/// What a submitted frame waits for before it writes images, and what it signals once they are written.
struct FrameSync {
    /// Before anything runs that Surfaces shows. Uploads of a world, and occluders that the CPU tests by, may run earlier.
    std::span<const VkSemaphoreSubmitInfo> waits{};
    std::span<const VkSemaphoreSubmitInfo> signals{}; ///< once its images are written
};

/// An image, one level, layer and sample, and how a frame leaves it. From Renderer::surfaces() it is the renderer's own.
struct SurfaceImage {
    VkImage image = VK_NULL_HANDLE;                   ///< null: there is none
    VkImageView view = VK_NULL_HANDLE;                ///< of all of it
    VkFormat format = VK_FORMAT_UNDEFINED;            ///< of image and view
    VkExtent2D extent{};                              ///< in pixels
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED; ///< that the frame leaves it in
};

/// A submitted or recorded frame on the device. The images may be sampled and copied from, in any layout: a frame takes them as
/// they are. All frames of a renderer share them, so the next one writes over them. It runs after what its queue was given
/// before, and after FrameSync::waits.
struct Surfaces {
    SurfaceImage color; ///< sRGB, 8 bits
    SurfaceImage
        gbuffer; ///< a GBufferPixel each; no image but for SurfacePath::gbuffer, since the others keep no G-buffer
    /// VK_FORMAT_R32G32_SFLOAT, as cdr_gbuffer.glsl reads it; no image unless RenderOptions::motion.
    SurfaceImage motion{};
    /// VK_FORMAT_R16G16B16A16_SFLOAT: linear light with Rec. 709 primaries, before exposure; alpha means nothing. No image unless
    /// RenderOptions::linear.
    SurfaceImage linear{};
    /// By cascade: what is added to GBufferPixel::ahead for the view distance.
    std::vector<double> anchorsView;
};

} // namespace cdr::render
