#include <cdr/base/error.h>
#include <cdr/gpu/commands.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/rounding.h>
#include <cdr/render/submit/binning_pass.h>
#include <cdr/shaders/bin_commands_comp.h>
#include <cdr/shaders/bin_count_comp.h>
#include <cdr/shaders/bin_count_occluders_comp.h>
#include <cdr/shaders/bin_count_shown_comp.h>
#include <cdr/shaders/bin_fill_comp.h>
#include <cdr/shaders/bin_scan_comp.h>
#include <cdr/visibility/occluders.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace cdr::render {

namespace {

using Stage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

/// Runs of a group, whose commands one invocation of bin_commands.comp lists. lavapipe ends a loop after 65,535 turns, and
/// others wait for the longest.
constexpr std::size_t kMostRunsPerGroup = 1024;
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
           a.layer == b.layer && a.textureSet == b.textureSet && a.detailSet == b.detailSet;
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

BinningPass::BinningPass(const gpu::Device& device, const DrawnScene& drawn, visibility::DetailMode detail,
                         const gpu::SetLayout& occlusionLayout)
    : m_device(checked(device, drawn.scene.instances)),
      m_drawn(drawn),
      m_detail(detail),
      m_isStaged(true),
      m_setLayout(gpu::makeSetLayout(
          device,
          {std::vector(kBindings, vk::DescriptorType::eStorageBuffer), vk::ShaderStageFlagBits::eCompute},
          "binning set")),
      m_layout(gpu::makePipelineLayout(
          device,
          {occlusionLayout ? std::vector{m_setLayout, occlusionLayout} : std::vector{m_setLayout}, {}},
          "binning layout")),
      m_count{makePipeline(kBinCountComp, "bin, count"), {}, {}},
      m_scan(makePipeline(kBinScanComp, "bin, scan")),
      m_fill(makePipeline(kBinFillComp, "bin, fill")),
      m_commands(makePipeline(kBinCommandsComp, "bin, commands")) {
    if (occlusionLayout) {
        m_count[1] = makePipeline(kBinCountOccludersComp, "bin, count occluders");
        m_count[2] = makePipeline(kBinCountShownComp, "bin, count what is shown");
    }
    groupInstances();
}

gpu::Pipeline BinningPass::makePipeline(const gpu::Spirv& spirv, const char* name) const {
    // It culls and bins as the CPU does, to the bit.
    return gpu::makeComputePipeline(m_device, {name, gpu::roundingToNearestEven(spirv), m_layout});
}

void BinningPass::groupInstances() {
    const GpuScene& gpuScene = m_drawn.uploaded;
    const std::vector<DrawKind>& kinds = gpuScene.kinds();
    const std::size_t mostCommands = std::min<std::size_t>(
        kMostRunsPerGroup,
        vk::PhysicalDevice(m_device.physical()).getProperties().limits.maxDrawIndirectCount);
    m_tables = gpuScene.tablesRevision();
    m_followed = gpuScene.instanceChanges().end();
    m_groups.clear();
    m_runs.clear();
    m_kinds.clear();
    m_spheres.resize(gpuScene.sources().size());
    m_looks.resize(gpuScene.sources().size());
    for (std::size_t i = 0; i < m_spheres.size(); ++i) {
        const DrawSource& source = gpuScene.sources()[i];
        const MeshRange& mesh = kinds[source.kind].mesh;
        const bool hasLevels = m_detail != visibility::DetailMode::none && mesh.levelCount > 0;
        if (i == 0 || hasLevels || source.kind != m_kinds.back()) {
            if (m_groups.empty() || !bindAlike(kinds[m_groups.back().kind], kinds[source.kind]) ||
                m_groups.back().end - m_groups.back().begin == mostCommands) {
                m_groups.push_back({.begin = m_runs.size(), .end = m_runs.size(), .kind = source.kind});
            }
            m_runs.push_back({.firstIndex = mesh.firstIndex,
                              .indexCount = mesh.indexCount,
                              .vertexOffset = mesh.vertexOffset,
                              .instance = static_cast<std::uint32_t>(i),
                              .firstLevel = mesh.firstLevel,
                              .levels = hasLevels ? mesh.levelCount : 0,
                              .boundingRadius = mesh.boundingRadius});
            m_groups.back().end = m_runs.size();
        }
        m_kinds.push_back(source.kind);
        m_spheres[i].run = static_cast<std::uint32_t>(m_runs.size() - 1);
        readInstance(i);
    }
}

void BinningPass::readInstance(std::size_t i) {
    const DrawSource& source = m_drawn.uploaded.sources()[i];
    const bool isOpaque = m_drawn.scene.materials[source.material].alphaMode != scene::AlphaMode::blend;
    m_spheres[i] = {.x = source.position.x,
                    .y = source.position.y,
                    .z = source.position.z,
                    .radius = isOpaque ? m_drawn.scene.instances.radius[i] : scene::kNoRadius,
                    .run = m_spheres[i].run};
    m_looks[i] = lookOf(source);
}

/// Reads what changed, each place once, ascending. False where runs of one kind are no longer what they were.
bool BinningPass::readChanged(std::vector<std::uint32_t>& changed) {
    const GpuScene& gpuScene = m_drawn.uploaded;
    const auto places = gpuScene.instanceChanges().since(m_followed);
    if (!places || m_tables != gpuScene.tablesRevision() || gpuScene.sources().size() != m_spheres.size()) {
        return false;
    }
    changed.assign(places->begin(), places->end());
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const std::uint32_t i : changed) {
        if (gpuScene.sources()[i].kind != m_kinds[i]) {
            return false;
        }
        readInstance(i);
    }
    m_followed = gpuScene.instanceChanges().end();
    return true;
}

