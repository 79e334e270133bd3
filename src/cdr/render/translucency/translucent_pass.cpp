#include <cdr/gpu/pipeline.h>
#include <cdr/render/translucency/translucent_pass.h>

#include <algorithm>

namespace cdr::render {

namespace {

constexpr auto kImage = vk::DescriptorType::eCombinedImageSampler;

constexpr auto kBuffer = vk::DescriptorType::eStorageBuffer;
constexpr std::uint32_t kShadowBinding = 2; ///< the first of TranslucentShadows::bind()

std::vector<vk::DescriptorType> surroundingBindings(const Shadows& shadows) {
    return shadows.isOn() ? std::vector{kImage, kBuffer, kImage, kImage, kBuffer}
                          : std::vector{kImage, kBuffer};
}

/// The extent, once the memory for the images is known to be there.
vk::Extent2D checkedExtent(const gpu::Device& device, vk::Extent2D extent,
                           const TranslucencyOptions& options) {
    constexpr std::uint64_t kCountBytes = 2;
    const std::uint64_t counts =
        options.countsFragments ? std::uint64_t{extent.width} * extent.height * kCountBytes : 0;
    gpu::requireDeviceBytes(device, WeightedBlend::predictBytes(extent) + counts, "translucency");
    return extent;
}

std::optional<ListRefusal> refusalOf(const gpu::Device& device, vk::Extent2D extent,
                                     const TranslucencyOptions& options, const Shadows& shadows) {
    if (options.method != Translucency::sorted) {
        return std::nullopt;
    }
    const std::vector<vk::DescriptorType> bindings = surroundingBindings(shadows);
    const auto buffers = std::count(bindings.begin(), bindings.end(), kBuffer);
    return FragmentList::refusal(device, extent, options.maxBytes, static_cast<std::uint32_t>(buffers));
}

} // namespace

TranslucentPass::TranslucentPass(const gpu::Device& device, const DrawnScene& scene,
                                 const gpu::Image& gbuffer, const gpu::Image& lit,
                                 const TranslucencyOptions& options, const Shadows& shadows,
                                 const std::vector<std::uint32_t>& variants)
    : m_device(device),
      m_scene(scene),
      m_gbuffer(gbuffer),
      m_lit(lit),
      m_options(options),
      m_shadows(shadows),
      m_sampler(vk::Device(device.handle()).createSamplerUnique({})),
      m_surroundingsLayout(
          gpu::makeSetLayout(device, {surroundingBindings(shadows), vk::ShaderStageFlagBits::eFragment},
                             "translucent surroundings")),
      m_weighted(device, scene.uploaded, m_surroundingsLayout,
                 checkedExtent(device, m_lit.options().extent, options),
                 {options.countsFragments, shadows.isOn(), variants}),
      m_refusal(refusalOf(device, m_lit.options().extent, options, shadows)),
      m_counter(options.countsFragments ? std::make_unique<FragmentCounter>(device, m_lit.options().extent)
                                        : nullptr) {
    if (options.method == Translucency::sorted && !m_refusal) {
        m_sorted =
            std::make_unique<SortedBlend>(device, scene.uploaded, m_surroundingsLayout,
                                          BlendOptions{options.countsFragments, shadows.isOn(), variants});
    }
}

TranslucentPass::Slot TranslucentPass::makeSlot(const ShadingInputs& shading) const {
    Slot slot{.draws = TranslucentDraws(m_device, m_scene),
              .surroundings = {m_device, m_surroundingsLayout},
              .revision = 0};
    slot.surroundings.setImage(0, m_gbuffer.view(), *m_sampler);
    slot.surroundings.setBuffer(1, shading.lights());
    if (m_shadows.isOn()) {
        slot.shadows.emplace(m_device, m_scene, m_shadows);
    }
    if (m_sorted != nullptr) {
        slot.list.emplace(m_device, m_sorted->listLayout(), m_lit.options().extent, m_options.maxBytes);
    }
    return slot;
}

void TranslucentPass::prepare(Slot& slot, const FrameView& view, AfterRefusal afterRefusal,
                              std::uint32_t subPixelBits, platform::WorkerPool& workers) const {
    slot.revision = m_scene.uploaded.revision();
    slot.refusal = m_refusal;
    if (afterRefusal == AfterRefusal::weighted && m_noRoom && m_noRoom->revision == slot.revision) {
        slot.refusal = m_noRoom->refusal;
    }
    if (methodOf(slot) == Translucency::sorted) {
        slot.refusal = slot.list->begin();
    }
    slot.draws.prepare(view, methodOf(slot), subPixelBits, workers);
    if (slot.shadows) {
        slot.shadows->prepare(view, slot.draws.visible(), subPixelBits, workers);
        slot.shadows->bind(slot.surroundings, kShadowBinding, *m_sampler);
    }
}

void TranslucentPass::prepareAgain(Slot& slot, const FrameView& view, std::uint32_t subPixelBits,
                                   platform::WorkerPool& workers) const {
    if (methodOf(slot) != m_options.method) {
        slot.draws.prepare(view, methodOf(slot), subPixelBits, workers);
    }
}

void TranslucentPass::record(vk::CommandBuffer primary, Slot& slot) const {
    if (m_counter != nullptr) {
        m_counter->begin(primary);
    }
    const TranslucentFrame frame{.draws = slot.draws,
                                 .surroundings = *slot.surroundings,
                                 .lit = m_lit,
                                 .counter = m_counter.get(),
                                 .shadows = slot.shadows ? &*slot.shadows : nullptr};
    if (methodOf(slot) == Translucency::sorted) {
        m_sorted->record(primary, frame, *slot.list);
    } else {
        m_weighted.record(primary, frame);
    }
}

TranslucencyStats TranslucentPass::decided(const Slot& slot) const {
    const Translucency method = methodOf(slot);
    return {.method = method,
            .draws = slot.draws.draws(),
            .bytes = method == Translucency::sorted ? slot.list->bytes()
                                                    : WeightedBlend::predictBytes(m_lit.options().extent),
            .refusal = slot.refusal};
}

bool TranslucentPass::settle(Slot& slot, TranslucencyStats& stats) {
    if (methodOf(slot) == Translucency::weighted) {
        return true;
    }
    stats.fragments = slot.list->count();
    if (stats.fragments <= slot.list->capacity()) {
        m_noRoom.reset();
        return true;
    }
    slot.refusal = slot.list->grow(stats.fragments);
    if (slot.refusal) {
        m_noRoom = {.refusal = *slot.refusal, .revision = slot.revision};
    }
    stats.bytes = slot.list->bytes();
    return false;
}

void TranslucentPass::recordReadback(vk::CommandBuffer primary) const {
    if (m_counter != nullptr) {
        m_counter->recordReadback(primary);
    }
}

} // namespace cdr::render
