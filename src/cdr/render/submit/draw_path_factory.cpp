#include <cdr/base/error.h>
#include <cdr/render/submit/draw_path_factory.h>
#include <cdr/render/submit/facet_draws.h>
#include <cdr/render/submit/gpu_driven_path.h>
#include <cdr/render/submit/primary_path.h>
#include <cdr/render/submit/record_draws.h>
#include <cdr/render/submit/secondary_path.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cdr::render {

namespace {

/// Sub-pixels in half the picture.
glm::vec2 snapStepsOf(const RenderOptions& options) {
    const float perPixel = options.snapBits == 0 ? 0.0f : std::exp2(static_cast<float>(options.snapBits));
    return 0.5f * perPixel * glm::vec2(static_cast<float>(options.width), static_cast<float>(options.height));
}

std::uint32_t subPixelBitsOf(const gpu::Device& device, const RenderOptions& options) {
    const std::uint32_t ofDevice = device.info().subPixelBits;
    return options.snapBits == 0 ? ofDevice : std::min(options.snapBits, ofDevice);
}

} // namespace

DrawPathFactory::DrawPathFactory(const gpu::Device& device, const DrawnScene& scene,
                                 std::optional<FacetMeshes> facets, const RenderOptions& options, bool shiny)
    : m_device(device),
      m_scene(scene),
      m_submission(options.submission),
      m_trace(options.trace),
      m_binning(options.submission == Submission::gpuDriven
                    ? std::make_unique<BinningPass>(device, scene, options.detail.mode)
                    : nullptr) {
    const GeometryOptions geometry{.technique = options.technique,
                                   .batching = options.batching,
                                   .shiny = shiny,
                                   .snapSteps = snapStepsOf(options),
                                   .subPixelBits = subPixelBitsOf(device, options),
                                   .layers = options.layers};
    if (facets) {
        m_facets = std::make_unique<FacetPass>(device, scene.uploaded, std::move(*facets), geometry);
    } else {
        m_geometry = std::make_unique<GeometryPass>(device, scene.uploaded, geometry);
    }
}

void DrawPathFactory::followKinds() {
    if (m_geometry != nullptr) {
        m_geometry->followKinds();
    }
}

std::unique_ptr<HostDraws> DrawPathFactory::makeDraws(host::WorkerPool& workers) const {
    const HostDrawsContext context{
        .device = m_device, .scene = m_scene.scene, .workers = workers, .trace = m_trace};
    if (m_facets != nullptr) {
        return std::make_unique<FacetDraws>(context, *m_facets);
    }
    return std::make_unique<RecordDraws>(context, *m_geometry);
}

std::unique_ptr<DrawPath> DrawPathFactory::make(host::WorkerPool& workers, const std::string& name) const {
    switch (m_submission) {
    case Submission::secondaries:
        return std::make_unique<SecondaryPath>(m_device, makeDraws(workers), name);
    case Submission::primaries:
        return std::make_unique<PrimaryPath>(m_device, makeDraws(workers), name);
    case Submission::gpuDriven:
        return std::make_unique<GpuDrivenPath>(m_device, *m_binning, *m_geometry, name);
    }
    throw base::RunError("submission out of range");
}

} // namespace cdr::render
