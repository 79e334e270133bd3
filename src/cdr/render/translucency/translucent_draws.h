#pragma once

#include <cdr/depth/occupancy.h>
#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/translucency/translucency.h>
#include <cdr/render/translucency/translucent_pipelines.h>
#include <cdr/render/view_transform.h>
#include <cdr/shaders/translucent_shared.h>
#include <cdr/visibility/bin.h>
#include <cdr/visibility/cull.h>

#include <cstdint>
#include <vector>

namespace cdr::render {

/// Where a translucent fragment belongs: to the one range that holds its view distance. Without gap or overlap from the
/// camera's near plane to its far plane. Weighted sums are those of a cascade, so there is one range for each. What is
/// sorted needs one range alone, whatever the mapping: distances are metric, and no depth buffer is asked.
depth::Cascades translucentRanges(const FrameView& view, Translucency method);

/// One frame's translucent draws: culled, binned into ranges and written on the calling thread's time, since
/// they are few, for every submission alike. Within a range they keep scene order. Owned by one frame slot.
class TranslucentDraws {
  public:
    /// What the scene refers to must outlive the draws.
    TranslucentDraws(const gpu::Device& device, const DrawnScene& scene);

    /// Overwrites the lists and records. The last frame that drew them must have finished. base::RunError
    /// when the records need more memory than there is.
    /// @param subPixelBits to which vertices are rounded.
    void prepare(const FrameView& view, Translucency method, std::uint32_t subPixelBits,
                 platform::WorkerPool& workers);

    std::size_t ranges() const { return m_ranges.size(); }
    bool isEmpty(std::size_t range) const { return m_lists.range(range).size() == 0; }
    std::size_t draws() const { return m_lists.draws(); }
    /// Whether a range and a slice of shadows have distances in common.
    bool meets(std::size_t range, const shaders::TranslucentSlice& slice) const;
    /// What prepare() found in view.
    const visibility::VisibleList& visible() const { return m_visible; }

    /// Draws one range. `commands` is inside a rendering scope, with the pipelines' sets from 1 on bound.
    /// @param capacity of the fragment list, if the pipelines fill one.
    /// @param slice of shadows, if the pipelines receive them; else null.
    void record(vk::CommandBuffer commands, std::size_t range, const TranslucentPipelines& pipelines,
                vk::Extent2D extent, std::uint32_t capacity, const shaders::TranslucentSlice* slice) const;

  private:
    bool isIn(std::size_t draw, const shaders::TranslucentSlice* slice) const;
    void writeRecords(const scene::Camera& camera);
    shaders::TranslucentPush pushOf(std::size_t range, vk::Extent2D extent, std::uint32_t capacity) const;

    const gpu::Device& m_device;
    DrawnScene m_scene;
    visibility::VisibleList m_visible; ///< kept from frame to frame so that a warm one allocates nothing
    visibility::DrawLists m_lists;
    depth::Cascades m_ranges;
    scene::Frustum m_frustum;
    double m_nearView = 0.0; ///< the camera's
    std::uint32_t m_subPixelBits = 0;
    gpu::Buffer m_records;
    std::vector<depth::Interval> m_extents; ///< view distances of each draw's instance
};

} // namespace cdr::render
