#pragma once

#include <cdr/depth/technique.h>
#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/frame.h>
#include <cdr/render/frame_split.h>
#include <cdr/render/frame_view.h>
#include <cdr/shaders/rivals_shared.h>
#include <cdr/visibility/bin_cells.h>

namespace cdr::rivals {

/// The two pipelines that draw one cascade, and what they share.
struct DrawPipelines {
    vk::PipelineLayout layout;
    vk::Pipeline compact;
    vk::Pipeline
        wide; ///< of instances that span much of their distance, render::wideSpan(); may be null where none do
};

/// What every contender draws in a frame. It is culled, cut and binned as by render::Renderer. Each run of instances that
/// share mesh and sides is one instanced draw. So contenders differ in the depth test alone.
class FrameDraws {
  public:
    static constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;

    /// What the scene refers to, and the workers, must outlive this.
    /// @param technique by which the view is cut into cascades; rivals have one.
    FrameDraws(const gpu::Device& device, const render::DrawnScene& scene, const depth::Technique& technique,
               vk::Extent2D extent, platform::WorkerPool& workers);

    /// Overwrites lists and records; the last frame that drew them must have finished. base::InputError for an unusable
    /// camera, base::RunError where the records do not fit.
    void prepare(const scene::Camera& camera, render::FrameStats& stats);

    const render::FrameView& view() const { return m_view; }
    vk::Extent2D extent() const { return m_extent; }
    /// Of the last prepare(): draws per visible instance.
    double duplication() const { return m_lists.duplication(); }

    /// Sets what stays the same over a rendering scope.
    void begin(vk::CommandBuffer commands) const;
    /// Draws one cascade of prepare() after begin().
    void record(vk::CommandBuffer commands, std::size_t cascade, const DrawPipelines& pipelines,
                const shaders::RivalPush& push = {}) const;

    /// Of the vertices and of the records.
    static std::vector<vk::VertexInputBindingDescription> bindings();
    static std::vector<vk::VertexInputAttributeDescription> attributes();
    /// A CascadePush, and a RivalPush behind it.
    static vk::PushConstantRange pushRange();

  private:
    void cut();
    void writeRecords();

    const gpu::Device& m_device;
    render::DrawnScene m_scene;
    depth::Mapping m_mapping;
    vk::Extent2D m_extent;
    platform::WorkerPool& m_workers;
    render::FrameSplit m_split;
    visibility::VisibleCells
        m_visible; ///< this and what follows is kept, so that a warm frame allocates nothing
    visibility::CellBinner m_binner;
    visibility::DrawLists m_lists;
    render::FrameView m_view;
    gpu::Buffer m_records;
};

} // namespace cdr::rivals
