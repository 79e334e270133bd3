#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/geometry/draw_job.h>
#include <cdr/render/geometry/geometry_pipelines.h>
#include <cdr/shaders/shared.h>
#include <cdr/visibility/bin.h>

#include <cstdint>
#include <span>

namespace cdr::render {

class UploadedScene;

/// How the draws of one technique over one scene are recorded.
class GeometryPass {
  public:
    GeometryPass(const gpu::Device& device, const UploadedScene& scene, const GeometryOptions& options);

    /// Everything recording one job reads.
    struct Recording {
        const FrameView& view;
        const visibility::DrawLists& lists;
        std::span<const float> radii;           ///< scene::Instances::radius
        std::span<shaders::DrawRecord> records; ///< mapped, one per draw of `lists`
        vk::Buffer recordBuffer;                ///< they are in
    };

    /// Writes the records of a job's draws and their commands. `commands` is recording, inside a rendering
    /// scope. Takes no lock and allocates nothing.
    void record(vk::CommandBuffer commands, const DrawJob& job, const Recording& recording) const;

    /// Consecutive runs of instances between which nothing is bound, drawn by one command per bucket.
    struct RunGroup {
        std::size_t begin = 0; ///< run
        std::size_t end = 0;
        std::uint32_t kind = 0; ///< into UploadedScene::kinds(), for what is bound
    };

    /// Draws that the device itself has listed.
    struct IndirectDraws {
        vk::Buffer commands; ///< by bucket (as in visibility::DrawLists), then run
        vk::Buffer counts;   ///< by bucket, then group
        std::size_t runs = 0;
        std::span<const RunGroup> groups;
        vk::Buffer records;
    };

    /// Draws one cascade from lists on the device.
    void recordIndirect(vk::CommandBuffer commands, const FrameView& view, std::size_t cascade,
                        const IndirectDraws& draws) const;

    const GeometryPipelines& pipelines() const { return m_pipelines; }
    /// Makes the pipelines of draw kinds that came to the scene.
    void followKinds() { m_pipelines.follow(m_device, m_scene); }

  private:
    class CutDraws;
    class StateBinder;
    void beginJob(vk::CommandBuffer commands, const FrameView& view, std::size_t cascade,
                  vk::Buffer records) const;
    void push(vk::CommandBuffer commands, const shaders::DrawRecord& record) const;
    /// Of a run of clusters, or of the mesh at a level.
    LevelRange indicesOf(const MeshRange& mesh, std::uint32_t level,
                         const visibility::ClusterRun& clusters) const;

    const gpu::Device& m_device;
    const UploadedScene& m_scene;
    Batching m_batching;
    GeometryPipelines m_pipelines;
    // Asked of the device, which saves a jump through the loader at every draw.
    PFN_vkCmdDrawIndexed m_drawIndexed;
    PFN_vkCmdPushConstants m_pushConstants;
};

} // namespace cdr::render