bool BinningPass::follow(Copies& copies) {
    for (std::vector<vk::BufferCopy>& regions : copies.regions) {
        regions.clear();
    }
    std::vector<std::uint32_t> changed;
    const bool isGrouped = readChanged(changed);
    if (!isGrouped) {
        groupInstances();
    }
    if (!isGrouped || m_isStaged) {
        provideBuffers();
        stageAll(copies);
        m_isStaged = true;
    } else if (!changed.empty()) {
        stageChanged(changed, copies);
        m_isStaged = true;
    } else {
        copies.staging = {}; // a scene that stands still keeps no copy of itself
    }
    return std::exchange(copies.buffers, m_sceneBuffers) != m_sceneBuffers;
}

void BinningPass::provideBuffers() {
    checked(m_device, m_drawn.scene.instances);
    const GpuScene& gpuScene = m_drawn.uploaded;
    const std::array<std::size_t, kSceneBuffers> bytes{
        m_spheres.size() * sizeof(shaders::InstanceSphere),
        m_looks.size() * sizeof(shaders::InstanceLook),
        gpuScene.materials().size() * sizeof(shaders::MaterialRecord),
        m_runs.size() * sizeof(shaders::KindRun),
        m_groups.size() * sizeof(shaders::RunGroup),
        gpuScene.levels().size() * sizeof(shaders::CoarserLevel)};
    constexpr std::array<const char*, kSceneBuffers> kNames{
        "instance spheres", "instance looks", "materials", "kind runs", "run groups", "coarser levels"};
    const auto suffices = [&](std::size_t i) { return bytes[i] <= (*m_sceneBuffers)[i].size(); };
    bool isEnough = m_sceneBuffers != nullptr;
    for (std::size_t i = 0; isEnough && i < kSceneBuffers; ++i) {
        isEnough = suffices(i);
    }
    if (isEnough) {
        return;
    }
    // Frames in flight keep the old ones. A scene that grew may grow on.
    const bool grows = m_sceneBuffers != nullptr;
    auto made = std::make_shared<SceneBuffers>();
    for (std::size_t i = 0; i < kSceneBuffers; ++i) {
        const std::size_t most = std::max(bytes[i], m_device.info().maxStorageBufferBytes);
        const std::size_t size = grows ? std::min(bytes[i] + bytes[i] / 2, most) : bytes[i];
        (*made)[i] =
            gpu::Buffer(m_device, std::max<std::size_t>(size, sizeof(shaders::InstanceLook)),
                        vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eTransferDst,
                        gpu::MemoryUse::deviceOnly, kNames[i]);
    }
    m_sceneBuffers = std::move(made);
}

namespace {

/// Fills a slot's staging buffer from its start on and notes where the bytes go.
class Stager {
  public:
    Stager(const gpu::Device& device, std::size_t bytes, BinningPass::Copies& copies) : m_copies(copies) {
        if (copies.staging.size() < bytes) {
            gpu::requireDeviceBytes(device, bytes, "changes of a gpu-driven scene");
            copies.staging = gpu::Buffer(device, bytes + bytes / 2, vk::BufferUsageFlagBits::eTransferSrc,
                                         gpu::MemoryUse::hostWrites, "binning changes");
        }
    }

    /// @param first of the values in the buffer
    template <typename T>
    void add(std::size_t buffer, std::size_t first, std::span<const T> values) {
        if (values.empty()) {
            return;
        }
        const std::span<const std::byte> bytes = std::as_bytes(values);
        std::copy(bytes.begin(), bytes.end(), static_cast<std::byte*>(m_copies.staging.mapped()) + m_end);
        m_copies.regions[buffer].push_back(
            {.srcOffset = m_end, .dstOffset = first * sizeof(T), .size = bytes.size()});
        m_end += bytes.size();
    }

  private:
    BinningPass::Copies& m_copies;
    std::size_t m_end = 0;
};

} // namespace

