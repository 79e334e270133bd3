#include <cdr/base/format_error.h>
#include <cdr/depth/cascade.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/submit/device_lists.h>
#include <cdr/shaders/binning_shared.h>

#include <algorithm>
#include <cmath>

namespace cdr::render {

namespace {

constexpr std::uint32_t kFirstList = 1 + BinningPass::kSceneBuffers;
constexpr std::uint32_t kResult = BinningPass::kBindings - 1;

static_assert(shaders::kCascadeSlots == depth::kMaxCascades);
static_assert(shaders::kDetailPerCascade == static_cast<std::uint32_t>(visibility::DetailMode::perCascade));

void copyTo(const glm::dvec3& from, double (&to)[3]) {
    std::copy_n(&from.x, 3, to);
}

/// What visibility::cullSpheres() tests with, and visibility::binByDistance().
shaders::BinningView viewOf(const FrameView& view, double wideSpan) {
    const scene::Camera& camera = view.camera;
    shaders::BinningView block{};
    copyTo(camera.position, block.position);
    copyTo(camera.right, block.right);
    copyTo(camera.up, block.up);
    copyTo(-camera.back, block.ahead);
    block.cosX = view.frustum.cosX;
    block.sinX = view.frustum.sinX;
    block.cosY = view.frustum.cosY;
    block.sinY = view.frustum.sinY;
    block.centreX = view.frustum.centre.x;
    block.centreY = view.frustum.centre.y;
    block.nearView = camera.nearView;
    block.farView = camera.farView;
    block.hasWideSpan = std::isfinite(wideSpan) ? 1 : 0;
    block.wideSpan = std::isfinite(wideSpan) ? wideSpan : 0.0;
    block.levelSlope = view.levels.slope;
    block.detailMode = static_cast<std::uint32_t>(view.levels.mode);
    block.cascades = static_cast<std::uint32_t>(view.cascades.size());
    for (std::size_t c = 0; c < view.cascades.size(); ++c) {
        const CascadeView& cascade = view.cascades[c];
        block.nearViews[c] = cascade.clipRange.nearView;
        block.farViews[c] = cascade.clipRange.farView;
        block.anchors[c] = cascade.terms.anchorView;
    }
    return block;
}

} // namespace

DeviceLists::DeviceLists(const gpu::Device& device, const BinningPass& binning)
    : m_device(device),
      m_binning(binning),
      m_view(device, sizeof(shaders::BinningView), vk::BufferUsageFlagBits::eStorageBuffer,
             gpu::MemoryUse::hostWrites, "binning view"),
      m_result(device, sizeof(shaders::BinningResult), vk::BufferUsageFlagBits::eStorageBuffer,
               gpu::MemoryUse::hostReads, "binning result"),
      m_set(device, binning.layout()),
      m_draws{.commands = {}, .counts = {}, .runs = 0, .groups = {}, .records = {}} {
    m_set.setBuffer(0, m_view);
    m_set.setBuffer(kResult, m_result);
}

void DeviceLists::grow(List list, std::size_t bytes) {
    if (m_lists[list].size() > 0 && bytes <= m_lists[list].size()) {
        return;
    }
    bytes = std::max<std::size_t>(bytes, sizeof(shaders::DrawRecord)); // no buffer is empty
    const std::size_t most = m_device.info().maxStorageBufferBytes;
    if (bytes > most) {
        throw base::runError("gpu-driven draws need a {} byte buffer, {} allows {}", bytes,
                             m_device.info().name, most);
    }
    constexpr const char* kWhat = "a list of gpu-driven draws";
    // How many records there are is guessed at first.
    if (list == records || m_lists[list].size() > 0) {
        bytes = gpu::roomToGrow(m_device, {.count = bytes, .most = most}, gpu::MemoryUse::deviceOnly, kWhat);
    } else {
        gpu::requireDeviceBytes(m_device, bytes, kWhat);
    }
    m_lists[list] =
        gpu::Buffer(m_device, bytes,
                    vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eIndirectBuffer |
                        vk::BufferUsageFlagBits::eVertexBuffer,
                    gpu::MemoryUse::deviceOnly, "gpu-driven list");
    m_set.setBuffer(kFirstList + static_cast<std::uint32_t>(list), m_lists[list]);
}

void DeviceLists::growRecords(std::size_t draws) {
    grow(records, draws * sizeof(shaders::DrawRecord));
    m_recordCapacity = m_lists[records].size() / sizeof(shaders::DrawRecord);
    m_draws.records = m_lists[records].handle();
}

void DeviceLists::growLists(std::size_t cascades) {
    m_binning.requireGroups(cascades);
    const std::size_t buckets = 2 * cascades;
    const std::size_t blocks = BinningPass::blocksOf(m_binning.instances());
    if (m_recordCapacity == 0 || m_recordCapacity < m_binning.instances()) {
        growRecords(m_binning.instances());
    }
    grow(landings, m_binning.instances() * sizeof(std::uint32_t));
    grow(blockDraws, (buckets + 1) * blocks * sizeof(std::uint32_t));
    grow(runFirsts, buckets * m_binning.runs() * sizeof(std::uint32_t));
    grow(commands, buckets * m_binning.runs() * sizeof(shaders::IndirectCommand));
    grow(counts, buckets * m_binning.groups().size() * sizeof(std::uint32_t));
    m_draws.commands = m_lists[commands].handle();
    m_draws.counts = m_lists[counts].handle();
}

void DeviceLists::prepare(const FrameView& view, depth::Mapping mapping) {
    m_draws.runs = m_binning.runs();
    m_draws.groups = m_binning.groups();
    growLists(view.cascades.size());
    shaders::BinningView block = viewOf(view, wideSpan(mapping, view.cascades.size()));
    block.instances = static_cast<std::uint32_t>(m_binning.instances());
    block.blocks = static_cast<std::uint32_t>(BinningPass::blocksOf(m_binning.instances()));
    block.runs = static_cast<std::uint32_t>(m_binning.runs());
    block.groups = static_cast<std::uint32_t>(m_binning.groups().size());
    block.recordCapacity = static_cast<std::uint32_t>(m_recordCapacity);
    m_view.as<shaders::BinningView>(1).front() = block;
    m_view.flush();
    m_result.as<shaders::BinningResult>(1).front() = {}; // stays so where there is nothing to bin
    m_result.flush();
}

const shaders::BinningResult* DeviceLists::settle() {
    m_result.invalidate();
    const shaders::BinningResult& result = m_result.as<shaders::BinningResult>(1).front();
    if (result.draws > m_recordCapacity) {
        growRecords(result.draws);
        return nullptr;
    }
    return &result;
}

} // namespace cdr::render
