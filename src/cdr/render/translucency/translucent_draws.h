#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/translucency/translucent_pipelines.h>
#include <cdr/render/view_transform.h>
#include <cdr/shaders/translucent_shared.h>
#include <cdr/visibility/bin.h>
#include <cdr/visibility/blended.h>

#include <vulkan/vulkan.hpp>

#include <cstdint>
#include <vector>

namespace cdr::render {

/// Where a translucent fragment belongs: to the one range that holds its view distance. Without gap or
/// overlap from the camera's near plane to its far plane, one per cascade, whatever the cascades leave out.
depth::Cascades translucentRanges(const depth::Cascades& cascades, const scene::Camera& camera);

/// One frame's translucent draws: culled, binned into ranges and written on the calling thread's time, since
/// they are few, for every submission alike. Within a range they keep scene order. Owned by one frame slot.
class TranslucentDraws {
  public:
    /// The scene parts must outlive the draws.
    TranslucentDraws(const gpu::Device& device, const GpuScene& scene,
                     const visibility::BlendedInstances& blended);

    /// Overwrites the lists and records; the last frame that drew them must have finished. base::RunError,
    /// with both figures, when the records need more memory than there is.
    void prepare(const scene::Camera& camera, double aspect, const depth::Cascades& cascades,
                 host::WorkerPool& workers);

    std::size_t ranges() const { return m_ranges.size(); }
    bool isEmpty(std::size_t range) const { return m_lists.range(range).size() == 0; }
    std::size_t draws() const { return m_lists.draws(); }

    /// Draws one range. `commands` is inside a rendering scope, with the pipelines' sets from 1 on bound.
    /// @param capacity of the fragment list, if the pipelines fill one.
    void record(vk::CommandBuffer commands, std::size_t range, const TranslucentPipelines& pipelines,
                vk::Extent2D extent, std::uint32_t capacity) const;

  private:
    void growRecords();
    void writeRecords(const scene::Camera& camera);
    shaders::TranslucentPush pushOf(std::size_t range, vk::Extent2D extent, std::uint32_t capacity) const;

    const gpu::Device& m_device;
    const GpuScene& m_scene;
    const visibility::BlendedInstances& m_blended;
    visibility::VisibleList m_visible; ///< kept from frame to frame so that a warm one allocates nothing
    visibility::DrawLists m_lists;
    depth::Cascades m_ranges;
    Lens m_lens;
    double m_nearView = 0.0; ///< the camera's
    gpu::Buffer m_records;
};

} // namespace cdr::render
