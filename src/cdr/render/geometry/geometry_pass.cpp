#include <cdr/gpu/pipeline.h>
#include <cdr/render/geometry/begin_cascade.h>
#include <cdr/render/geometry/geometry_pass.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/render/view_transform.h>
#include <cdr/visibility/chunk_test.h>

#include <algorithm>
#include <cstddef>

namespace cdr::render {

namespace {

/// Far enough ahead that memory answers in time.
constexpr std::size_t kPrefetchDraws = 8;

template <typename Function>
Function deviceFunction(const gpu::Device& device, const char* name) {
    return reinterpret_cast<Function>(vk::Device(device.handle()).getProcAddr(name));
}

} // namespace

GeometryPass::GeometryPass(const gpu::Device& device, const UploadedScene& scene,
                           const GeometryOptions& options)
    : m_device(device),
      m_scene(scene),
      m_batching(options.batching),
      m_pipelines(device, scene, options),
      m_drawIndexed(deviceFunction<PFN_vkCmdDrawIndexed>(device, "vkCmdDrawIndexed")),
      m_pushConstants(deviceFunction<PFN_vkCmdPushConstants>(device, "vkCmdPushConstants")) {}

void GeometryPass::beginJob(vk::CommandBuffer commands, const FrameView& view, std::size_t cascade,
                            vk::Buffer records) const {
    setCascadeViewport(commands, view, cascade);
    commands.bindVertexBuffers(0, {m_scene.vertices(), records}, {0, 0});
    if (const vk::Buffer details = m_scene.details()) {
        commands.bindVertexBuffers(kDetailBinding, details, vk::DeviceSize{0});
    }
    commands.bindIndexBuffer(m_scene.indices(), 0, vk::IndexType::eUint32);
}

/// Binds what a kind needs and is not bound yet.
class GeometryPass::StateBinder {
  public:
    StateBinder(const GeometryPipelines& pipelines, vk::CommandBuffer commands,
                const shaders::CascadePush& constants)
        : m_pipelines(pipelines),
          m_commands(commands),
          m_constants(constants) {}

    void bind(const DrawKind& kind, Span span) {
        const vk::Pipeline pipeline = m_pipelines.pipeline(kind.variant, span);
        if (pipeline != m_pipeline) {
            bindForCascade(m_commands, pipeline, m_pipelines.layout(), m_constants);
            m_pipeline = pipeline;
            m_layer = {}; // a pipeline without a depth bias takes it away
        }
        if ((kind.variant & kLayeredVariant) != 0 && kind.layer != m_layer) {
            setLayer(kind.layer);
        }
        if (kind.textureSet != m_textureSet) {
            m_commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, m_pipelines.layout(), 0,
                                          kind.textureSet, {});
            m_textureSet = kind.textureSet;
        }
        if (kind.detailSet && kind.detailSet != m_detailSet) {
            m_commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, m_pipelines.layout(), 1,
                                          kind.detailSet, {});
            m_detailSet = kind.detailSet;
        }
        if (m_doubleSided != static_cast<int>(kind.doubleSided)) {
            m_commands.setCullMode(kind.doubleSided ? vk::CullModeFlagBits::eNone
                                                    : vk::CullModeFlagBits::eBack);
            m_doubleSided = static_cast<int>(kind.doubleSided);
        }
        if (m_mirrored != static_cast<int>(kind.mirrored)) {
            // glTF's front faces run counterclockwise on screen, and a mirror turns them round.
            m_commands.setFrontFace(kind.mirrored ? vk::FrontFace::eClockwise
                                                  : vk::FrontFace::eCounterClockwise);
            m_mirrored = static_cast<int>(kind.mirrored);
        }
    }

  private:
    static constexpr int kUnset = -1;

    void setLayer(const LayerPlace& layer) {
        m_layer = layer;
        const LayerOptions& options = m_pipelines.layers();
        if (options.method == LayerMethod::polygonOffset) {
            const float towards = depth::isReversed(m_pipelines.mapping()) ? layer.rank : -layer.rank;
            m_commands.setDepthBias(towards * options.constantFactor, 0.0f, towards * options.slopeFactor);
            return;
        }
        m_commands.pushConstants<float>(m_pipelines.layout(), GeometryPipelines::kStages,
                                        offsetof(shaders::CascadePush, layerOffset),
                                        {layer.offset, layer.rank});
    }

    const GeometryPipelines& m_pipelines;
    vk::CommandBuffer m_commands;
    shaders::CascadePush m_constants;
    vk::Pipeline m_pipeline;
    vk::DescriptorSet m_textureSet;
    vk::DescriptorSet m_detailSet;
    LayerPlace m_layer;
    int m_doubleSided = kUnset;
    int m_mirrored = kUnset;
};

