#pragma once

#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/geometry/geometry_pass.h>
#include <cdr/render/occluders/occluder_drawing.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace cdr::render {

/// Occlusion culling by the device alone, for gpu-driven draws: BinningPass lists occluders, their depth is drawn here,
/// and BinningPass leaves out what it hides. The CPU waits for nothing. See OcclusionCulling for why the picture stays.
class DeviceOcclusion {
  public:
    /// Of the set that the passes of BinningPass read.
    static gpu::SetLayout makeLayout(const gpu::Device& device);

    /// @param depthPass of GeometryOutput::depth. @param layout made by makeLayout(). Both must outlive this.
    DeviceOcclusion(const gpu::Device& device, const GeometryPass& depthPass, const gpu::SetLayout& layout,
                    const depth::Technique& technique, vk::Extent2D extent);

    /// What one frame slot owns.
    struct Slot {
        gpu::Buffer view;
        std::shared_ptr<const gpu::Buffer> seen{}; ///< a bit for each instance, of all slots
        gpu::DescriptorSet set;
    };
    Slot makeSlot() const;
    /// Writes what the passes read. The slot's last frame must have finished.
    void prepare(const FrameView& view, std::size_t instances, Slot& slot);
    /// Before any pass of the frame.
    void begin(vk::CommandBuffer primary) const;
    /// Draws occluders and works out what they hide.
    void draw(vk::CommandBuffer primary, const Slot& slot, const GeometryPass::IndirectDraws& occluders,
              const FrameView& view) const;
    /// The next frame is culled as a first one.
    void forget() { m_hasSeen = false; }

    static std::uint64_t predictBytes(const gpu::Device& device, vk::Extent2D extent);
    /// base::RunError, with both figures, where the device's limits of shaders do not allow it, or not for such a picture.
    static void requireLimits(const gpu::Device& device, vk::Extent2D extent);

  private:
    void provideSeen(std::size_t instances);

    const gpu::Device& m_device;
    const GeometryPass& m_depthPass;
    gpu::SetLayout m_setLayout;
    depth::Technique m_technique;
    vk::Extent2D m_extent;
    gpu::Image m_depth;
    gpu::Buffer m_copy;
    gpu::Buffer m_tiles;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_reduce;
    gpu::Pipeline m_reduceSquares;
    std::shared_ptr<const gpu::Buffer> m_seen;
    bool m_hasSeen = false;
};

} // namespace cdr::render
