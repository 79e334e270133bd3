#pragma once

#include <cdr/gpu/pipeline.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/geometry/facet_pass.h>
#include <cdr/render/geometry/geometry_pass.h>
#include <cdr/render/occluders/device_occlusion.h>
#include <cdr/render/render_options.h>
#include <cdr/render/submit/binning_pass.h>
#include <cdr/render/submit/host_draws.h>
#include <cdr/render/submit/one_of.h>

#include <memory>
#include <optional>
#include <string>

namespace cdr::render {

struct KeptSurfaces;

/// Makes the draw paths of a renderer's frame slots, all by one submission, and owns what they share.
class DrawPathFactory {
  public:
    /// What the scene refers to must outlive the factory. base::InputError for a depth format that
    /// the device lacks, and for a submission it cannot do. base::RunError when its memory does not
    /// suffice.
    /// @param facets what is drawn by facets; empty for a G-buffer.
    DrawPathFactory(const gpu::Device& device, const DrawnScene& scene, std::optional<FacetMeshes> facets,
                    const RenderOptions& options, const KeptSurfaces& kept);

    /// The factory and the workers must outlive the path.
    /// @param name that captures show.
    /// @param occlusion of gpu-driven draws with RenderOptions::occlusionCulling, else null. It must outlive the path.
    std::unique_ptr<DrawPath> make(platform::WorkerPool& workers, DeviceOcclusion* occlusion,
                                   const std::string& name) const;

    /// With SurfacePath::lit: a path whose draws are lit, into the picture. Those of make() fill a visibility buffer.
    std::unique_ptr<DrawPath> makeLit(platform::WorkerPool& workers, const std::string& name) const;

    /// With RenderOptions::occlusionCulling: the draws of occluders by the CPU, or culling by the device.
    std::unique_ptr<HostDraws> makeOccluders(platform::WorkerPool& workers) const;
    std::unique_ptr<DeviceOcclusion> makeDeviceOcclusion(const depth::Technique& technique,
                                                         vk::Extent2D extent) const;

    /// Makes the pipelines of draw kinds that came to the scene; those that are there stay.
    void followKinds();
    /// What is drawn by facets is now this.
    void setFacets(const FacetMeshes& facets);
    /// The same, as it is; null for a G-buffer.
    const FacetMeshes* facets() const;

  private:
    /// What draws of the CPU are recorded with: the first for a G-buffer, the second for a visibility buffer or lit into the
    /// picture.
    using HostPasses = OneOf<GeometryPass, FacetPass>;
    HostPasses makePasses(std::optional<FacetMeshes> facets, const GeometryOptions& options) const;
    std::unique_ptr<HostDraws> makeDraws(const HostPasses& passes, platform::WorkerPool& workers) const;
    /// Not gpu-driven.
    std::unique_ptr<DrawPath> makeRecorded(const HostPasses& passes, platform::WorkerPool& workers,
                                           const std::string& name) const;

    const gpu::Device& m_device;
    DrawnScene m_scene;
    Submission m_submission;
    platform::Trace* m_trace;
    gpu::SetLayout m_occlusionLayout;       ///< for Submission::gpuDriven with occlusion culling
    std::unique_ptr<BinningPass> m_binning; ///< for Submission::gpuDriven
    HostPasses m_surfaces;
    HostPasses m_occluders; ///< none without occlusion culling
    HostPasses m_lit;       ///< none but for SurfacePath::lit
};

} // namespace cdr::render