void BinningPass::stageAll(Copies& copies) const {
    std::vector<shaders::MaterialRecord> materials;
    for (std::size_t i = 0; i < m_drawn.uploaded.materials().size(); ++i) {
        const MaterialWords& words = m_drawn.uploaded.materials()[i];
        const bool occludes = visibility::canOcclude(m_drawn.scene.materials[i]);
        materials.push_back({words.cutoffAndShine, words.baseColorRg, words.baseColorBa, occludes ? 1u : 0u});
    }
    std::vector<shaders::CoarserLevel> levels;
    for (const LevelRange& level : m_drawn.uploaded.levels()) {
        levels.push_back({level.firstIndex, level.indexCount, level.error});
    }
    std::vector<shaders::RunGroup> groups;
    for (const GeometryPass::RunGroup& group : m_groups) {
        groups.push_back({static_cast<std::uint32_t>(group.begin), static_cast<std::uint32_t>(group.end)});
    }
    const auto bytesOf = [](const auto& values) { return std::as_bytes(std::span(values)).size(); };
    Stager stager(m_device,
                  bytesOf(m_spheres) + bytesOf(m_looks) + bytesOf(materials) + bytesOf(m_runs) +
                      bytesOf(groups) + bytesOf(levels),
                  copies);
    stager.add(0, 0, std::span(std::as_const(m_spheres)));
    stager.add(1, 0, std::span(std::as_const(m_looks)));
    stager.add(2, 0, std::span(std::as_const(materials)));
    stager.add(3, 0, std::span(std::as_const(m_runs)));
    stager.add(4, 0, std::span(std::as_const(groups)));
    stager.add(5, 0, std::span(std::as_const(levels)));
    copies.staging.flush();
}

void BinningPass::stageChanged(const std::vector<std::uint32_t>& changed, Copies& copies) const {
    // What lies between two changes is copied along where that is less than another region.
    constexpr std::uint32_t kMostBetween = 8;
    std::vector<host::IndexRange> ranges;
    std::size_t places = 0;
    for (const std::uint32_t i : changed) {
        if (ranges.empty() || i > ranges.back().end + kMostBetween) {
            ranges.push_back({i, i});
        }
        ranges.back().end = i + 1;
    }
    for (const host::IndexRange& range : ranges) {
        places += range.size();
    }
    Stager stager(m_device, places * (sizeof(shaders::InstanceSphere) + sizeof(shaders::InstanceLook)),
                  copies);
    for (const host::IndexRange& range : ranges) {
        stager.add(0, range.begin, std::span(m_spheres).subspan(range.begin, range.size()));
    }
    for (const host::IndexRange& range : ranges) {
        stager.add(1, range.begin, std::span(m_looks).subspan(range.begin, range.size()));
    }
    copies.staging.flush();
}

void BinningPass::bindScene(vk::DescriptorSet set, const SceneBuffers& buffers) const {
    for (std::uint32_t i = 0; i < kSceneBuffers; ++i) {
        gpu::writeBufferBinding(m_device, set, 1 + i, vk::DescriptorType::eStorageBuffer,
                                buffers[i].handle());
    }
}

// Between frames before, which read the scene's buffers, and the passes after.
void BinningPass::recordCopies(vk::CommandBuffer commands, const Copies& copies) const {
    const auto isEmpty = [](const std::vector<vk::BufferCopy>& regions) { return regions.empty(); };
    if (std::all_of(copies.regions.begin(), copies.regions.end(), isEmpty)) {
        return;
    }
    gpu::pipelineBarrier(commands, {},
                         {{.srcStageMask = Stage::eComputeShader | Stage::eCopy,
                           .srcAccessMask = Access::eTransferWrite,
                           .dstStageMask = Stage::eCopy,
                           .dstAccessMask = Access::eTransferWrite}});
    for (std::size_t i = 0; i < copies.regions.size(); ++i) {
        if (!copies.regions[i].empty()) {
            commands.copyBuffer(copies.staging.handle(), (*copies.buffers)[i].handle(), copies.regions[i]);
        }
    }
    gpu::pipelineBarrier(commands, {},
                         {{.srcStageMask = Stage::eCopy,
                           .srcAccessMask = Access::eTransferWrite,
                           .dstStageMask = Stage::eComputeShader,
                           .dstAccessMask = Access::eShaderStorageRead}});
}

void BinningPass::record(vk::CommandBuffer commands, Kept kept, std::size_t cascades,
                         const std::vector<vk::DescriptorSet>& sets) const {
    const auto blocks =
        static_cast<std::uint32_t>((instances() + shaders::kBinBlock - 1) / shaders::kBinBlock);
    const std::size_t lists = 2 * cascades * m_groups.size();
    const auto listGroups =
        static_cast<std::uint32_t>((lists + kCommandInvocations - 1) / kCommandInvocations);
    const auto next =
        barrier(Stage::eComputeShader, Access::eShaderStorageRead | Access::eShaderStorageWrite);
    m_device.beginLabel(commands, "cull and bin");
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *m_layout, 0, sets, {});
    const auto dispatch = [&](vk::Pipeline pipeline, std::uint32_t groups, const vk::MemoryBarrier2& after) {
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline);
        commands.dispatch(groups, 1, 1);
        gpu::pipelineBarrier(commands, {}, {after});
    };
    dispatch(*m_count[static_cast<std::size_t>(kept)], blocks, next);
    dispatch(*m_scan, 1, next);
    dispatch(*m_fill, blocks, next);
    dispatch(*m_commands, listGroups,
             barrier(Stage::eDrawIndirect | Stage::eVertexAttributeInput | Stage::eHost,
                     Access::eIndirectCommandRead | Access::eVertexAttributeRead | Access::eHostRead));
    m_device.endLabel(commands);
}

} // namespace cdr::render
