#pragma once

#include "read_image.h"

#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/renderer.h>

#include <array>
#include <cstdint>

namespace cdr::render_test {

/// A host that has frames recorded into its own command buffers and images, and submits them itself.
class HostSide {
  public:
    HostSide(const gpu::Device& device, vk::Extent2D extent,
             vk::Format colorFormat = vk::Format::eR8G8B8A8Srgb);

    /// A frame that goes into this host's images, not yet recorded; its commands are recording.
    render::HostFrame begin();
    /// The host's depth image, for HostFrame::depth: reversed, of an infinite far plane.
    render::HostDepth depth(double nearView) const;
    /// Ends the commands of begin() and submits them.
    void submit();
    /// The same once a renderer has recorded into them.
    void submit(render::Renderer& renderer, const scene::Camera& camera, const render::HostFrame& frame) {
        renderer.record(camera, frame);
        submit();
    }

    /// What the last submitted frame left, once it ran.
    template <typename Pixel>
    image::Raster<Pixel> color() const {
        return readImage<Pixel>(m_device, m_color.handle(), m_extent, VK_IMAGE_LAYOUT_GENERAL);
    }
    image::Raster<float> depthValues() const {
        return readImage<float>(m_device, m_depth.handle(), m_extent, VK_IMAGE_LAYOUT_GENERAL,
                                vk::ImageAspectFlagBits::eDepth);
    }

  private:
    const gpu::Device& m_device;
    vk::Extent2D m_extent;
    gpu::Image m_color;
    gpu::Image m_depth;
    gpu::CommandPool m_pool;
    vk::UniqueSemaphore m_done;
    std::uint64_t m_frames = 0;
    vk::CommandBuffer m_commands;
};

/// Shaders of a host that make four corners from push constants: CascadeConstants, a vec4, and two names.
struct HostShaders {
    const char* vertexPath; ///< of SPIR-V
    const char* fragmentPath;
};
inline constexpr HostShaders kSquare{CDR_HOST_SURFACE_VERT, CDR_HOST_SURFACE_FRAG};
inline constexpr HostShaders kSquareHlsl{CDR_HOST_SURFACE_VERT_HLSL, CDR_HOST_SURFACE_FRAG_HLSL};
inline constexpr HostShaders kGround{CDR_HOST_GROUND_VERT, CDR_HOST_GROUND_FRAG};
inline constexpr HostShaders kGroundHlsl{CDR_HOST_GROUND_VERT_HLSL, CDR_HOST_GROUND_FRAG_HLSL};

/// Draws rectangles of a host's inside cascades, as src/examples/host_compositing does.
class HostRectangles {
  public:
    /// @param format of the cascades' depth
    HostRectangles(const gpu::Device& device, vk::Format format, const HostShaders& shaders = kSquare);

    /// One that faces the camera, for kSquare.
    struct Square {
        double x = 0.0; ///< view space
        double distanceView = 0.0;
        double halfSide = 0.0;
        std::uint32_t object = 0;
    };
    void draw(const render::HostCascade& cascade, const Square& square) const;

    /// @param place as the shaders take it
    void draw(const render::HostCascade& cascade, const std::array<double, 4>& place,
              std::uint32_t object) const;

  private:
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_pipeline;
};

} // namespace cdr::render_test