/// Which draws of a cascade are large meshes that reach out of it, and what it shows of them.
class GeometryPass::CutDraws {
  public:
    CutDraws(const UploadedScene& scene, const Recording& recording, std::size_t cascade)
        : m_scene(scene),
          m_recording(recording),
          m_test(recording.view.camera, recording.view.frustum, recording.view.cascades[cascade].clipRange,
                 recording.view.cascades[cascade].terms.anchorView) {}

    bool isCut(std::size_t draw) const {
        const DrawKind& kind = kindOf(draw);
        // A layer moves a surface along the view distance.
        return kind.mesh.chunkCount > 0 && (kind.variant & kLayeredVariant) == 0 && isWholeMesh(draw) &&
               !m_test.holdsAll(placed(draw));
    }
    template <typename Draw>
    void forEachRun(std::size_t draw, const Draw& drawRun) const {
        const MeshRange& mesh = kindOf(draw).mesh;
        const visibility::ChunkTest::Placed instance = placed(draw);
        visibility::forEachSeenRun(
            m_scene.chunksOf(mesh), mesh.indexCount,
            [&](const visibility::MeshChunk& chunk) { return m_test.mayShow(instance, chunk); }, drawRun);
    }

  private:
    const DrawSource& sourceOf(std::size_t draw) const {
        return m_scene.sources()[m_recording.lists.instance[draw]];
    }
    const DrawKind& kindOf(std::size_t draw) const { return m_scene.kinds()[sourceOf(draw).kind]; }
    /// Rather than a coarser level, or clusters.
    bool isWholeMesh(std::size_t draw) const {
        const visibility::DrawLists& lists = m_recording.lists;
        return (lists.level.empty() || lists.level[draw] == 0) &&
               (lists.runs.empty() || lists.runs[draw].indexCount == 0);
    }
    visibility::ChunkTest::Placed placed(std::size_t draw) const {
        const DrawSource& source = sourceOf(draw);
        return m_test.placed(source.position, source.basis,
                             m_recording.radii[m_recording.lists.instance[draw]]);
    }

    const UploadedScene& m_scene;
    const Recording& m_recording;
    visibility::ChunkTest m_test;
};

