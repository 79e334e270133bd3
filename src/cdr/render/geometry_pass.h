#pragma once

#include <cdr/base/worker_pool.h>
#include <cdr/depth/technique.h>
#include <cdr/gpu/memory.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/scene/bin.h>
#include <cdr/shaders/shared.h>

#include <vulkan/vulkan.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace cdr::render {

/// A contiguous range of one cascade's draws.
struct DrawJob {
    std::size_t cascade = 0;
    base::IndexRange draws; ///< into scene::DrawLists::instance
};

/// How draws become draw commands. The picture is the same to the bit.
enum class Batching : std::uint8_t {
    perObject, ///< one command per draw
    instanced, ///< one command per run of draws of one kind
};

/// What the draws of one cascade share, on the CPU side.
struct CascadeDraws {
    double anchorView = 0.0;
    shaders::CascadePush push{};
};

/// The pipelines of one technique over one scene, and how its draws are recorded.
class GeometryPass {
  public:
    GeometryPass(const gpu::Device& device, const GpuScene& scene, const depth::Technique& technique);

    /// A descriptor set (0) for a buffer of draw records; the pool must hold one storage buffer per set.
    vk::DescriptorSet makeRecordSet(const gpu::Device& device, vk::DescriptorPool pool,
                                    vk::Buffer records) const;

    /// Everything recording one job reads.
    struct Recording {
        const scene::Camera& camera;
        const scene::DrawLists& lists;
        std::span<const CascadeDraws> cascades;
        std::span<shaders::DrawRecord> records; ///< mapped, one per draw of `lists`
        vk::DescriptorSet recordSet;
        vk::Extent2D extent;
        Batching batching = Batching::instanced;
        base::Trace* trace = nullptr;
    };

    /// Writes the records of a job's draws and their commands. `commands` is a secondary in the recording
    /// state with rendering inherited. Takes no lock and allocates nothing.
    void record(vk::CommandBuffer commands, const DrawJob& job, const Recording& recording) const;

    vk::Format depthFormat() const { return m_depthFormat; }
    /// Instances that span more than this share of their distance are drawn wide: cut, and for log given
    /// their depth, per fragment. Infinity for none.
    double wideSpan(std::size_t cascades) const;

  private:
    using Pipelines = std::array<vk::UniquePipeline, kPipelineVariants>; ///< empty where no kind needs one
    class StateBinder;
    Pipelines makePipelines(const gpu::Device& device, bool wide) const;
    void beginJob(vk::CommandBuffer commands, const CascadeDraws& cascade, const Recording& recording) const;

    const GpuScene& m_scene;
    depth::Mapping m_mapping;
    vk::Format m_depthFormat;
    vk::UniqueDescriptorSetLayout m_recordLayout;
    vk::UniquePipelineLayout m_layout;
    Pipelines m_compact;
    Pipelines m_wide;
    PFN_vkCmdDrawIndexed m_drawIndexed;
};

} // namespace cdr::render
