#include <cdr/gpu/pipeline.h>
#include <cdr/render/gbuffer.h>
#include <cdr/render/geometry_pass.h>
#include <cdr/render/view_transform.h>
#include <cdr/shaders/geometry_depth_frag.h>
#include <cdr/shaders/geometry_frag.h>
#include <cdr/shaders/geometry_vert.h>

#include <limits>

namespace cdr::render {

namespace {

constexpr auto kStages = vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
constexpr auto kStorage = vk::DescriptorType::eStorageBuffer;

/// A logarithm set at the vertices of a triangle that spans the share e of its distance errs by up to e^2 / 8
/// of that distance in between; 2 % keeps that below the overlap of cascades (1e-4), so no triangle opens a
/// crack.
constexpr double kLogWideSpan = 0.02;
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

std::size_t variantOf(const MaterialState& material) {
    return (material.textured ? 1u : 0u) + (material.masked ? 2u : 0u);
}

/// What is bound, so that nothing is bound twice.
struct Bound {
    vk::Pipeline pipeline;
    vk::DescriptorSet textureSet;
    int doubleSided = -1;
    int mirrored = -1;
};

bool isMirrored(const glm::mat3& basis) {
    return glm::determinant(basis) < 0.0f;
}

} // namespace

GeometryPass::GeometryPass(const gpu::Device& device, const GpuScene& scene,
                           const depth::Technique& technique)
    : m_scene(scene),
      m_mapping(technique.mapping),
      m_depthFormat(device.depthFormat(bitsOf(technique.format))),
      m_recordLayout(gpu::makeSetLayout(device, {kStorage, kStorage}, kStages, "draw record set")),
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
    for (const MaterialState& material : m_scene.materialStates()) {
        vk::UniquePipeline& pipeline = pipelines.variants[variantOf(material)];
        if (pipeline) {
            continue;
        }
        pipeline = gpu::makeGraphicsPipeline(
            device,
            {.name = wide ? "geometry, wide" : "geometry",
             .vertexSpirv = kGeometryVert,
             .fragmentSpirv = writesDepth ? std::span<const std::uint32_t>(kGeometryDepthFrag)
                                          : std::span<const std::uint32_t>(kGeometryFrag),
             .constants = {form, material.textured ? 1u : 0u, material.masked ? 1u : 0u, wide ? 1u : 0u},
             .layout = *m_layout,
             .bindings = {GpuScene::vertexBinding()},
             .attributes = GpuScene::vertexAttributes(),
             .colorFormats = GBuffer::formats(),
             .depthFormat = m_depthFormat,
             .depthCompare = depth::isReversed(m_mapping) ? vk::CompareOp::eGreaterOrEqual
                                                          : vk::CompareOp::eLessOrEqual});
    }
    return pipelines;
}

vk::DescriptorSet GeometryPass::makeRecordSet(const gpu::Device& device, vk::DescriptorPool pool,
                                              vk::Buffer records, const GpuScene& scene) const {
    const vk::DescriptorSet set = gpu::allocateSet(device, pool, *m_recordLayout);
    gpu::writeBufferBinding(device, set, 0, kStorage, records);
    gpu::writeBufferBinding(device, set, 1, kStorage, scene.materials());
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

void GeometryPass::record(vk::CommandBuffer commands, const DrawJob& job, const Recording& recording) const {
    const CascadeDraws& cascade = recording.cascades[job.cascade];
    const scene::Instances& instances = recording.scene.instances;
    const std::size_t wideBegin = recording.lists.wideBegin(job.cascade);
    beginJob(commands, cascade, recording);
    Bound bound;
    for (std::size_t draw = job.draws.begin; draw < job.draws.end; ++draw) {
        const std::uint32_t instance = recording.lists.instance[draw];
        recording.records[draw] = makeDrawRecord(instances, instance, recording.camera, cascade.anchorView);

        const MaterialState& material = m_scene.material(instances.material[instance]);
        const Pipelines& pipelines = draw < wideBegin ? m_compact : m_wide;
        const vk::Pipeline pipeline = *pipelines.variants[variantOf(material)];
        if (pipeline != bound.pipeline) {
            commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline);
            bound.pipeline = pipeline;
        }
        if (material.textureSet != bound.textureSet) {
            commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_layout, 1, material.textureSet,
                                        {});
            bound.textureSet = material.textureSet;
        }
        if (bound.doubleSided != static_cast<int>(material.doubleSided)) {
            commands.setCullMode(material.doubleSided ? vk::CullModeFlagBits::eNone
                                                      : vk::CullModeFlagBits::eBack);
            bound.doubleSided = static_cast<int>(material.doubleSided);
        }
        const int mirrored = isMirrored(instances.basis[instance]) ? 1 : 0;
        if (bound.mirrored != mirrored) {
            commands.setFrontFace(mirrored ? vk::FrontFace::eClockwise : vk::FrontFace::eCounterClockwise);
            bound.mirrored = mirrored;
        }
        const MeshRange& mesh = m_scene.mesh(instances.mesh[instance]);
        m_drawIndexed(commands, mesh.indexCount, 1, mesh.firstIndex, mesh.vertexOffset,
                      static_cast<std::uint32_t>(draw));
    }
}

} // namespace cdr::render
