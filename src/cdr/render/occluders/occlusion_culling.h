#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/submit/secondary_path.h>
#include <cdr/visibility/depth_tiles.h>
#include <cdr/visibility/occluders.h>

#include <cstdint>
#include <memory>

namespace cdr::render {

/// Takes out of a frame what its opaque surfaces hide. What the last frame showed is drawn first, depth alone; what lies
/// behind that in all its pixels is hidden. The picture is the same to the bit, since the rest is drawn as without it.
/// Waits for the device, so frames in flight follow one another.
class OcclusionCulling {
  public:
    /// @param draws of the technique, of GeometryOutput::depth.
    OcclusionCulling(const gpu::Device& device, const DrawnScene& drawn, const depth::Technique& technique,
                     vk::Extent2D extent, std::unique_ptr<HostDraws> draws);

    /// @param view whose cascades are cut.
    /// @param visible what was culled for it.
    /// @return what was drawn first.
    OccluderStats drop(const FrameView& view, platform::WorkerPool& workers,
                       visibility::VisibleCells& visible);
    /// The next frame is culled as a first one.
    void forget() { m_occluders.forget(); }

    static std::uint64_t predictBytes(const gpu::Device& device, vk::Extent2D extent);

  private:
    void drawDepth(const FrameView& view, const visibility::VisibleCells& occluders, OccluderStats& stats);

    const gpu::Device& m_device;
    DrawnScene m_drawn;
    depth::Technique m_technique;
    vk::Extent2D m_extent;
    SecondaryPath m_path;
    gpu::Image m_depth;
    gpu::Buffer m_copy;
    vk::UniqueFence m_done;
    visibility::Occluders m_occluders;
    visibility::DepthTiles m_tiles;
};

} // namespace cdr::render
