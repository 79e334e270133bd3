#pragma once

#include <cdr/gpu/device.h>
#include <cdr/render/geometry/facet_meshes.h>
#include <cdr/render/geometry/facet_pipelines.h>
#include <cdr/render/gpu_scene.h>

#include <utility>

namespace cdr::render {

/// What the draws of one technique are recorded with by facets: into a visibility buffer, into the picture, or for depth alone.
class FacetPass {
  public:
    /// The scene must outlive the pass.
    FacetPass(const gpu::Device& device, const GpuScene& scene, FacetMeshes meshes,
              const GeometryOptions& options)
        : m_scene(scene),
          m_meshes(std::move(meshes)),
          m_pipelines(device, options) {}

    const FacetMeshes& meshes() const { return m_meshes; }
    /// Draws a scene of a world with other meshes from the next frame on.
    void setMeshes(FacetMeshes meshes) { m_meshes = std::move(meshes); }
    const GpuScene& uploaded() const { return m_scene; }
    const FacetPipelines& pipelines() const { return m_pipelines; }
    /// Whether facets are lit while they are drawn; else each has a record.
    bool lights() const { return m_pipelines.options().output == GeometryOutput::lit; }

  private:
    const GpuScene& m_scene;
    FacetMeshes m_meshes;
    FacetPipelines m_pipelines;
};

} // namespace cdr::render
