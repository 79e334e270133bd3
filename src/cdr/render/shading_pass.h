#pragma once

#include <cdr/render/fullscreen_pass.h>
#include <cdr/render/view_transform.h>
#include <cdr/scene/scene.h>

#include <vulkan/vulkan.hpp>

#include <span>

namespace cdr::render {

/// What lighting reads besides surfaces: one frame slot's lights and anchors.
class ShadingInputs {
  public:
    /// Uploads a frame's; the last frame that used them must have finished.
    void update(const scene::Scene& scene, const scene::Camera& camera, const Lens& lens,
                std::span<const double> anchorsView);

    /// shaders::ShadingHeader and the lights, as shaders/lighting.glsl reads them.
    const gpu::Buffer& lights() const { return m_lights; }

  private:
    friend class ShadingPass;
    gpu::Buffer m_lights;
    PassInputs m_inputs;
};

/// Deferred shading: reads the final G-buffer, sums ambient and point lights.
class ShadingPass {
  public:
    /// @param into what record() writes.
    ShadingPass(const gpu::Device& device, const gpu::Image& gbuffer, const gpu::Image& into);

    /// Inputs for as many lights as the scene has.
    ShadingInputs makeInputs(const scene::Scene& scene) const;

    /// Takes the G-buffer from colour attachment to shader read layout, and leaves the image it writes in
    /// colour attachment layout.
    void record(vk::CommandBuffer primary, const ShadingInputs& inputs) const;

  private:
    const gpu::Device& m_device;
    const gpu::Image& m_gbuffer;
    const gpu::Image& m_into;
    FullscreenPass m_pass;
};

} // namespace cdr::render
