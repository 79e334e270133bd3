#include <cdr/base/format_error.h>
#include <cdr/render/geometry/begin_cascade.h>
#include <cdr/render/submit/facet_draws.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace cdr::render {

namespace {

constexpr std::uint64_t kTexelsPerFacet = 2;

gpu::Buffer makeStream(const gpu::Device& device, std::size_t bytes, vk::BufferUsageFlagBits usage,
                       const char* name) {
    return {device, std::max<std::size_t>(bytes, 1), usage, gpu::MemoryUse::hostWrites, name};
}

/// Bytes that a draw takes at most of the buffer that it takes most of. @param litStride as of bytesPerDraw()
std::uint64_t largestStream(const FacetCounts& most, std::size_t litStride) {
    return std::max({std::uint64_t{most.vertices} * sizeof(shaders::FacetVertex),
                     std::uint64_t{most.indices} * sizeof(std::uint32_t),
                     std::uint64_t{most.vertices} * litStride * sizeof(glm::vec3),
                     litStride > 0 ? 0 : std::uint64_t{most.facets} * sizeof(shaders::FacetRecord),
                     std::uint64_t{1}});
}

} // namespace

std::size_t FacetDraws::mostDraws(std::size_t draws) const {
    if (m_pass.lights()) {
        return std::numeric_limits<std::size_t>::max();
    }
    const FacetCounts& most = m_pass.meshes.most();
    const std::uint64_t maxTexels =
        vk::PhysicalDevice(device().physical()).getProperties().limits.maxTexelBufferElements;
    const std::uint64_t texels = draws * most.facets * kTexelsPerFacet;
    if (texels > maxTexels) {
        throw base::runError("{} draws have facets of {} texels, {} reads {}", draws, texels,
                             device().info().name, maxTexels);
    }
    return maxTexels / kTexelsPerFacet / std::max(most.facets, 1u);
}

void FacetDraws::makeRecords(std::size_t facets) {
    m_facetTexels.reset();
    m_facets = makeStream(device(), std::max<std::size_t>(facets, 1) * sizeof(shaders::FacetRecord),
                          vk::BufferUsageFlagBits::eUniformTexelBuffer, "facets");
    m_facetTexels = vk::Device(device().handle())
                        .createBufferViewUnique({.buffer = m_facets.handle(),
                                                 .format = vk::Format::eR32G32B32A32Uint,
                                                 .range = VK_WHOLE_SIZE});
}

void FacetDraws::makeRoom(std::size_t draws) {
    const FacetCounts& most = m_pass.meshes.most();
    const std::size_t litStride = m_pass.lights() ? FacetLight::strideOf(scene()) : 0;
    if (m_room > 0 && draws <= m_room && most == m_most && litStride == m_litStride) {
        return;
    }
    const gpu::Records held{
        .count = std::max<std::size_t>(draws, 1),
        .bytes = bytesPerDraw(most, litStride),
        .most = std::min<std::uint64_t>(mostDraws(draws),
                                        device().info().maxBufferBytes / largestStream(most, litStride))};
    const std::size_t room = gpu::roomToGrow(device(), held, gpu::MemoryUse::hostWrites,
                                             fmt::format("the facets of {} draws", draws));
    using Usage = vk::BufferUsageFlagBits;
    m_room = 0; // until all is there
    m_vertices = makeStream(device(), room * most.vertices * sizeof(shaders::FacetVertex),
                            Usage::eVertexBuffer, "facet vertices");
    m_indices = makeStream(device(), room * most.indices * sizeof(std::uint32_t), Usage::eIndexBuffer,
                           "facet indices");
    if (m_pass.lights()) {
        m_lit = makeStream(device(), room * most.vertices * litStride * sizeof(glm::vec3),
                           Usage::eVertexBuffer, "light of facets");
    } else {
        makeRecords(room * most.facets);
    }
    m_room = room;
    m_most = most;
    m_litStride = litStride;
}

