#include <cdr/base/format_error.h>
#include <cdr/gpu/commands.h>
#include <cdr/gpu/device_query.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/rounding.h>
#include <cdr/render/stages.h>
#include <cdr/render/submit/binning_pass.h>
#include <cdr/render/submit/stager.h>
#include <cdr/shaders/binning.h>
#include <cdr/visibility/occluders.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace cdr::render {

namespace {

/// In BinningPass::SceneBuffers.
enum SceneBuffer : std::size_t { kSpheres, kLooks, kMaterials, kRuns, kGroups, kLevels };

/// Runs of a group, whose commands one invocation of bin_commands.comp lists. lavapipe ends a loop after 65,535 turns, and
/// others wait for the longest.
constexpr std::size_t kMaxRunsPerGroup = 1024;
/// Of a buffer of the scene: room for what is few at first, since all are staged again where one grows.
constexpr std::size_t kMinBytes = 4096;

static_assert(BinningPass::kBindings <= gpu::kGpuDrivenStorageBuffers);
static_assert(shaders::kBinBlock <= gpu::kGpuDrivenInvocations &&
              shaders::kCommandsBlock <= gpu::kGpuDrivenInvocations &&
              shaders::kChangesBlock <= gpu::kGpuDrivenInvocations);

const gpu::Device& checked(const gpu::Device& device) {
    if (!device.info().gpuDrivenMissing.empty()) {
        throw base::inputError("{} cannot draw gpu-driven: it lacks {}", device.info().name,
                               fmt::join(device.info().gpuDrivenMissing, ", "));
    }
    return device;
}

void requireAddressable(const gpu::Device& device, std::size_t instances) {
    const std::size_t largest = instances * sizeof(shaders::InstanceLook);
    if (largest > device.info().maxStorageBufferBytes) {
        throw base::runError("{} instances need a {} byte buffer to be drawn gpu-driven, {} "
                             "allows {}",
                             instances, largest, device.info().name, device.info().maxStorageBufferBytes);
    }
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

/// Until the scene's buffers are as they were written last, and nothing reads them.
void awaitScene(vk::CommandBuffer commands, vk::PipelineStageFlags2 stages, vk::AccessFlags2 access) {
    gpu::memoryBarrier(commands, PipelineStage::eComputeShader | PipelineStage::eCopy,
                       Access::eTransferWrite | Access::eShaderStorageWrite, stages, access);
}

} // namespace

BinningPass::BinningPass(const gpu::Device& device, const DrawnScene& drawn, visibility::DetailMode detail,
                         const gpu::SetLayout& occlusionLayout)
    : m_device(checked(device)),
      m_drawn(drawn),
      m_detail(detail),
      m_mostCommands(std::min<std::size_t>(
          kMaxRunsPerGroup,
          vk::PhysicalDevice(device.physical()).getProperties().limits.maxDrawIndirectCount)),
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
      m_commands(makePipeline(kBinCommandsComp, "bin, commands")),
      m_scatter(device) {
    if (occlusionLayout) {
        m_count[1] = makePipeline(kBinCountOccludersComp, "bin, count occluders");
        m_count[2] = makePipeline(kBinCountShownComp, "bin, count what is shown");
    }
    groupAll();
    provideBuffers();
}

gpu::Pipeline BinningPass::makePipeline(const gpu::Spirv& spirv, const char* name) const {
    // It culls and bins as the CPU does, to the bit.
    return gpu::makeComputePipeline(m_device, {name, gpu::roundingToNearestEven(spirv), m_layout});
}

void BinningPass::groupAll() {
    m_groups.clear();
    m_runs.clear();
    m_kinds.clear();
    m_spheres.clear();
    m_looks.clear();
    groupMore();
}

/// Those that came behind the others.
void BinningPass::groupMore() {
    const UploadedScene& gpuScene = m_drawn.uploaded;
    m_tables = gpuScene.tablesRevision();
    m_followed = gpuScene.followedInstances();
    const std::size_t before = m_kinds.size();
    m_spheres.resize(gpuScene.sources().size());
    m_looks.resize(gpuScene.sources().size());
    for (std::size_t i = before; i < m_spheres.size(); ++i) {
        groupInstance(i);
    }
}

void BinningPass::groupInstance(std::size_t i) {
    const std::vector<DrawKind>& kinds = m_drawn.uploaded.kinds();
    const DrawSource& source = m_drawn.uploaded.sources()[i];
    const MeshRange& mesh = kinds[source.kind].mesh;
    const bool hasLevels = m_detail != visibility::DetailMode::none && mesh.levelCount > 0;
    if (i == 0 || hasLevels || source.kind != m_kinds.back()) {
        if (m_groups.empty() || !bindAlike(kinds[m_groups.back().kind], kinds[source.kind]) ||
            m_groups.back().end - m_groups.back().begin == m_mostCommands) {
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

/// Reads what changed of the instances that are grouped, each place once, ascending. False where runs of one kind are no
/// longer what they were.
bool BinningPass::readChanged(std::vector<std::uint32_t>& changed) {
    const UploadedScene& gpuScene = m_drawn.uploaded;
    const auto places = gpuScene.instanceChanges().since(m_followed);
    const bool isCut = m_kinds.size() != m_spheres.size(); // there was no memory for the last ones
    if (!places || isCut || m_tables != gpuScene.tablesRevision() ||
        gpuScene.sources().size() < m_spheres.size()) {
        return false;
    }
    changed.assign(places->begin(), places->end());
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    changed.erase(std::lower_bound(changed.begin(), changed.end(), m_spheres.size()), changed.end());
    for (const std::uint32_t i : changed) {
        if (gpuScene.sources()[i].kind != m_kinds[i]) {
            return false;
        }
        readInstance(i);
    }
    return true;
}

bool BinningPass::follow(Copies& copies) {
    for (std::vector<vk::BufferCopy>& regions : copies.regions) {
        regions.clear();
    }
    copies.scattered.count = 0;
    const bool wasStaged =
        std::exchange(m_isStaged, true); // where this ends early, all is staged the next time
    std::vector<std::uint32_t> changed;
    const bool isGrouped = readChanged(changed);
    const Grouped before{m_spheres.size(), m_runs.size(), m_groups.size()};
    if (isGrouped) {
        groupMore();
    } else {
        groupAll();
    }
    const std::uint64_t tablesBefore = std::exchange(m_meshes, m_drawn.uploaded.meshesRevision());
    const bool isWhole = provideBuffers() || !isGrouped || wasStaged || changed.size() > m_scatter.most();
    m_isStaged = copyChanges(
        isWhole ? Changes{.instances = {}, .before = {}, .tables = true}
                : Changes{.instances = changed, .before = before, .tables = tablesBefore != m_meshes},
        copies);
    return std::exchange(copies.buffers, m_sceneBuffers) != m_sceneBuffers;
}

BinningPass::SceneSizes BinningPass::sizesNeeded() const {
    const UploadedScene& gpuScene = m_drawn.uploaded;
    SceneSizes bytes{m_spheres.size() * sizeof(shaders::InstanceSphere),
                     m_looks.size() * sizeof(shaders::InstanceLook),
                     gpuScene.materials().size() * sizeof(shaders::MaterialRecord),
                     m_runs.size() * sizeof(shaders::KindRun),
                     m_groups.size() * sizeof(shaders::RunGroup),
                     gpuScene.levels().size() * sizeof(shaders::CoarserLevel)};
    for (std::size_t& each : bytes) {
        each = std::max(each, kMinBytes);
    }
    return bytes;
}

/// Whether buffers of so many bytes get room to grow on: a scene that grew may grow on. base::RunError where not even they fit.
bool BinningPass::givesRoom(std::uint64_t bytes) const {
    constexpr const char* kWhat = "a gpu-driven scene";
    if (m_sceneBuffers == nullptr) {
        gpu::requireDeviceBytes(m_device, bytes, kWhat);
        return false;
    }
    return gpu::roomToGrow(m_device, {.count = bytes}, gpu::MemoryUse::deviceOnly, kWhat) > bytes;
}

/// Whether they are others now.
bool BinningPass::provideBuffers() {
    const SceneSizes bytes = sizesNeeded();
    constexpr std::array<const char*, kSceneBuffers> kNames{
        "instance spheres", "instance looks", "materials", "kind runs", "run groups", "coarser levels"};
    const auto suffices = [&](std::size_t i) { return bytes[i] <= (*m_sceneBuffers)[i].size(); };
    bool isEnough = m_sceneBuffers != nullptr;
    for (std::size_t i = 0; isEnough && i < kSceneBuffers; ++i) {
        isEnough = suffices(i);
    }
    if (isEnough) {
        return false;
    }
    requireAddressable(m_device, instances());
    // Frames in flight keep the old ones.
    const bool isRoomy = givesRoom(std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{0}));
    auto made = std::make_shared<SceneBuffers>();
    for (std::size_t i = 0; i < kSceneBuffers; ++i) {
        const std::size_t most = std::max(bytes[i], m_device.info().maxStorageBufferBytes);
        const std::size_t size = isRoomy ? std::min(bytes[i] + bytes[i] / 2, most) : bytes[i];
        (*made)[i] = gpu::Buffer(
            m_device, size, vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eTransferDst,
            gpu::MemoryUse::deviceOnly, kNames[i]);
    }
    m_sceneBuffers = std::move(made);
    return true;
}

/// What stands beside the instances, as the device reads it.
struct BinningPass::Tables {
    std::vector<shaders::MaterialRecord> materials;
    std::vector<shaders::CoarserLevel> levels;
    std::vector<shaders::RunGroup> groups;
};

BinningPass::Tables BinningPass::tables() const {
    Tables made;
    // Layer offsets draw faces nearer than they are, so there is no occluder beside them.
    const bool canHide = !m_drawn.uploaded.hasLayers();
    for (std::size_t i = 0; i < m_drawn.uploaded.materials().size(); ++i) {
        const MaterialWords& words = m_drawn.uploaded.materials()[i];
        const bool occludes = canHide && visibility::canOcclude(m_drawn.scene.materials[i]);
        made.materials.push_back(
            {words.cutoffAndMetallicRoughness, words.baseColorRg, words.baseColorBa, occludes ? 1u : 0u});
    }
    for (const LevelRange& level : m_drawn.uploaded.levels()) {
        made.levels.push_back({level.firstIndex, level.indexCount, level.error});
    }
    for (const GeometryPass::RunGroup& group : m_groups) {
        made.groups.push_back(
            {static_cast<std::uint32_t>(group.begin), static_cast<std::uint32_t>(group.end)});
    }
    return made;
}

/// Whether anything changed.
bool BinningPass::copyChanges(const Changes& changes, Copies& copies) const {
    const Grouped& before = changes.before;
    Stager stager;
    Tables all;
    if (changes.tables || before.instances < m_spheres.size()) {
        all = tables();
        stager.add(kSpheres, before.instances, std::span(m_spheres).subspan(before.instances));
        stager.add(kLooks, before.instances, std::span(m_looks).subspan(before.instances));
        stager.add(kRuns, before.runs, std::span(m_runs).subspan(before.runs));
        const std::size_t group = before.groups > 0 ? before.groups - 1 : 0; // the last one may have grown
        stager.add(kGroups, group, std::span(all.groups).subspan(group));
        stager.add(kMaterials, 0, all.materials);
        stager.add(kLevels, 0, all.levels);
    }
    stager.write(m_device, copies.staging, copies.regions);
    m_scatter.stage({changes.instances, m_spheres, m_looks},
                    {(*m_sceneBuffers)[kSpheres], (*m_sceneBuffers)[kLooks]}, copies.scattered);
    return !stager.isEmpty() || !changes.instances.empty();
}

void BinningPass::bindScene(const gpu::DescriptorSet& set, const SceneBuffers& buffers) {
    for (std::uint32_t i = 0; i < kSceneBuffers; ++i) {
        set.setBuffer(1 + i, buffers[i]);
    }
}

// Between frames before, which read the scene's buffers, and the passes after.
void BinningPass::recordCopies(vk::CommandBuffer commands, const Copies& copies) const {
    const auto isEmpty = [](const std::vector<vk::BufferCopy>& regions) { return regions.empty(); };
    if (!std::all_of(copies.regions.begin(), copies.regions.end(), isEmpty)) {
        awaitScene(commands, PipelineStage::eCopy, Access::eTransferWrite);
        for (std::size_t i = 0; i < copies.regions.size(); ++i) {
            if (!copies.regions[i].empty()) {
                commands.copyBuffer(copies.staging.handle(), (*copies.buffers)[i].handle(),
                                    copies.regions[i]);
            }
        }
    } else if (copies.scattered.count == 0) {
        return;
    }
    if (copies.scattered.count > 0) {
        awaitScene(commands, PipelineStage::eComputeShader, Access::eShaderStorageWrite);
        m_scatter.record(commands, copies.scattered);
    }
    awaitScene(commands, PipelineStage::eComputeShader, Access::eShaderStorageRead);
}

std::uint64_t BinningPass::listGroups(std::size_t cascades) const {
    const std::uint64_t lists = std::uint64_t{2} * cascades * m_groups.size();
    return (lists + shaders::kCommandsBlock - 1) / shaders::kCommandsBlock;
}

void BinningPass::requireGroups(std::size_t cascades) const {
    gpu::requireGroups(m_device, std::max(blocksOf(instances()), listGroups(cascades)), "a gpu-driven scene");
}

void BinningPass::record(vk::CommandBuffer commands, Kept kept, std::size_t cascades,
                         const std::vector<vk::DescriptorSet>& sets) const {
    constexpr auto kUsed = Access::eShaderStorageRead | Access::eShaderStorageWrite;
    m_device.beginLabel(commands, "cull and bin");
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *m_layout, 0, sets, {});
    const auto dispatch = [&](vk::Pipeline pipeline, std::uint64_t groups, vk::PipelineStageFlags2 readers,
                              vk::AccessFlags2 access) {
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline);
        commands.dispatch(static_cast<std::uint32_t>(groups), 1, 1);
        gpu::memoryBarrier(commands, PipelineStage::eComputeShader, Access::eShaderStorageWrite, readers,
                           access);
    };
    dispatch(*m_count[static_cast<std::size_t>(kept)], blocksOf(instances()), PipelineStage::eComputeShader,
             kUsed);
    dispatch(*m_scan, 1, PipelineStage::eComputeShader, kUsed);
    dispatch(*m_fill, blocksOf(instances()), PipelineStage::eComputeShader, kUsed);
    dispatch(*m_commands, listGroups(cascades),
             PipelineStage::eDrawIndirect | PipelineStage::eVertexAttributeInput | PipelineStage::eHost,
             Access::eIndirectCommandRead | Access::eVertexAttributeRead | Access::eHostRead);
    m_device.endLabel(commands);
}

} // namespace cdr::render
