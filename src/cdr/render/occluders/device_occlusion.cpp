#include <cdr/base/format_error.h>
#include <cdr/gpu/commands.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/occluders/device_occlusion.h>
#include <cdr/render/occluders/order_margin.h>
#include <cdr/render/stages.h>
#include <cdr/render/submit/binning_pass.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/shaders/binning_shared.h>
#include <cdr/shaders/occluders.h>
#include <cdr/shaders/occluders_shared.h>
#include <cdr/visibility/depth_tiles.h>
#include <cdr/visibility/occluders.h>

#include <algorithm>

namespace cdr::render {

namespace {

constexpr auto kBufferType = vk::DescriptorType::eStorageBuffer;
constexpr std::uint32_t kBuffers = 4; ///< of the set: occluders.glsl
constexpr std::uint32_t kOcclusionSet = 1;

static_assert(shaders::kTileSide == visibility::DepthTiles::kSide); // both hide the same

std::uint32_t partsOf(std::uint32_t whole, std::uint32_t part) {
    return (whole + part - 1) / part;
}

/// How many tiles or squares a picture has.
struct Grid {
    std::uint32_t columns;
    std::uint32_t rows;

    std::uint32_t size() const { return columns * rows; }
    Grid coarser(std::uint32_t side) const { return {partsOf(columns, side), partsOf(rows, side)}; }
};

Grid tilesOf(vk::Extent2D extent) {
    return Grid{extent.width, extent.height}.coarser(shaders::kTileSide);
}

std::size_t tileBytes(vk::Extent2D extent) {
    const Grid tiles = tilesOf(extent);
    return (tiles.size() + tiles.coarser(shaders::kSquareSide).size()) * sizeof(float);
}

gpu::Buffer makeBuffer(const gpu::Device& device, std::size_t bytes, const char* name,
                       vk::BufferUsageFlags usage = {}) {
    return {device, bytes, vk::BufferUsageFlagBits::eStorageBuffer | usage, gpu::MemoryUse::deviceOnly, name};
}

constexpr auto kUsed = Access::eShaderStorageRead | Access::eShaderStorageWrite;

} // namespace

gpu::SetLayout DeviceOcclusion::makeLayout(const gpu::Device& device) {
    return gpu::makeSetLayout(device, {std::vector(kBuffers, kBufferType), vk::ShaderStageFlagBits::eCompute},
                              "occlusion set");
}

DeviceOcclusion::DeviceOcclusion(const gpu::Device& device, const GeometryPass& depthPass,
                                 const gpu::SetLayout& layout, const depth::Technique& technique,
                                 vk::Extent2D extent)
    : m_device(device),
      m_depthPass(depthPass),
      m_setLayout(layout),
      m_technique(technique),
      m_extent(extent),
      m_depth(device, occluderDepthOptions(extent), "occluder depth"),
      m_copy(makeBuffer(device, occluderCopyBytes(extent), "occluder depth copy",
                        vk::BufferUsageFlagBits::eTransferDst)),
      m_tiles(makeBuffer(device, tileBytes(extent), "occluder tiles")),
      // Shaders name the set as those of BinningPass do, where another one comes first.
      m_layout(gpu::makePipelineLayout(device, {{layout, layout}, {}}, "occlusion layout")),
      m_reduce(gpu::makeComputePipeline(device, {"reduce depth", kReduceDepthComp, m_layout})),
      m_reduceSquares(
          gpu::makeComputePipeline(device, {"reduce depth, squares", kReduceDepthSquaresComp, m_layout})) {}

std::uint64_t DeviceOcclusion::predictBytes(const gpu::Device& device, vk::Extent2D extent) {
    return gpu::predictBytes(device, occluderDepthOptions(extent)) + occluderCopyBytes(extent) +
           tileBytes(extent);
}

void DeviceOcclusion::requireLimits(const gpu::Device& device, vk::Extent2D extent) {
    const std::uint64_t bytes = occluderCopyBytes(extent);
    if (bytes > device.info().maxStorageBufferBytes) {
        throw base::runError(
            "occlusion culling of a {}x{} picture on the device needs a {} byte buffer, {} allows {}",
            extent.width, extent.height, bytes, device.info().name, device.info().maxStorageBufferBytes);
    }
    // The passes that count read both sets.
    constexpr std::uint32_t kBothSets = BinningPass::kBindings + kBuffers;
    const std::uint32_t most =
        vk::PhysicalDevice(device.physical()).getProperties().limits.maxPerStageDescriptorStorageBuffers;
    if (most < kBothSets) {
        throw base::runError(
            "occlusion culling on the device needs {} storage buffers in a shader, {} allows {}", kBothSets,
            device.info().name, most);
    }
    gpu::requireGroups(device, partsOf(tilesOf(extent).size(), shaders::kReduceBlock),
                       "occlusion culling on the device");
}

DeviceOcclusion::Slot DeviceOcclusion::makeSlot() const {
    Slot slot{.view = gpu::Buffer(m_device, sizeof(shaders::OccluderView),
                                  vk::BufferUsageFlagBits::eStorageBuffer, gpu::MemoryUse::hostWrites,
                                  "occluder view"),
              .set = {m_device, m_setLayout}};
    slot.set.setBuffer(0, slot.view);
    slot.set.setBuffer(2, m_copy);
    slot.set.setBuffer(3, m_tiles);
    return slot;
}

void DeviceOcclusion::provideSeen(std::size_t instances) {
    // The passes write whole blocks.
    const std::size_t blocks = BinningPass::blocksOf(instances);
    const std::size_t bytes = std::max<std::size_t>(blocks, 1) * shaders::kBinBlock / 8;
    if (m_seen != nullptr && m_seen->size() >= bytes) {
        return;
    }
    const std::size_t room =
        gpu::roomToGrow(m_device, {.count = bytes, .most = m_device.info().maxStorageBufferBytes},
                        gpu::MemoryUse::deviceOnly, "what was seen of a gpu-driven scene");
    m_seen = std::make_shared<const gpu::Buffer>(makeBuffer(m_device, room, "seen instances"));
    m_hasSeen = false;
}

void DeviceOcclusion::prepare(const FrameView& view, std::size_t instances, Slot& slot) {
    provideSeen(instances);
    if (slot.seen != m_seen) { // frames in flight keep the old one
        slot.seen = m_seen;
        slot.set.setBuffer(1, *m_seen);
    }
    const double leastPixels = m_hasSeen ? visibility::kMinOccluder : visibility::kMinFirstOccluder;
    const OrderMargin margin(m_technique, view);
    const Grid tiles = tilesOf(m_extent);
    auto& block = slot.view.as<shaders::OccluderView>(1).front();
    block = {.tanX = view.frustum.tanX,
             .tanY = view.frustum.tanY,
             .leastRadius = leastPixels * view.frustum.footprintSlope,
             .nearView = view.camera.nearView,
             .width = m_extent.width,
             .height = m_extent.height,
             .columns = tiles.columns,
             .rows = tiles.rows,
             .hasSeen = m_hasSeen ? 1u : 0u,
             .nodesPerRatio = static_cast<float>(margin.nodesPerRatio()),
             .unused = {},
             .margins = {}};
    std::transform(margin.nodes().begin(), margin.nodes().end(), block.margins,
                   [](double node) { return static_cast<float>(node); });
    slot.view.flush();
    m_hasSeen = true; // by the next frame. What a frame that never ran left there is as good as any choice.
}

void DeviceOcclusion::begin(vk::CommandBuffer primary) const {
    // Frames before saw other instances, and read the tiles and the copy.
    gpu::memoryBarrier(primary, PipelineStage::eComputeShader, Access::eShaderStorageWrite,
                       PipelineStage::eComputeShader | PipelineStage::eCopy, kUsed | Access::eTransferWrite);
}

void DeviceOcclusion::draw(vk::CommandBuffer primary, const Slot& slot,
                           const GeometryPass::IndirectDraws& occluders, const FrameView& view) const {
    m_device.beginLabel(primary, "occluders");
    beginOccluders(primary, m_depth, {});
    const FrameView depthView = occluderView(view);
    for (std::size_t cascade = 0; cascade < view.cascades.size(); ++cascade) {
        m_depthPass.recordIndirect(primary, depthView, cascade, occluders);
    }
    primary.endRendering();
    copyOccluders(primary, m_depth, m_copy.handle());
    gpu::memoryBarrier(primary, PipelineStage::eCopy, Access::eTransferWrite, PipelineStage::eComputeShader,
                       kUsed);
    primary.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *m_layout, kOcclusionSet, *slot.set, {});
    const Grid tiles = tilesOf(m_extent);
    const auto reduce = [&](vk::Pipeline pipeline, const Grid& grid) {
        primary.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline);
        primary.dispatch(partsOf(grid.size(), shaders::kReduceBlock), 1, 1);
        gpu::memoryBarrier(primary, PipelineStage::eComputeShader, Access::eShaderStorageWrite,
                           PipelineStage::eComputeShader, kUsed);
    };
    reduce(*m_reduce, tiles);
    reduce(*m_reduceSquares, tiles.coarser(shaders::kSquareSide));
    m_device.endLabel(primary);
}

} // namespace cdr::render
