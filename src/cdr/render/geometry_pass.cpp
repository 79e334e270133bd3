#include <cdr/gpu/pipeline.h>
#include <cdr/render/gbuffer.h>
#include <cdr/render/geometry_pass.h>
#include <cdr/render/view_transform.h>
#include <cdr/shaders/geometry_depth_frag.h>
#include <cdr/shaders/geometry_frag.h>
#include <cdr/shaders/geometry_vert.h>

#include <algorithm>
#include <limits>

namespace cdr::render {

namespace {

constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
constexpr auto kStorage = vk::DescriptorType::eStorageBuffer;

/// A logarithm set at the vertices of a triangle that spans the share e of its distance errs by up to e^2 / 8
/// of that distance in between; 2 % keeps that below the overlap of cascades (1e-4), so no triangle opens a
/// crack.
constexpr double kLogWideSpan = 0.02;
/// Far enough ahead that memory answers in time.
constexpr std::size_t kPrefetchDraws = 8;

/// Clipping rounds to about 1e-7 of the triangle's own span, which must stay below the overlap of 1e-6.
constexpr double kLinearWideSpan = 4.0;

int bitsOf(depth::DepthFormat format) {
    switch (format) {
    case depth::DepthFormat::d16:
        return 16;
    case depth::DepthFormat::d24:
        return 24;
    case depth::DepthFormat::d32f:
        return 32;
    }
    return 0;
}

std::uint32_t depthForm(depth::Mapping mapping) {
    switch (mapping) {
    case depth::Mapping::log:
        return shaders::kDepthFormLog;
    case depth::Mapping::logFragment:
        return shaders::kDepthFormLogFragment;
    default:
        return shaders::kDepthFormLinear;
    }
}

} // namespace

GeometryPass::GeometryPass(const gpu::Device& device, const GpuScene& scene,
                           const depth::Technique& technique)
    : m_scene(scene),
      m_mapping(technique.mapping),
      m_depthFormat(device.depthFormat(bitsOf(technique.format))),
      m_recordLayout(
          gpu::makeSetLayout(device, {kStorage}, vk::ShaderStageFlagBits::eVertex, "draw record set")),
      m_drawIndexed(reinterpret_cast<PFN_vkCmdDrawIndexed>(device.handle().getProcAddr("vkCmdDrawIndexed"))) {
    const vk::PushConstantRange push{.stageFlags = kStages, .size = sizeof(shaders::CascadePush)};
    m_layout =
        gpu::makePipelineLayout(device, {*m_recordLayout, scene.textureLayout()}, {push}, "geometry layout");
    m_compact = makePipelines(device, false);
    m_wide = makePipelines(device, true);
}

double GeometryPass::wideSpan(std::size_t cascades) const {
    if (m_mapping == depth::Mapping::log) {
        return kLogWideSpan;
    }
    // One cascade has no neighbour to crack from.
    return cascades > 1 ? kLinearWideSpan : std::numeric_limits<double>::infinity();
}

GeometryPass::Pipelines GeometryPass::makePipelines(const gpu::Device& device, bool wide) const {
    const std::uint32_t form =
        wide && m_mapping == depth::Mapping::log ? shaders::kDepthFormLogFragment : depthForm(m_mapping);
    const bool writesDepth = form == shaders::kDepthFormLogFragment;
    Pipelines pipelines;
    for (const DrawKind& kind : m_scene.kinds()) {
        vk::UniquePipeline& pipeline = pipelines[kind.variant];
        if (pipeline) {
            continue;
        }
        pipeline = gpu::makeGraphicsPipeline(
            device, {.name = wide ? "geometry, wide" : "geometry",
                     .vertexSpirv = kGeometryVert,
                     .fragmentSpirv = writesDepth ? std::span<const std::uint32_t>(kGeometryDepthFrag)
                                                  : std::span<const std::uint32_t>(kGeometryFrag),
                     .constants = {form, kind.variant & 1u, kind.variant >> 1u, wide ? 1u : 0u},
                     .layout = *m_layout,
                     .bindings = {GpuScene::vertexBinding()},
                     .attributes = GpuScene::vertexAttributes(),
                     .colorFormats = {kGBufferFormat},
                     .depthFormat = m_depthFormat,
                     .depthCompare = depth::isReversed(m_mapping) ? vk::CompareOp::eGreaterOrEqual
                                                                  : vk::CompareOp::eLessOrEqual});
    }
    return pipelines;
}

vk::DescriptorSet GeometryPass::makeRecordSet(const gpu::Device& device, vk::DescriptorPool pool,
                                              vk::Buffer records) const {
    const vk::DescriptorSet set = gpu::allocateSet(device, pool, *m_recordLayout);
    gpu::writeBufferBinding(device, set, 0, kStorage, records);
    return set;
}

void GeometryPass::beginJob(vk::CommandBuffer commands, const CascadeDraws& cascade,
                            const Recording& recording) const {
    const auto width = static_cast<float>(recording.extent.width);
    const auto height = static_cast<float>(recording.extent.height);
    commands.setViewport(
        0, vk::Viewport{0.0f, 0.0f, width, height, cascade.push.minDepth, cascade.push.maxDepth});
    commands.setScissor(0, vk::Rect2D{{0, 0}, recording.extent});
    commands.bindVertexBuffers(0, m_scene.vertices(), vk::DeviceSize{0});
    commands.bindIndexBuffer(m_scene.indices(), 0, vk::IndexType::eUint32);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_layout, 0, recording.recordSet, {});
    commands.pushConstants<shaders::CascadePush>(*m_layout, kStages, 0, cascade.push);
}

