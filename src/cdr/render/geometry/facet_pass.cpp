#include <cdr/render/geometry/begin_cascade.h>
#include <cdr/render/geometry/facet_pass.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace cdr::render {

FacetPass::FacetPass(const gpu::Device& device, const GpuScene& scene, FacetMeshes meshes,
                     const GeometryOptions& options)
    : m_scene(scene),
      m_meshes(std::move(meshes)),
      m_pipelines(device, options) {}

void FacetPass::record(vk::CommandBuffer commands, const DrawJob& job, const Recording& recording) const {
    const visibility::DrawLists& lists = recording.lists;
    const FacetCounts& most = m_meshes.most();
    FacetStreams streams = recording.streams;
    streams.metallicRoughness = m_pipelines.options().metallicRoughness;
    const std::size_t first = job.draws.begin;
    streams.vertices += first * most.vertices;
    streams.indices += first * most.indices;
    streams.facets += lights() ? 0 : first * most.facets;
    streams.firstFacet += static_cast<std::uint32_t>(first * most.facets);
    std::optional<FacetLight> light;
    if (lights()) {
        light.emplace(recording.scene, recording.view.camera);
        streams.lit += first * most.vertices * light->stride();
        commands.bindVertexBuffers(FacetPipelines::kLitBinding, {recording.lit}, {0});
    }
    FacetWriter writer(recording.view, job.cascade, streams, light ? &*light : nullptr);

    setCascadeViewport(commands, recording.view, job.cascade);
    commands.bindVertexBuffers(FacetPipelines::kVertexBinding, {recording.vertices}, {0});
    commands.bindIndexBuffer(recording.indices, 0, vk::IndexType::eUint32);
    commands.setCullMode(vk::CullModeFlagBits::eBack);
    commands.setFrontFace(vk::FrontFace::eCounterClockwise);
    const std::size_t wideBegin = std::clamp(lists.wideBegin(job.cascade), first, job.draws.end);
    std::size_t draw = first;
    for (const auto& [end, span] :
         {std::pair(wideBegin, Span::compact), std::pair(job.draws.end, Span::wide)}) {
        const std::uint32_t firstIndex = writer.counts().indices;
        for (; draw < end; ++draw) {
            const DrawSource& source = m_scene.sources()[lists.instance[draw]];
            const std::uint32_t level = lists.level.empty() ? 0 : lists.level[draw];
            writer.add(m_meshes.solid(source.kind, level), source, m_scene.materials()[source.material]);
        }
        if (const std::uint32_t count = writer.counts().indices - firstIndex; count > 0) {
            bind(commands, span, job.cascade, recording);
            commands.drawIndexed(count, 1, static_cast<std::uint32_t>(first * most.indices) + firstIndex,
                                 static_cast<std::int32_t>(first * most.vertices), 0);
        }
    }
}

void FacetPass::bind(vk::CommandBuffer commands, Span span, std::size_t cascade,
                     const Recording& recording) const {
    bindForCascade(commands, m_pipelines.pipeline(span, FacetLight::litBy(recording.scene)),
                   m_pipelines.layout(), makeCascadePush(recording.view, cascade));
    if (lights()) {
        const double anchorView = recording.view.cascades[cascade].terms.anchorView;
        commands.pushConstants<glm::vec4>(m_pipelines.layout(), GeometryPipelines::kStages,
                                          shaders::kPushedLightsOffset,
                                          pushedLights(recording.scene, recording.view.camera, anchorView));
    }
}

} // namespace cdr::render
