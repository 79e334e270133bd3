#include <cdr/gpu/pipeline.h>
#include <cdr/render/geometry/begin_cascade.h>
#include <cdr/render/geometry/facet_pass.h>
#include <cdr/render/targets/gbuffer.h>
#include <cdr/shaders/facet_cut_frag.h>
#include <cdr/shaders/facet_cut_vert.h>
#include <cdr/shaders/facet_depth_frag.h>
#include <cdr/shaders/facet_frag.h>
#include <cdr/shaders/facet_occluder_vert.h>
#include <cdr/shaders/facet_vert.h>
#include <cdr/shaders/occluder_frag.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <span>
#include <utility>

namespace cdr::render {

namespace {

constexpr std::uint32_t kVertexBinding = 0;

constexpr vk::VertexInputBindingDescription kBinding{.binding = kVertexBinding,
                                                     .stride = sizeof(shaders::FacetVertex),
                                                     .inputRate = vk::VertexInputRate::eVertex};

std::vector<vk::VertexInputAttributeDescription> attributes() {
    return {{0, kVertexBinding, vk::Format::eR32G32B32Sfloat, offsetof(shaders::FacetVertex, x)},
            {1, kVertexBinding, vk::Format::eR32Uint, offsetof(shaders::FacetVertex, facet)}};
}

} // namespace

FacetPass::FacetPass(const gpu::Device& device, const GpuScene& scene, FacetMeshes meshes,
                     const GeometryOptions& options)
    : m_scene(scene),
      m_meshes(std::move(meshes)),
      m_options(options),
      m_depthFormat(options.output == GeometryOutput::depth
                        ? GeometryPipelines::kOccluderFormat
                        : depthAttachmentFormat(device, options.technique.format, kVisibilityFormat)),
      m_layout(gpu::makePipelineLayout(
          device, {{}, {{.stageFlags = GeometryPipelines::kStages, .size = sizeof(shaders::CascadePush)}}},
          "facet layout")),
      m_compact(options.output == GeometryOutput::depth ? makeOccluder(device, Span::compact)
                                                        : makePipeline(device, Span::compact)),
      m_wide(options.output == GeometryOutput::depth ? makeOccluder(device, Span::wide)
                                                     : makePipeline(device, Span::wide)) {}

vk::Format FacetPass::surfaceFormat() const {
    return m_options.output == GeometryOutput::depth ? vk::Format::eUndefined : kVisibilityFormat;
}

gpu::Pipeline FacetPass::makeOccluder(const gpu::Device& device, Span span) const {
    const bool isWide = span == Span::wide;
    return gpu::makeGraphicsPipeline(device,
                                     {.name = isWide ? "facet occluders, wide" : "facet occluders",
                                      .vertexSpirv = kFacetOccluderVert,
                                      .fragmentSpirv = isWide ? gpu::Spirv(kOccluderFrag) : gpu::Spirv(),
                                      .constants = {shaders::kDepthFormLinear, 0u, 0u, isWide ? 1u : 0u, 0u,
                                                    std::bit_cast<std::uint32_t>(m_options.snapSteps.x),
                                                    std::bit_cast<std::uint32_t>(m_options.snapSteps.y)},
                                      .layout = m_layout,
                                      .bindings = {kBinding},
                                      .attributes = {attributes().front()},
                                      .colorFormats = {},
                                      .depthFormat = m_depthFormat,
                                      .depthCompare = vk::CompareOp::eGreaterOrEqual});
}

gpu::Pipeline FacetPass::makePipeline(const gpu::Device& device, Span span) const {
    const bool isWide = span == Span::wide;
    const std::uint32_t form = depthFormOf(mapping(), span);
    const bool writesDepth = form == shaders::kDepthFormLogFragment;
    const bool cuts = isWide || writesDepth;
    return gpu::makeGraphicsPipeline(
        device,
        {.name = isWide ? "facets, wide" : "facets",
         .vertexSpirv = cuts ? gpu::Spirv(kFacetCutVert) : gpu::Spirv(kFacetVert),
         .fragmentSpirv = writesDepth ? gpu::Spirv(kFacetDepthFrag)
                          : cuts      ? gpu::Spirv(kFacetCutFrag)
                                      : gpu::Spirv(kFacetFrag),
         .constants = {form, 0u, 0u, isWide ? 1u : 0u, 0u,
                       std::bit_cast<std::uint32_t>(m_options.snapSteps.x),
                       std::bit_cast<std::uint32_t>(m_options.snapSteps.y)},
         .layout = m_layout,
         .bindings = {kBinding},
         .attributes = attributes(),
         .colorFormats = {kVisibilityFormat},
         .depthFormat = m_depthFormat,
         .stencil = marksDrawn(m_depthFormat, kVisibilityFormat) ? gpu::Stencil::marks : gpu::Stencil::none,
         .depthCompare = depthCompareOf(mapping())});
}

void FacetPass::record(vk::CommandBuffer commands, const DrawJob& job, const Recording& recording) const {
    const visibility::DrawLists& lists = recording.lists;
    const FacetCounts& most = m_meshes.most();
    FacetStreams streams = recording.streams;
    const std::size_t first = job.draws.begin;
    streams.vertices += first * most.vertices;
    streams.indices += first * most.indices;
    streams.facets += first * most.facets;
    streams.firstFacet += static_cast<std::uint32_t>(first * most.facets);
    FacetWriter writer(recording.view, job.cascade, m_options.shiny, streams);

    setCascadeViewport(commands, recording.view, job.cascade);
    commands.bindVertexBuffers(kVertexBinding, {recording.vertices}, {0});
    commands.bindIndexBuffer(recording.indices, 0, vk::IndexType::eUint32);
    commands.setCullMode(vk::CullModeFlagBits::eBack);
    commands.setFrontFace(vk::FrontFace::eCounterClockwise);
    const std::size_t wideBegin = std::clamp(lists.wideBegin(job.cascade), first, job.draws.end);
    const shaders::CascadePush constants = makeCascadePush(recording.view, job.cascade);
    std::size_t draw = first;
    for (const auto& [end, pipeline] :
         {std::pair(wideBegin, *m_compact), std::pair(job.draws.end, *m_wide)}) {
        const std::uint32_t firstIndex = writer.counts().indices;
        for (; draw < end; ++draw) {
            const DrawSource& source = m_scene.sources()[lists.instance[draw]];
            const std::uint32_t level = lists.level.empty() ? 0 : lists.level[draw];
            writer.add(m_meshes.solid(source.kind, level), source, m_scene.materials()[source.material]);
        }
        if (const std::uint32_t count = writer.counts().indices - firstIndex; count > 0) {
            bindForCascade(commands, pipeline, *m_layout, constants);
            commands.drawIndexed(count, 1, static_cast<std::uint32_t>(first * most.indices) + firstIndex,
                                 static_cast<std::int32_t>(first * most.vertices), 0);
        }
    }
}

} // namespace cdr::render
