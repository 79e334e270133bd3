#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/host_frame.h>
#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/shading/shading_pass.h>

namespace cdr::render {

/// The format of the depth images that hosts hand in.
inline constexpr vk::Format kHostDepthFormat = vk::Format::eD32Sfloat;

/// Turns a G-buffer into the depth of a host's own camera.
class DepthOutput {
  public:
    explicit DepthOutput(const gpu::Device& device);

    /// What one frame in flight reads.
    PassInputs makeInputs(const gpu::Image& gbuffer, const ShadingInputs& shading) const;

    /// Reads the G-buffer in shader read layout, and leaves the host's image in the layout that it names.
    void record(vk::CommandBuffer primary, const PassInputs& inputs, const HostDepth& into) const;

  private:
    const gpu::Device& m_device;
    FullscreenPass m_pass;
};

} // namespace cdr::render
