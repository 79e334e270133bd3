#include <cdr/render/renderer_setup.h>
#include <cdr/render/submit/draw_path_factory.h>
#include <cdr/render/submit/facet_draws.h>
#include <cdr/render/submit/gpu_driven_path.h>
#include <cdr/render/submit/primary_path.h>
#include <cdr/render/submit/record_draws.h>
#include <cdr/render/submit/secondary_path.h>

#include <cmath>
#include <utility>

namespace cdr::render {

namespace {

/// Sub-pixels in half the picture.
glm::vec2 subPixelsIn(const RenderOptions& options, std::uint32_t bits) {
    const float perPixel = std::exp2(static_cast<float>(bits));
    return 0.5f * perPixel * glm::vec2(static_cast<float>(options.width), static_cast<float>(options.height));
}

gpu::SetLayout makeOcclusionLayout(const gpu::Device& device, const RenderOptions& options) {
    if (options.submission == Submission::gpuDriven && options.occlusionCulling) {
        return DeviceOcclusion::makeLayout(device);
    }
    return {};
}

} // namespace

DrawPathFactory::DrawPathFactory(const gpu::Device& device, const DrawnScene& scene,
                                 std::optional<FacetMeshes> facets, const RenderOptions& options,
                                 const KeptSurfaces& kept)
    : m_device(device),
      m_scene(scene),
      m_submission(options.submission),
      m_trace(options.trace),
      m_occlusionLayout(makeOcclusionLayout(device, options)),
      m_binning(options.submission == Submission::gpuDriven
                    ? std::make_unique<BinningPass>(device, scene, options.detail.mode, m_occlusionLayout)
                    : nullptr) {
    const GeometryOptions geometry{.technique = options.technique,
                                   // What the device lists, nobody pushes a record for.
                                   .batching = m_binning != nullptr ? Batching::instanced : options.batching,
                                   .metallicRoughness = kept.metallicRoughness,
                                   .emission = kept.emission,
                                   .snapSteps = options.snapBits > 0 ? subPixelsIn(options, options.snapBits)
                                                                     : glm::vec2(0.0f),
                                   .subPixels = options.snapping == Snapping::inPlane
                                                    ? subPixelsIn(options, subPixelBits(device, options))
                                                    : glm::vec2(0.0f),
                                   .subPixelBits = subPixelBits(device, options),
                                   .layers = options.layers,
                                   .variants = variantsOf(options.prepareFor.materials)};
    if (options.occlusionCulling) {
        GeometryOptions depthAlone = geometry;
        depthAlone.output = GeometryOutput::depth;
        depthAlone.batching = Batching::instanced;
        depthAlone.layers = {}; // its pipelines have no depth bias to set
        m_occluders = makePasses(facets, depthAlone);
    }
    if (options.surface == SurfacePath::lit) {
        GeometryOptions lit = geometry;
        lit.output = GeometryOutput::lit;
        lit.finish = options.effects.finish;
        m_lit = makePasses(facets, lit);
    }
    m_surfaces = makePasses(std::move(facets), geometry);
}

DrawPathFactory::HostPasses DrawPathFactory::makePasses(std::optional<FacetMeshes> facets,
                                                        const GeometryOptions& options) const {
    if (facets) {
        return std::make_unique<FacetPass>(
            FacetPass{m_scene.uploaded, std::move(*facets), {m_device, options}});
    }
    return std::make_unique<GeometryPass>(m_device, m_scene.uploaded, options);
}

void DrawPathFactory::followKinds() {
    for (const HostPasses* passes : {&m_surfaces, &m_occluders}) {
        if (auto* geometry = findIn<GeometryPass>(*passes)) {
            geometry->followKinds();
        }
    }
}

void DrawPathFactory::setFacets(const FacetMeshes& facets) {
    for (const HostPasses* passes : {&m_surfaces, &m_occluders, &m_lit}) {
        if (auto* pass = findIn<FacetPass>(*passes)) {
            pass->meshes = facets;
        }
    }
}

const FacetMeshes* DrawPathFactory::facets() const {
    const auto* pass = findIn<FacetPass>(m_surfaces);
    return pass != nullptr ? &pass->meshes : nullptr;
}

std::unique_ptr<HostDraws> DrawPathFactory::makeOccluders(platform::WorkerPool& workers) const {
    return makeDraws(m_occluders, workers);
}

std::unique_ptr<DeviceOcclusion> DrawPathFactory::makeDeviceOcclusion(const depth::Technique& technique,
                                                                      vk::Extent2D extent) const {
    return std::make_unique<DeviceOcclusion>(m_device, *findIn<GeometryPass>(m_occluders), m_occlusionLayout,
                                             technique, extent);
}

std::unique_ptr<HostDraws> DrawPathFactory::makeDraws(const HostPasses& passes,
                                                      platform::WorkerPool& workers) const {
    const HostDrawsContext context{
        .device = m_device, .scene = m_scene.scene, .workers = workers, .trace = m_trace};
    if (auto* facets = findIn<FacetPass>(passes)) {
        return std::make_unique<FacetDraws>(context, *facets);
    }
    return std::make_unique<RecordDraws>(context, *findIn<GeometryPass>(passes));
}

std::unique_ptr<DrawPath> DrawPathFactory::makeRecorded(const HostPasses& passes,
                                                        platform::WorkerPool& workers,
                                                        const std::string& name) const {
    if (m_submission == Submission::primaries) {
        return std::make_unique<PrimaryPath>(m_device, makeDraws(passes, workers), name);
    }
    return std::make_unique<SecondaryPath>(m_device, makeDraws(passes, workers), name);
}

std::unique_ptr<DrawPath> DrawPathFactory::make(platform::WorkerPool& workers, DeviceOcclusion* occlusion,
                                                const std::string& name) const {
    if (m_submission == Submission::gpuDriven) {
        return std::make_unique<GpuDrivenPath>(m_device, *m_binning, *findIn<GeometryPass>(m_surfaces),
                                               occlusion, name);
    }
    return makeRecorded(m_surfaces, workers, name);
}

std::unique_ptr<DrawPath> DrawPathFactory::makeLit(platform::WorkerPool& workers,
                                                   const std::string& name) const {
    return makeRecorded(m_lit, workers, name);
}

} // namespace cdr::render