void GeometryPass::record(vk::CommandBuffer commands, const DrawJob& job, const Recording& recording) const {
    const std::size_t wideBegin = recording.lists.wideBegin(job.cascade);
    const std::uint32_t* instances = recording.lists.instance.data();
    const std::uint8_t* levels = recording.lists.level.empty() ? nullptr : recording.lists.level.data();
    const visibility::ClusterRun* runs = recording.lists.runs.empty() ? nullptr : recording.lists.runs.data();
    const DrawSource* sources = m_scene.sources().data();
    const MaterialWords* materials = m_scene.materials().data();
    const DrawKind* kinds = m_scene.kinds().data();
    beginJob(commands, recording.view, job.cascade, recording.recordBuffer);
    StateBinder state(m_pipelines, commands, makeCascadePush(recording.view, job.cascade));
    DrawRecordMaker records(recording.view.camera, recording.view.cascades[job.cascade].terms.anchorView);
    const CutDraws cut(m_scene, recording, job.cascade);
    for (std::size_t first = job.draws.begin; first < job.draws.end;) {
        const std::uint32_t kindIndex = sources[instances[first]].kind;
        const std::uint32_t level = levels == nullptr ? 0 : levels[first];
        const visibility::ClusterRun clusters = runs == nullptr ? visibility::ClusterRun{} : runs[first];
        const Span span = first >= wideBegin ? Span::wide : Span::compact;
        const DrawKind& kind = kinds[kindIndex];
        const bool isCut = cut.isCut(first);
        // A run ends with its kind, its level, its clusters, its bucket or its job. What is cut is drawn by itself.
        const std::size_t limit = m_batching != Batching::instanced || isCut ? first + 1
                                  : span == Span::wide                       ? job.draws.end
                                                       : std::min(wideBegin, job.draws.end);
        const auto isOfRun = [&](std::size_t draw) {
            return sources[instances[draw]].kind == kindIndex &&
                   (levels == nullptr || levels[draw] == level) &&
                   (runs == nullptr || runs[draw] == clusters) &&
                   (kind.mesh.chunkCount == 0 || draw == first || !cut.isCut(draw));
        };
        std::size_t end = first;
        for (; end < limit && isOfRun(end); ++end) {
            // Culled instances lie scattered in memory, where the hardware foresees nothing.
            __builtin_prefetch(&sources[instances[std::min(end + kPrefetchDraws, job.draws.end - 1)]]);
            const DrawSource& source = sources[instances[end]];
            recording.records[end] = records.make(source, materials[source.material]);
        }
        state.bind(kind, span);
        if (m_batching == Batching::pushConstants) {
            // Made twice, since a graphics card's memory is slow to read.
            const DrawSource& source = sources[instances[first]];
            push(commands, records.make(source, materials[source.material]));
        }
        const LevelRange indices = indicesOf(kind.mesh, level, clusters);
        const auto draw = [&](const visibility::IndexRun& run) {
            m_drawIndexed(commands, run.count, static_cast<std::uint32_t>(end - first),
                          indices.firstIndex + run.first, kind.mesh.vertexOffset,
                          static_cast<std::uint32_t>(first));
        };
        if (isCut) {
            cut.forEachRun(first, draw);
        } else {
            draw({.count = indices.indexCount});
        }
        first = end;
    }
}

void GeometryPass::push(vk::CommandBuffer commands, const shaders::DrawRecord& record) const {
    m_pushConstants(commands, m_pipelines.layout(),
                    static_cast<VkShaderStageFlags>(GeometryPipelines::kStages), shaders::kPushedRecordOffset,
                    sizeof(record), &record);
}

LevelRange GeometryPass::indicesOf(const MeshRange& mesh, std::uint32_t level,
                                   const visibility::ClusterRun& clusters) const {
    return clusters.indexCount > 0 ? LevelRange{.firstIndex = mesh.firstClusterIndex + clusters.firstIndex,
                                                .indexCount = clusters.indexCount}
                                   : m_scene.indicesOf(mesh, level);
}

void GeometryPass::recordIndirect(vk::CommandBuffer commands, const FrameView& view, std::size_t cascade,
                                  const IndirectDraws& draws) const {
    constexpr std::size_t kCommandBytes = sizeof(vk::DrawIndexedIndirectCommand);
    beginJob(commands, view, cascade, draws.records);
    StateBinder state(m_pipelines, commands, makeCascadePush(view, cascade));
    for (const Span span : {Span::compact, Span::wide}) {
        const std::size_t bucket = 2 * cascade + (span == Span::wide ? 1 : 0);
        for (std::size_t group = 0; group < draws.groups.size(); ++group) {
            const RunGroup& runs = draws.groups[group];
            state.bind(m_scene.kinds()[runs.kind], span);
            commands.drawIndexedIndirectCount(
                draws.commands, (bucket * draws.runs + runs.begin) * kCommandBytes, draws.counts,
                (bucket * draws.groups.size() + group) * sizeof(std::uint32_t),
                static_cast<std::uint32_t>(runs.end - runs.begin), kCommandBytes);
        }
    }
}

} // namespace cdr::render
