#include <cdr/base/error.h>
#include <cdr/gpu/commands.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/upload.h>
#include <cdr/render/submit/binning_pass.h>
#include <cdr/shaders/bin_commands_comp.h>
#include <cdr/shaders/bin_count_comp.h>
#include <cdr/shaders/bin_fill_comp.h>
#include <cdr/shaders/bin_scan_comp.h>
#include <cdr/shaders/binning_shared.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <string_view>

namespace cdr::render {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

/// The radius of a sphere that no view volume is near enough to keep.
constexpr float kNeverSeen = std::numeric_limits<float>::lowest();

/// Invocations a workgroup of bin_commands.comp.
constexpr std::size_t kCommandInvocations = 64;

const gpu::Device& checked(const gpu::Device& device, const scene::Instances& instances) {
    if (!device.info().gpuDrivenMissing.empty()) {
        throw base::InputError(fmt::format("{} cannot draw gpu-driven: it lacks {}", device.info().name,
                                           fmt::join(device.info().gpuDrivenMissing, ", ")));
    }
    const std::size_t largest = instances.size() * sizeof(shaders::InstanceLook);
    if (largest > device.info().maxStorageBufferBytes) {
        throw base::RunError(fmt::format("{} instances need a {} byte buffer to be drawn gpu-driven, {} "
                                         "allows {}",
                                         instances.size(), largest, device.info().name,
                                         device.info().maxStorageBufferBytes));
    }
    gpu::requireDeviceBytes(device, largest + instances.size() * sizeof(shaders::InstanceSphere),
                            "a gpu-driven scene");
    return device;
}

/// Whether two kinds are drawn with the same things bound.
bool bindAlike(const DrawKind& a, const DrawKind& b) {
    return a.variant == b.variant && a.doubleSided == b.doubleSided && a.mirrored == b.mirrored &&
           a.textureSet == b.textureSet;
}

shaders::InstanceLook lookOf(const DrawSource& source) {
    shaders::InstanceLook look{};
    const float* values = &source.basis[0][0];
    std::copy_n(values, 9, look.basis);
    look.id = source.id;
    look.material = source.material;
    return look;
}

vk::MemoryBarrier2 barrier(vk::PipelineStageFlags2 stages, vk::AccessFlags2 access) {
    return {.srcStageMask = Stage::eComputeShader,
            .srcAccessMask = Access::eShaderStorageWrite,
            .dstStageMask = stages,
            .dstAccessMask = access};
}

} // namespace

BinningPass::BinningPass(const gpu::Device& device, const DrawnScene& drawn, visibility::DetailMode detail)
    : m_device(checked(device, drawn.scene.instances)),
      m_instances(drawn.scene.instances.size()),
      m_setLayout(gpu::makeSetLayout(device, std::vector(kBindings, vk::DescriptorType::eStorageBuffer),
                                     vk::ShaderStageFlagBits::eCompute, "binning set")),
      m_layout(gpu::makePipelineLayout(device, {*m_setLayout}, {}, "binning layout")),
      m_count(makePipeline(kBinCountComp, "bin, count")),
      m_scan(makePipeline(kBinScanComp, "bin, scan")),
      m_fill(makePipeline(kBinFillComp, "bin, fill")),
      m_commands(makePipeline(kBinCommandsComp, "bin, commands")) {
    uploadInstances(drawn, detail);
}

vk::UniquePipeline BinningPass::makePipeline(std::span<const std::uint32_t> spirv, const char* name) const {
    return gpu::makeComputePipeline(m_device, spirv, *m_layout, name);
}