/// Binds what a kind needs and is not bound yet.
class GeometryPass::StateBinder {
  public:
    StateBinder(const GeometryPass& pass, vk::CommandBuffer commands) : m_pass(pass), m_commands(commands) {}

    void bind(const DrawKind& kind, bool wide) {
        const vk::Pipeline pipeline = *(wide ? m_pass.m_wide : m_pass.m_compact)[kind.variant];
        if (pipeline != m_pipeline) {
            m_commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline);
            m_pipeline = pipeline;
        }
        if (kind.textureSet != m_textureSet) {
            m_commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_pass.m_layout, 1,
                                          kind.textureSet, {});
            m_textureSet = kind.textureSet;
        }
        if (m_doubleSided != static_cast<int>(kind.doubleSided)) {
            m_commands.setCullMode(kind.doubleSided ? vk::CullModeFlagBits::eNone
                                                    : vk::CullModeFlagBits::eBack);
            m_doubleSided = static_cast<int>(kind.doubleSided);
        }
        if (m_mirrored != static_cast<int>(kind.mirrored)) {
            m_commands.setFrontFace(kind.mirrored ? vk::FrontFace::eClockwise
                                                  : vk::FrontFace::eCounterClockwise);
            m_mirrored = static_cast<int>(kind.mirrored);
        }
    }

  private:
    static constexpr int kUnset = -1;

    const GeometryPass& m_pass;
    vk::CommandBuffer m_commands;
    vk::Pipeline m_pipeline;
    vk::DescriptorSet m_textureSet;
    int m_doubleSided = kUnset;
    int m_mirrored = kUnset;
};

void GeometryPass::record(vk::CommandBuffer commands, const DrawJob& job, const Recording& recording) const {
    const CascadeDraws& cascade = recording.cascades[job.cascade];
    const std::size_t wideBegin = recording.lists.wideBegin(job.cascade);
    const std::uint32_t* instances = recording.lists.instance.data();
    const DrawSource* sources = m_scene.sources().data();
    const MaterialWords* materials = m_scene.materials().data();
    beginJob(commands, cascade, recording);
    StateBinder state(*this, commands);
    DrawRecordMaker records(recording.camera, cascade.anchorView);
    for (std::size_t first = job.draws.begin; first < job.draws.end;) {
        const std::uint32_t kindIndex = sources[instances[first]].kind;
        const bool wide = first >= wideBegin;
        // A run ends with its kind, its bucket or its job.
        const std::size_t limit = recording.batching == Batching::perObject ? first + 1
                                  : wide                                    ? job.draws.end
                                         : std::min(wideBegin, job.draws.end);
        std::size_t end = first;
        for (; end < limit && sources[instances[end]].kind == kindIndex; ++end) {
            // Culled instances lie scattered in memory, where the hardware foresees nothing.
            __builtin_prefetch(&sources[instances[std::min(end + kPrefetchDraws, job.draws.end - 1)]]);
            const DrawSource& source = sources[instances[end]];
            recording.records[end] = records.make(source, materials[source.material]);
        }
        const DrawKind& kind = m_scene.kinds()[kindIndex];
        state.bind(kind, wide);
        m_drawIndexed(commands, kind.mesh.indexCount, static_cast<std::uint32_t>(end - first),
                      kind.mesh.firstIndex, kind.mesh.vertexOffset, static_cast<std::uint32_t>(first));
        first = end;
    }
}

} // namespace cdr::render