void FacetDraws::record(vk::CommandBuffer commands, const DrawJob& job, const FrameView& view) const {
    // Indices count from the first vertex of a part.
    const std::uint64_t nameable = std::uint64_t{device().info().maxIndex} + 1;
    const std::size_t most = std::max<std::size_t>(nameable / std::max(m_pass.meshes.most().vertices, 1u), 1);
    for (std::size_t first = job.draws.begin; first < job.draws.end;) {
        const std::size_t end = first + std::min(most, job.draws.end - first);
        recordPart(commands, {.cascade = job.cascade, .draws = {first, end}}, view);
        first = end;
    }
}

void FacetDraws::recordPart(vk::CommandBuffer commands, const DrawJob& job, const FrameView& view) const {
    const FacetCounts& most = m_pass.meshes.most();
    const std::size_t first = job.draws.begin;
    FacetStreams streams{.vertices =
                             static_cast<shaders::FacetVertex*>(m_vertices.mapped()) + first * most.vertices,
                         .indices = static_cast<std::uint32_t*>(m_indices.mapped()) + first * most.indices,
                         .firstFacet = static_cast<std::uint32_t>(first * most.facets),
                         .metallicRoughness = m_pass.pipelines.options().metallicRoughness};
    std::optional<FacetLight> light;
    if (m_pass.lights()) {
        light.emplace(scene(), view.camera);
        streams.lit = static_cast<glm::vec3*>(m_lit.mapped()) + first * most.vertices * light->stride();
        commands.bindVertexBuffers(FacetPipelines::kLitBinding, {m_lit.handle()}, {0});
    } else {
        streams.facets = static_cast<shaders::FacetRecord*>(m_facets.mapped()) + first * most.facets;
    }
    FacetWriter writer(view, job.cascade, streams, light ? &*light : nullptr);

    setCascadeViewport(commands, view, job.cascade);
    commands.bindVertexBuffers(FacetPipelines::kVertexBinding, {m_vertices.handle()}, {0});
    commands.bindIndexBuffer(m_indices.handle(), 0, vk::IndexType::eUint32);
    commands.setCullMode(vk::CullModeFlagBits::eBack);
    commands.setFrontFace(vk::FrontFace::eCounterClockwise);
    const UploadedScene& uploaded = m_pass.uploaded;
    const std::size_t wideBegin = std::clamp(lists().wideBegin(job.cascade), first, job.draws.end);
    std::size_t draw = first;
    for (const auto& [end, span] :
         {std::pair(wideBegin, Span::compact), std::pair(job.draws.end, Span::wide)}) {
        const std::uint32_t firstIndex = writer.counts().indices;
        for (; draw < end; ++draw) {
            const DrawSource& source = uploaded.sources()[lists().instance[draw]];
            const std::uint32_t level = lists().level.empty() ? 0 : lists().level[draw];
            writer.add(m_pass.meshes.solid(source.kind, level), source,
                       uploaded.materials()[source.material]);
        }
        if (const std::uint32_t count = writer.counts().indices - firstIndex; count > 0) {
            bind(commands, span, job.cascade, view);
            commands.drawIndexed(count, 1, static_cast<std::uint32_t>(first * most.indices) + firstIndex,
                                 static_cast<std::int32_t>(first * most.vertices), 0);
        }
    }
}

void FacetDraws::bind(vk::CommandBuffer commands, Span span, std::size_t cascade,
                      const FrameView& view) const {
    const FacetPipelines& pipelines = m_pass.pipelines;
    bindForCascade(commands, pipelines.pipeline(span, FacetLight::litBy(scene())), pipelines.layout(),
                   makeCascadePush(view, cascade));
    if (m_pass.lights()) {
        const double anchorView = view.cascades[cascade].terms.anchorView;
        commands.pushConstants<glm::vec4>(pipelines.layout(), GeometryPipelines::kStages,
                                          shaders::kPushedLightsOffset,
                                          pushedLights(scene(), view.camera, anchorView));
    }
}

void FacetDraws::flush() const {
    m_vertices.flush();
    m_indices.flush();
    (m_pass.lights() ? m_lit : m_facets).flush();
}

} // namespace cdr::render
