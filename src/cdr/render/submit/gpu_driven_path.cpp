#include <cdr/base/error.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/submit/gpu_driven_path.h>
#include <cdr/shaders/binning_shared.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cdr::render {

namespace {

constexpr auto kStorage = vk::DescriptorType::eStorageBuffer;
constexpr std::uint32_t kFirstList = 1 + BinningPass::kSceneBuffers;
constexpr std::uint32_t kResult = BinningPass::kBindings - 1;

void copy(const glm::dvec3& from, double (&to)[3]) {
    std::copy_n(&from.x, 3, to);
}

/// What visibility::cullSpheres() tests with, and visibility::binByDistance().
shaders::BinningView viewOf(const FrameView& view, double wideSpan) {
    const scene::Camera& camera = view.camera;
    shaders::BinningView block{};
    copy(camera.position, block.position);
    copy(camera.right, block.right);
    copy(camera.up, block.up);
    copy(-camera.back, block.ahead);
    block.cosX = view.frustum.cosX;
    block.sinX = view.frustum.sinX;
    block.cosY = view.frustum.cosY;
    block.sinY = view.frustum.sinY;
    block.nearView = camera.nearView;
    block.farView = camera.farView;
    block.hasWideSpan = std::isfinite(wideSpan) ? 1 : 0;
    block.wideSpan = std::isfinite(wideSpan) ? wideSpan : 0.0;
    block.levelSlope = view.levels.slope;
    block.detailMode = static_cast<std::uint32_t>(view.levels.mode);
    block.cascades = static_cast<std::uint32_t>(view.cascades.size());
    double farthest = 0.0;
    for (std::size_t c = 0; c < view.cascades.size(); ++c) {
        const CascadeView& cascade = view.cascades[c];
        farthest = std::max(farthest, cascade.clipRange.farView);
        block.nearViews[c] = cascade.clipRange.nearView;
        block.farViews[c] = farthest;
        block.anchors[c] = cascade.terms.anchorView;
    }
    return block;
}

} // namespace

GpuDrivenPath::GpuDrivenPath(const gpu::Device& device, BinningPass& binning, const GeometryPass& pass,
                             const std::string& name)
    : m_device(device),
      m_binning(binning),
      m_pass(pass),
      m_pool(device, vk::CommandBufferLevel::ePrimary, name),
      m_view(device, sizeof(shaders::BinningView), vk::BufferUsageFlagBits::eStorageBuffer,
             gpu::MemoryUse::hostWrites, "binning view"),
      m_result(device, sizeof(shaders::BinningResult), vk::BufferUsageFlagBits::eStorageBuffer,
               gpu::MemoryUse::hostReads, "binning result"),
      m_descriptors(gpu::makeDescriptorPool(device, 1, BinningPass::kBindings, {kStorage})),
      m_binningSet(gpu::allocateSet(device, *m_descriptors, binning.layout())),
      m_draws{.commands = {}, .counts = {}, .runs = 0, .groups = {}, .records = {}} {
    gpu::writeBufferBinding(device, m_binningSet, 0, kStorage, m_view.handle());
    gpu::writeBufferBinding(device, m_binningSet, kResult, kStorage, m_result.handle());
    growRecords(m_binning.instances());
}

void GpuDrivenPath::grow(List list, std::size_t bytes) {
    if (m_lists[list].size() > 0 && bytes <= m_lists[list].size()) {
        return;
    }
    bytes = std::max<std::size_t>(bytes, sizeof(shaders::DrawRecord)); // no buffer is empty
    if (bytes > m_device.info().maxStorageBufferBytes) {
        throw base::RunError(fmt::format("gpu-driven draws need a {} byte buffer, {} allows {}", bytes,
                                         m_device.info().name, m_device.info().maxStorageBufferBytes));
    }
    gpu::requireDeviceBytes(m_device, bytes, "a list of gpu-driven draws");
    m_lists[list] =
        gpu::Buffer(m_device, bytes,
                    vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eIndirectBuffer |
                        vk::BufferUsageFlagBits::eVertexBuffer,
                    gpu::MemoryUse::deviceOnly, "gpu-driven list");
    gpu::writeBufferBinding(m_device, m_binningSet, kFirstList + static_cast<std::uint32_t>(list), kStorage,
                            m_lists[list].handle());
}

