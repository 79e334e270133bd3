#include <cdr/render/translucent_pass.h>


namespace cdr::render {

namespace {

/// The extent, once the memory for the images is known to be there.
vk::Extent2D checkedExtent(const gpu::Device& device, vk::Extent2D extent, bool countsCoverage) {
    constexpr std::uint64_t kCountBytes = 2;
    const std::uint64_t counts = countsCoverage ? std::uint64_t{extent.width} * extent.height * kCountBytes : 0;
    gpu::requireDeviceBytes(device, WeightedBlend::predictBytes(extent) + counts, "translucency");
    return extent;
}

std::string refusalOf(const gpu::Device& device, vk::Extent2D extent, const TranslucencyOptions& options) {
    if (options.method != Translucency::sorted) {
        return {};
    }
    if (!device.info().hasFragmentStores) {
        return device.info().name + " lacks fragmentStoresAndAtomics";
    }
    return FragmentList::refusal(device, extent, options.mostBytes).value_or("");
}

} // namespace

TranslucentPass::TranslucentPass(const gpu::Device& device, const scene::Scene& scene,
                                 const GpuScene& gpuScene, const ShadingPass& shading,
                                 const TranslucencyOptions& options)
    : m_device(device),
      m_gpuScene(gpuScene),
      m_lit(shading.lit()),
      m_options(options),
      m_blended(scene::blendedInstances(scene)),
      m_weighted(device, gpuScene, shading.setLayout(),
                 checkedExtent(device, m_lit.options().extent, options.countsCoverage),
                 m_lit.options().format, options.countsCoverage),
      m_refusal(refusalOf(device, m_lit.options().extent, options)),
      m_coverage(options.countsCoverage ? std::make_unique<Coverage>(device, m_lit.options().extent)
                                        : nullptr) {
    if (options.method == Translucency::sorted && m_refusal.empty()) {
        m_sorted = std::make_unique<SortedBlend>(device, gpuScene, shading.setLayout(),
                                                 m_lit.options().format, options.countsCoverage);
    }
}

TranslucentPass::Slot TranslucentPass::makeSlot() const {
    Slot slot{.draws = TranslucentDraws(m_device, m_gpuScene, m_blended), .list = {}, .note = {}};
    if (m_sorted != nullptr) {
        slot.list.emplace(m_device, m_sorted->listLayout(), m_lit.options().extent, m_options.mostBytes);
    }
    return slot;
}

void TranslucentPass::prepare(Slot& slot, const scene::Camera& camera, const depth::Cascades& cascades,
                              base::WorkerPool& workers) const {
    const vk::Extent2D extent = m_lit.options().extent;
    const double aspect = static_cast<double>(extent.width) / static_cast<double>(extent.height);
    slot.draws.prepare(camera, aspect, cascades, workers);
    slot.note = m_refusal;
}

void TranslucentPass::record(vk::CommandBuffer primary, Slot& slot, const ShadingInputs& shading) const {
    if (m_coverage != nullptr) {
        m_coverage->begin(primary);
    }
    const TranslucentFrame frame{.draws = slot.draws,
                                 .surroundings = shading.set(),
                                 .lit = m_lit,
                                 .coverage = m_coverage.get()};
    if (sorts(slot)) {
        slot.list->resetCount();
        m_sorted->record(primary, frame, *slot.list);
    } else {
        m_weighted.record(primary, frame);
    }
}

bool TranslucentPass::settle(Slot& slot, TranslucencyStats& stats) const {
    const bool sorted = sorts(slot);
    const std::uint32_t fragments = sorted ? slot.list->count() : 0;
    if (sorted && fragments > slot.list->capacity()) {
        slot.note = slot.list->grow(fragments).value_or("");
        return false;
    }
    stats = {.method = sorted ? Translucency::sorted : Translucency::weighted,
             .draws = slot.draws.draws(),
             .fragments = fragments,
             .bytes = sorted ? slot.list->bytes() : WeightedBlend::predictBytes(m_lit.options().extent),
             .note = slot.note};
    return true;
}

void TranslucentPass::recordReadback(vk::CommandBuffer primary) const {
    if (m_coverage != nullptr) {
        m_coverage->recordReadback(primary);
    }
}

} // namespace cdr::render