void BinningPass::uploadInstances(const DrawnScene& drawn, visibility::DetailMode detail) {
    const GpuScene& gpuScene = drawn.uploaded;
    std::vector<shaders::InstanceSphere> spheres;
    std::vector<shaders::InstanceLook> looks;
    std::vector<shaders::MaterialRecord> materials;
    std::vector<shaders::KindRun> runs;
    std::vector<shaders::RunGroup> groups;
    std::vector<shaders::CoarserLevel> levels;
    const std::vector<DrawKind>& kinds = gpuScene.kinds();
    const std::size_t mostCommands = m_device.physical().getProperties().limits.maxDrawIndirectCount;
    for (std::size_t i = 0; i < m_instances; ++i) {
        const DrawSource& source = gpuScene.sources()[i];
        const MeshRange& mesh = kinds[source.kind].mesh;
        const bool hasLevels = detail != visibility::DetailMode::none && mesh.levelCount > 0;
        if (i == 0 || hasLevels || source.kind != gpuScene.sources()[i - 1].kind) {
            if (m_groups.empty() || !bindAlike(kinds[m_groups.back().kind], kinds[source.kind]) ||
                m_groups.back().end - m_groups.back().begin == mostCommands) {
                m_groups.push_back({.begin = runs.size(), .end = runs.size(), .kind = source.kind});
            }
            runs.push_back({.firstIndex = mesh.firstIndex,
                            .indexCount = mesh.indexCount,
                            .vertexOffset = mesh.vertexOffset,
                            .instance = static_cast<std::uint32_t>(i),
                            .firstLevel = mesh.firstLevel,
                            .levels = hasLevels ? mesh.levelCount : 0,
                            .boundingRadius = mesh.boundingRadius});
            m_groups.back().end = runs.size();
        }
        spheres.push_back({.x = source.position.x,
                           .y = source.position.y,
                           .z = source.position.z,
                           .radius = drawn.scene.instances.radius[i],
                           .run = static_cast<std::uint32_t>(runs.size() - 1)});
        looks.push_back(lookOf(source));
    }
    for (const std::uint32_t instance : drawn.blended) {
        spheres[instance].radius = kNeverSeen;
    }
    for (const MaterialWords& words : gpuScene.materials()) {
        materials.push_back({words.cutoffAndShine, words.baseColorRg, words.baseColorBa, 0});
    }
    for (const LevelRange& level : gpuScene.levels()) {
        levels.push_back({level.firstIndex, level.indexCount, level.error});
    }
    for (const GeometryPass::RunGroup& group : m_groups) {
        groups.push_back({static_cast<std::uint32_t>(group.begin), static_cast<std::uint32_t>(group.end)});
    }
    m_runs = runs.size();
    const auto upload = [&](auto& values, const char* name) {
        values.resize(std::max<std::size_t>(values.size(), 1)); // no buffer is empty
        return gpu::uploadBuffer(m_device, std::as_bytes(std::span(values)),
                                 vk::BufferUsageFlagBits::eStorageBuffer, name);
    };
    m_sceneBuffers = {upload(spheres, "instance spheres"), upload(looks, "instance looks"),
                      upload(materials, "materials"),      upload(runs, "kind runs"),
                      upload(groups, "run groups"),        upload(levels, "coarser levels")};
}

void BinningPass::bindScene(vk::DescriptorSet set) const {
    for (std::uint32_t i = 0; i < kSceneBuffers; ++i) {
        gpu::writeBufferBinding(m_device, set, 1 + i, vk::DescriptorType::eStorageBuffer,
                                m_sceneBuffers[i].handle());
    }
}

void BinningPass::record(vk::CommandBuffer commands, vk::DescriptorSet set, std::size_t cascades) const {
    const auto blocks =
        static_cast<std::uint32_t>((m_instances + shaders::kBinBlock - 1) / shaders::kBinBlock);
    const std::size_t lists = 2 * cascades * m_groups.size();
    const auto listGroups =
        static_cast<std::uint32_t>((lists + kCommandInvocations - 1) / kCommandInvocations);
    const auto next =
        barrier(Stage::eComputeShader, Access::eShaderStorageRead | Access::eShaderStorageWrite);
    m_device.beginLabel(commands, "cull and bin");
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *m_layout, 0, set, {});
    const auto dispatch = [&](vk::Pipeline pipeline, std::uint32_t groups, const vk::MemoryBarrier2& after) {
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline);
        commands.dispatch(groups, 1, 1);
        gpu::pipelineBarrier(commands, {}, {after});
    };
    dispatch(*m_count, blocks, next);
    dispatch(*m_scan, 1, next);
    dispatch(*m_fill, blocks, next);
    dispatch(*m_commands, listGroups,
             barrier(Stage::eDrawIndirect | Stage::eVertexAttributeInput | Stage::eHost,
                     Access::eIndirectCommandRead | Access::eVertexAttributeRead | Access::eHostRead));
    m_device.endLabel(commands);
}

} // namespace cdr::render