void GpuDrivenPath::growRecords(std::size_t draws) {
    const std::size_t most = m_device.info().maxStorageBufferBytes / sizeof(shaders::DrawRecord);
    // Half as many again as were missing, where the device allows it.
    const std::size_t wanted = std::max(draws, std::min(most, draws + draws / 2));
    grow(records, wanted * sizeof(shaders::DrawRecord));
    m_recordCapacity = m_lists[records].size() / sizeof(shaders::DrawRecord);
    m_draws.records = m_lists[records].handle();
}

void GpuDrivenPath::growLists(std::size_t cascades) {
    const std::size_t buckets = 2 * cascades;
    const std::size_t blocks = (m_binning.instances() + shaders::kBinBlock - 1) / shaders::kBinBlock;
    grow(landings, m_binning.instances() * sizeof(std::uint32_t));
    grow(blockDraws, (buckets + 1) * blocks * sizeof(std::uint32_t));
    grow(runFirsts, buckets * m_binning.runs() * sizeof(std::uint32_t));
    grow(commands, buckets * m_binning.runs() * sizeof(shaders::IndirectCommand));
    grow(counts, buckets * m_binning.groups().size() * sizeof(std::uint32_t));
    m_draws.commands = m_lists[commands].handle();
    m_draws.counts = m_lists[counts].handle();
}

void GpuDrivenPath::bin(const FrameView& view, const visibility::VisibleCells&, FrameStats&) {
    if (m_binning.follow(m_copies)) {
        m_binning.bindScene(m_binningSet, *m_copies.buffers);
    }
    m_draws.runs = m_binning.runs();
    m_draws.groups = m_binning.groups();
    growLists(view.cascades.size());
    shaders::BinningView block = viewOf(view, wideSpan(m_pass.pipelines().mapping(), view.cascades.size()));
    block.instances = static_cast<std::uint32_t>(m_binning.instances());
    block.blocks =
        static_cast<std::uint32_t>((m_binning.instances() + shaders::kBinBlock - 1) / shaders::kBinBlock);
    block.runs = static_cast<std::uint32_t>(m_binning.runs());
    block.groups = static_cast<std::uint32_t>(m_binning.groups().size());
    block.recordCapacity = static_cast<std::uint32_t>(m_recordCapacity);
    m_view.as<shaders::BinningView>(1).front() = block;
    m_view.flush();
    m_result.as<shaders::BinningResult>(1).front() = {}; // stays so where there is nothing to bin
    m_result.flush();
}

void GpuDrivenPath::begin(const FrameView& view, const HostCommands& host) {
    m_frame = &view;
    m_host = &host;
    m_primary = host.into;
    if (!m_primary) {
        m_pool.reset();
        m_primary = m_pool.next();
        m_primary.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    }
    m_binning.record(m_primary, m_binningSet, view.cascades.size(), m_copies);
}

void GpuDrivenPath::drawScope(const GBufferScope& scope, host::IndexRange cascades) {
    m_device.beginLabel(m_primary, labelOf(cascades).c_str());
    beginGBufferScope(m_primary, scope, {});
    for (std::size_t cascade = cascades.begin; cascade < cascades.end; ++cascade) {
        m_pass.recordIndirect(m_primary, *m_frame, cascade, m_draws);
        if (m_host->draw) {
            m_host->draw(m_primary, cascade);
        }
    }
    m_primary.endRendering();
    m_device.endLabel(m_primary);
}

std::span<const vk::CommandBuffer> GpuDrivenPath::end(const FrameView&) {
    m_binning.noteRecorded();
    if (m_host->into) {
        return {};
    }
    m_primary.end();
    return {&m_primary, 1};
}

bool GpuDrivenPath::settle(FrameStats& stats) {
    m_result.invalidate();
    const shaders::BinningResult& result = m_result.as<shaders::BinningResult>(1).front();
    if (result.draws > m_recordCapacity) {
        growRecords(result.draws);
        return false;
    }
    stats.draws = result.draws;
    stats.visible = result.drawsAndVisible - result.draws;
    stats.duplication =
        stats.visible > 0 ? static_cast<double>(stats.draws) / static_cast<double>(stats.visible) : 1.0;
    return true;
}

} // namespace cdr::render
