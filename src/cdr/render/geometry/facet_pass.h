#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/geometry/draw_job.h>
#include <cdr/render/geometry/facet_meshes.h>
#include <cdr/render/geometry/geometry_pipelines.h>

#include <utility>

namespace cdr::render {

/// How the draws of one technique are recorded into a visibility buffer.
class FacetPass {
  public:
    /// The scene must outlive the pass.
    FacetPass(const gpu::Device& device, const GpuScene& scene, FacetMeshes meshes,
              const GeometryOptions& options);

    /// Where all of a frame's draws write; each has room for FacetMeshes::most().
    struct Recording {
        const FrameView& view;
        const visibility::DrawLists& lists;
        FacetStreams streams;
        vk::Buffer vertices; ///< what the streams are mapped from
        vk::Buffer indices;
    };

    /// Writes a job's corners, triangles and facets, and draws them by one command, or by two where some draws are
    /// wide. `commands` is recording, inside a rendering scope. Takes no lock and allocates nothing.
    void record(vk::CommandBuffer commands, const DrawJob& job, const Recording& recording) const;

    const FacetMeshes& meshes() const { return m_meshes; }
    /// Draws a scene of a world with other meshes from the next frame on.
    void setMeshes(FacetMeshes meshes) { m_meshes = std::move(meshes); }
    vk::Format depthFormat() const { return m_depthFormat; }
    /// Of the colour attachment; eUndefined where there is none.
    vk::Format surfaceFormat() const;
    depth::Mapping mapping() const { return m_options.technique.mapping; }

  private:
    gpu::Pipeline makePipeline(const gpu::Device& device, Span span) const;
    gpu::Pipeline makeOccluder(const gpu::Device& device, Span span) const;

    const GpuScene& m_scene;
    FacetMeshes m_meshes;
    GeometryOptions m_options;
    vk::Format m_depthFormat;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_compact;
    gpu::Pipeline m_wide;
};

} // namespace cdr::render
