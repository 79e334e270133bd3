#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/draw_source.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/output/motion_history.h>
#include <cdr/render/output/motion_records.h>
#include <cdr/shaders/motion_shared.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::render {

/// The instances of one frame whose meshes have other vertices than in the last one.
struct DeformedDraws {
    struct Draw {
        MeshRange mesh;
        std::size_t firstBefore = 0; ///< of its vertices of the last frame
        shaders::DeformedPush push;
    };
    std::vector<Draw> draws;
    vk::Buffer vertices;
    vk::Buffer verticesBefore;
    vk::Buffer indices;
};

/// What draws those of a frame.
DeformedDraws deformedDraws(const DrawnScene& drawn, const FrameMotion& motion, const MotionMaker& maker);

/// Draws deformed instances once more, to add to the motion of each pixel how its vertices moved in their mesh. A fragment
/// counts where the G-buffer shows its object at its distance.
class DeformedMotion {
  public:
    /// @param set of the motion pass. @param format of its image. @param subPixelBits to which vertices are rounded
    DeformedMotion(const gpu::Device& device, const gpu::SetLayout& set, vk::Format format,
                   std::uint32_t subPixelBits);

    /// Draws into the motion of a frame, in the colour attachment layout. @param set of the motion pass
    void record(vk::CommandBuffer primary, const DeformedDraws& draws, vk::DescriptorSet set,
                const gpu::Image& into) const;

  private:
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_pipeline;
};

} // namespace cdr::render
