#include <cdr/gpu/pipeline.h>
#include <cdr/render/translucency/fragment_counter.h>
#include <cdr/render/translucency/translucent_pipelines.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/shaders/translucency.h>
#include <cdr/shaders/translucent_shared.h>

#include <cstddef>

namespace cdr::render {

namespace {

constexpr std::uint32_t kRecordBinding = 1;

/// Of a key, or of a kind's variant.
bool isDetailed(std::uint32_t key) {
    return key >= kDetailStep;
}

std::vector<vk::VertexInputBindingDescription> bindings(std::uint32_t key) {
    std::vector<vk::VertexInputBindingDescription> all{vertexBinding(),
                                                       {.binding = kRecordBinding,
                                                        .stride = sizeof(shaders::TranslucentRecord),
                                                        .inputRate = vk::VertexInputRate::eInstance}};
    if (isDetailed(key)) {
        all.push_back(detailBinding());
    }
    return all;
}

std::vector<vk::VertexInputAttributeDescription> attributes(std::uint32_t key) {
    using shaders::TranslucentRecord;
    constexpr auto kRow = vk::Format::eR32G32B32A32Sfloat;
    std::vector<vk::VertexInputAttributeDescription> all = vertexAttributes();
    if (isDetailed(key)) {
        const std::vector<vk::VertexInputAttributeDescription> more = detailAttributes();
        all.insert(all.end(), more.begin(), more.end());
    }
    all.insert(all.end(),
               {{4, kRecordBinding, kRow, offsetof(TranslucentRecord, right)},
                {5, kRecordBinding, kRow, offsetof(TranslucentRecord, up)},
                {6, kRecordBinding, kRow, offsetof(TranslucentRecord, ahead)},
                {7, kRecordBinding, kRow, offsetof(TranslucentRecord, centreRange)},
                {8, kRecordBinding, vk::Format::eR32G32B32A32Uint, offsetof(TranslucentRecord, id)}});
    return all;
}

/// In a key: some material of the scene is metallic-roughness.
constexpr std::uint32_t kMetallicRoughnessKey = 2;
static_assert((kTexturedVariant & kMetallicRoughnessKey) == 0 && kMetallicRoughnessKey < kDetailStep);

/// What decides a pipeline: whether the kind is textured, whether anything is metallic-roughness, and the parts of the kind's detail.
std::uint32_t keyOf(std::uint32_t variant, bool hasMetallicRoughness) {
    return (variant & kTexturedVariant) + (hasMetallicRoughness ? kMetallicRoughnessKey : 0u) +
           variant / kDetailStep * kDetailStep;
}

} // namespace

TranslucentPipelinesOptions withShaders(TranslucentPipelinesOptions options, const BlendOptions& blend,
                                        const BlendShaders& shaders) {
    const BlendShader& chosen = blend.receivesShadows ? shaders.shadowed : shaders.lit;
    options.fragmentSpirv = chosen.plain;
    options.detailedSpirv = chosen.detailed;
    options.receivesShadows = blend.receivesShadows;
    options.variants = blend.variants;
    if (blend.countsFragments) {
        options.colorFormats.push_back(FragmentCounter::kFormat);
    }
    return options;
}

TranslucentPipelines::TranslucentPipelines(const gpu::Device& device, const UploadedScene& scene,
                                           const TranslucentPipelinesOptions& options)
    : m_device(device),
      m_scene(scene),
      m_options(options),
      m_detailSet(static_cast<std::uint32_t>(1 + options.sets.size())) {
    std::vector<gpu::SetLayout> sets{scene.textureLayout()};
    sets.insert(sets.end(), options.sets.begin(), options.sets.end());
    sets.push_back(scene.detailLayout());
    const std::size_t pushBytes =
        sizeof(shaders::TranslucentPush) + (options.receivesShadows ? sizeof(shaders::TranslucentSlice) : 0);
    m_layout = gpu::makePipelineLayout(
        device, {sets, {{.stageFlags = kStages, .size = static_cast<std::uint32_t>(pushBytes)}}},
        options.name + " layout");
    for (const std::uint32_t variant : options.variants) {
        for (const bool hasMetallicRoughness : {false, true}) { // a world may get the first such material
            provide(keyOf(variant, hasMetallicRoughness));
        }
    }
    for (const std::uint32_t instance : scene.blended()) {
        pipeline(scene.kinds()[scene.sources()[instance].kind]);
    }
}

gpu::Pipeline TranslucentPipelines::make(std::uint32_t key) const {
    return gpu::makeGraphicsPipeline(
        m_device,
        {.name = m_options.name,
         .vertexSpirv = isDetailed(key) ? gpu::Spirv(kTranslucentDetailedVert) : gpu::Spirv(kTranslucentVert),
         .fragmentSpirv = isDetailed(key) ? m_options.detailedSpirv : m_options.fragmentSpirv,
         .constants = {key & kTexturedVariant, (key & kMetallicRoughnessKey) != 0 ? 1u : 0u,
                       m_scene.scene().sky ? 1u : 0u, key / kDetailStep, m_scene.scene().air ? 1u : 0u},
         .layout = m_layout,
         .bindings = bindings(key),
         .attributes = attributes(key),
         .colorFormats = m_options.colorFormats,
         .blend = gpu::Blend::accumulate});
}

vk::Pipeline TranslucentPipelines::pipeline(const DrawKind& kind) const {
    return provide(keyOf(kind.variant, m_scene.hasMetallicRoughness()));
}

vk::Pipeline TranslucentPipelines::provide(std::uint32_t key) const {
    const auto found = m_pipelines.find(key);
    return found != m_pipelines.end() ? *found->second
                                      : *m_pipelines.try_emplace(key, make(key)).first->second;
}

} // namespace cdr::render
