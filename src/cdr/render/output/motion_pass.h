#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/output/deformed_motion.h>
#include <cdr/render/output/motion_history.h>
#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/shading/shading_pass.h>
#include <cdr/render/targets/gbuffer.h>

#include <cstdint>
#include <vector>

namespace cdr::render {

/// The format of motion: two floats a pixel. Vulkan requires every device to render to it.
inline constexpr vk::Format kMotionFormat = vk::Format::eR32G32Sfloat;

/// Works out where each pixel's surface was in the last frame, from the G-buffer and from what the CPU says moved. The
/// geometry pass takes no part in it, but meshes that deform are drawn once more.
class MotionPass {
  public:
    /// @param gbuffer of one size with the picture. @param subPixelBits to which vertices are rounded
    MotionPass(const gpu::Device& device, const gpu::Image& gbuffer, std::uint32_t subPixelBits);

    /// What one frame in flight reads.
    class Inputs {
        friend class MotionPass;
        PassInputs m_inputs;
        gpu::Buffer m_records;                ///< a shaders::MotionHeader and records
        gpu::Buffer m_table;                  ///< by object: 0, or 1 + its record
        std::vector<std::uint32_t> m_inTable; ///< objects that have a record
        DeformedDraws m_deformed;
    };
    Inputs makeInputs(const ShadingInputs& shading) const;

    /// The last frame that used the inputs must have finished.
    void update(Inputs& inputs, const DrawnScene& drawn, const FrameView& view,
                const FrameMotion& motion) const;

    /// Reads the G-buffer in shader read layout, and leaves image() in transfer source layout.
    void record(vk::CommandBuffer primary, const Inputs& inputs) const;

    /// Pixels from each surface to where it was, to the right and down; cdr_gbuffer.glsl.
    const gpu::Image& image() const { return m_image; }

    static std::uint64_t predictBytes(const gpu::Device& device, vk::Extent2D extent);

  private:
    void makeRoom(Inputs& inputs, std::size_t records, std::size_t objects) const;

    const gpu::Device& m_device;
    const gpu::Image& m_gbuffer;
    gpu::Image m_image;
    FullscreenPass m_pass;
    DeformedMotion m_deformed;
};

} // namespace cdr::render
