#pragma once

#include <cdr/depth/mapping.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/shading/anchor_form.h>
#include <cdr/render/shading/fullscreen_pass.h>

#include <cstddef>
#include <cstdint>

namespace cdr::render {

/// Works out ambient occlusion of a final G-buffer over the whole picture, across cascades.
class OcclusionPass {
  public:
    OcclusionPass(const gpu::Device& device, const gpu::Image& gbuffer, depth::Mapping mapping);

    /// @param lights shaders::ShadingHeader and the lights, for the lens, the anchors and the radius.
    PassInputs makeInputs(const gpu::Buffer& lights) const;

    /// Reads the G-buffer in shader read layout and leaves image() so.
    /// @param cascades of the frame.
    void record(vk::CommandBuffer primary, const PassInputs& inputs, std::size_t cascades) const;

    /// 8 bits: 0 is open, 1 is closed.
    const gpu::Image& image() const { return m_image; }

    static std::uint64_t predictBytes(vk::Extent2D extent);

  private:
    const gpu::Image& m_gbuffer;
    gpu::Image m_image;
    ByCascades<FullscreenPass> m_passes;
};

} // namespace cdr::render
