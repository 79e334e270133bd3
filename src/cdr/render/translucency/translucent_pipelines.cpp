#include <cdr/gpu/pipeline.h>
#include <cdr/render/translucency/translucent_pipelines.h>
#include <cdr/shaders/translucent_shared.h>
#include <cdr/shaders/translucent_vert.h>

#include <cstddef>

namespace cdr::render {

namespace {

constexpr std::uint32_t kRecordBinding = 1;

std::vector<vk::VertexInputAttributeDescription> attributes() {
    using shaders::TranslucentRecord;
    constexpr auto kRow = vk::Format::eR32G32B32A32Sfloat;
    std::vector<vk::VertexInputAttributeDescription> all = vertexAttributes();
    for (const vk::VertexInputAttributeDescription& attribute :
         {vk::VertexInputAttributeDescription{4, kRecordBinding, kRow, offsetof(TranslucentRecord, right)},
          {5, kRecordBinding, kRow, offsetof(TranslucentRecord, up)},
          {6, kRecordBinding, kRow, offsetof(TranslucentRecord, ahead)},
          {7, kRecordBinding, kRow, offsetof(TranslucentRecord, centreRange)},
          {8, kRecordBinding, vk::Format::eR32G32B32A32Uint, offsetof(TranslucentRecord, id)}}) {
        all.push_back(attribute);
    }
    return all;
}

} // namespace

TranslucentPipelines::TranslucentPipelines(const gpu::Device& device, const GpuScene& scene,
                                           const TranslucentPipelinesOptions& options) {
    std::vector<vk::DescriptorSetLayout> sets{scene.textureLayout()};
    sets.insert(sets.end(), options.sets.begin(), options.sets.end());
    m_layout = gpu::makePipelineLayout(device, sets,
                                       {{.stageFlags = kStages, .size = sizeof(shaders::TranslucentPush)}},
                                       options.name + " layout");
    for (std::uint32_t textured = 0; textured < m_pipelines.size(); ++textured) {
        m_pipelines[textured] =
            gpu::makeGraphicsPipeline(device, {.name = options.name,
                                               .vertexSpirv = kTranslucentVert,
                                               .fragmentSpirv = options.fragmentSpirv,
                                               .constants = {textured, scene.isShiny() ? 1u : 0u},
                                               .layout = *m_layout,
                                               .bindings = {vertexBinding(),
                                                            {.binding = kRecordBinding,
                                                             .stride = sizeof(shaders::TranslucentRecord),
                                                             .inputRate = vk::VertexInputRate::eInstance}},
                                               .attributes = attributes(),
                                               .colorFormats = options.colorFormats,
                                               .blend = gpu::Blend::accumulate});
    }
}

} // namespace cdr::render
