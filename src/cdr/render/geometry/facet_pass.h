#pragma once

#include <cdr/gpu/device.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/geometry/draw_job.h>
#include <cdr/render/geometry/facet_meshes.h>
#include <cdr/render/geometry/facet_pipelines.h>
#include <cdr/scene/scene.h>

#include <utility>

namespace cdr::render {

/// How the draws of one technique are recorded by facets: into a visibility buffer, into the picture, or for depth alone.
class FacetPass {
  public:
    /// The scene must outlive the pass.
    FacetPass(const gpu::Device& device, const GpuScene& scene, FacetMeshes meshes,
              const GeometryOptions& options);

    /// Where all of a frame's draws write; each has room for FacetMeshes::most().
    struct Recording {
        const scene::Scene& scene; ///< whose light it is where facets are lit while they are drawn
        const FrameView& view;
        const visibility::DrawLists& lists;
        FacetStreams streams;
        vk::Buffer vertices; ///< what the streams are mapped from
        vk::Buffer indices;
        vk::Buffer lit{}; ///< null where facets are not lit while they are drawn
    };

    /// Writes a job's corners, triangles and facets, and draws them by one command, or by two where some draws are
    /// wide. `commands` is recording, inside a rendering scope. Takes no lock and allocates nothing.
    void record(vk::CommandBuffer commands, const DrawJob& job, const Recording& recording) const;

    const FacetMeshes& meshes() const { return m_meshes; }
    /// Draws a scene of a world with other meshes from the next frame on.
    void setMeshes(FacetMeshes meshes) { m_meshes = std::move(meshes); }
    /// Of the scope that its draws are in.
    ScopeFormats formats() const { return m_pipelines.formats(); }
    depth::Mapping mapping() const { return m_pipelines.options().technique.mapping; }
    /// Whether facets are lit while they are drawn; else each has a record.
    bool lights() const { return m_pipelines.options().output == GeometryOutput::lit; }

  private:
    void bind(vk::CommandBuffer commands, Span span, std::size_t cascade, const Recording& recording) const;

    const GpuScene& m_scene;
    FacetMeshes m_meshes;
    FacetPipelines m_pipelines;
};

} // namespace cdr::render
