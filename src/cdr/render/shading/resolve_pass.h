#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/shading/shading_pass.h>

namespace cdr::render {

/// Makes the G-buffer that a visibility buffer stands for, for those who read it back.
class ResolvePass {
  public:
    ResolvePass(const gpu::Device& device, const gpu::Image& visibility);

    PassInputs makeInputs(const ShadingInputs& shading) const;

    /// Reads the visibility buffer in shader read layout and leaves gbuffer() so.
    void record(vk::CommandBuffer primary, PassInputs& inputs, vk::BufferView facets) const;

    const gpu::Image& gbuffer() const { return m_gbuffer; }

  private:
    const gpu::Device& m_device;
    const gpu::Image& m_visibility;
    gpu::Image m_gbuffer;
    FullscreenPass m_pass;
};

} // namespace cdr::render
