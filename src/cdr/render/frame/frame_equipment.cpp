#include <cdr/render/choose_facets.h>
#include <cdr/render/frame/frame_equipment.h>
#include <cdr/render/renderer_setup.h>

#include <algorithm>
#include <utility>

namespace cdr::render {

namespace {

/// Whether pipelines are for one size, since they snap vertices.
bool snapsVertices(const RenderOptions& options) {
    return options.snapBits > 0 || options.snapping == Snapping::inPlane;
}

} // namespace

FrameEquipment::FrameEquipment(const gpu::Device& device, const DrawnScene& drawn,
                               platform::WorkerPool& workers, const RenderOptions& options)
    : m_device(device),
      m_drawn(drawn),
      m_workers(workers),
      m_options(options),
      m_needs(needsOf(drawn, options)) {
    checkedExtent(device, options, m_needs.traits());
    m_paths = makePaths(m_needs, options);
    m_passes = std::make_unique<FramePasses>(device, drawn, options, m_needs, *m_paths, workers);
    m_slots = makeSlots(options, *m_paths, *m_passes);
}

FrameEquipment::Made FrameEquipment::resized(std::uint32_t width, std::uint32_t height) const {
    RenderOptions resized = m_options;
    resized.width = width;
    resized.height = height;
    return make(m_needs, resized);
}

void FrameEquipment::giveLightRoom(std::size_t lights) {
    const std::size_t most = std::max(lights, ShadingPass::maxLights(m_device));
    m_slots->giveLightRoom(*m_passes, std::min(lights + lights / 2, most));
}

FrameEquipment::Made FrameEquipment::make(const SceneNeeds& needs, const RenderOptions& options) const {
    const bool snapsAnew = snapsVertices(options) && options != m_options;
    Made made{.needs = needs, .options = options, .paths = nullptr, .passes = nullptr, .slots = nullptr};
    if (needs.kept != m_needs.kept || snapsAnew) {
        made.paths = makePaths(needs, options);
    }
    const DrawPathFactory& used = made.paths != nullptr ? *made.paths : *m_paths;
    made.passes = std::make_unique<FramePasses>(m_device, m_drawn, options, needs, used, m_workers);
    made.slots = makeSlots(options, used, *made.passes);
    return made;
}

void FrameEquipment::take(Made made) {
    // What was there before ends with this function: slots first, since they refer to the rest.
    m_needs = made.needs;
    m_options = std::move(made.options);
    m_slots.swap(made.slots);
    m_passes.swap(made.passes);
    if (made.paths != nullptr) {
        m_paths.swap(made.paths);
    }
}

std::unique_ptr<DrawPathFactory> FrameEquipment::makePaths(const SceneNeeds& needs,
                                                           const RenderOptions& options) const {
    return std::make_unique<DrawPathFactory>(m_device, m_drawn, chooseFacets(m_drawn, options), options,
                                             needs.kept);
}

std::unique_ptr<SlotRing> FrameEquipment::makeSlots(const RenderOptions& options,
                                                    const DrawPathFactory& paths,
                                                    const FramePasses& passes) const {
    const std::size_t lightRoom =
        std::max<std::size_t>(m_drawn.scene.lights.size(), options.prepareFor.lights);
    return std::make_unique<SlotRing>(m_device, options, paths, passes, m_workers, lightRoom);
}

} // namespace cdr::render
