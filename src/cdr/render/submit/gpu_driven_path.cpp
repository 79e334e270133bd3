#include <cdr/base/error.h>
#include <cdr/render/submit/gpu_driven_path.h>
#include <cdr/render/targets/scope_commands.h>

#include <utility>

namespace cdr::render {

namespace {

/// Null where occluders found no room. They keep the room that they have where there is no more: the frame is good.
const shaders::BinningResult* settleOccluders(DeviceLists& occluders) {
    try {
        return occluders.settle();
    } catch (const base::RunError&) {
        return nullptr;
    }
}

} // namespace

GpuDrivenPath::GpuDrivenPath(const gpu::Device& device, BinningPass& binning, const GeometryPass& pass,
                             DeviceOcclusion* occlusion, const std::string& name)
    : m_device(device),
      m_binning(binning),
      m_pass(pass),
      m_occlusion(occlusion),
      m_pool(device, vk::CommandBufferLevel::ePrimary, name),
      m_lists(device, binning),
      m_copies(binning.makeCopies()) {
    if (occlusion != nullptr) {
        m_first.emplace(device, binning);
        m_occlusionSlot = occlusion->makeSlot();
    }
}

void GpuDrivenPath::bin(const FrameView& view, const visibility::VisibleCells&, FrameStats&) {
    if (m_binning.follow(m_copies)) {
        BinningPass::bindScene(m_lists.set(), *m_copies.buffers);
        if (m_first) {
            BinningPass::bindScene(m_first->set(), *m_copies.buffers);
        }
    }
    const depth::Mapping mapping = m_pass.pipelines().mapping();
    m_lists.prepare(view, mapping);
    if (m_first) {
        m_first->prepare(view, mapping);
        m_occlusion->prepare(view, m_binning.instances(), m_occlusionSlot);
    }
}

void GpuDrivenPath::begin(const FrameView& view, const HostCommands& host) {
    m_frame = &view;
    m_host = &host;
    m_primary = host.into;
    if (!m_primary) {
        m_pool.reset();
        m_primary = gpu::beginOnce(m_pool);
    }
    m_binning.recordCopies(m_primary, m_copies);
    if (!m_first) {
        m_binning.record(m_primary, BinningPass::Kept::all, view.cascades.size(), {*m_lists.set()});
        return;
    }
    m_occlusion->begin(m_primary);
    m_binning.record(m_primary, BinningPass::Kept::occluders, view.cascades.size(),
                     {*m_first->set(), *m_occlusionSlot.set});
    m_occlusion->draw(m_primary, m_occlusionSlot, m_first->draws(), view);
    m_binning.record(m_primary, BinningPass::Kept::shown, view.cascades.size(),
                     {*m_lists.set(), *m_occlusionSlot.set});
}

void GpuDrivenPath::drawScope(const GBufferScope& scope, std::span<const std::size_t> cascades) {
    m_device.beginLabel(m_primary, labelOf(cascades).c_str());
    beginGBufferScope(m_primary, scope, {});
    for (const std::size_t cascade : cascades) {
        if (scope.depthClear != nullptr && cascade != cascades.front()) {
            scope.depthClear->putInto(m_primary, {});
        }
        m_pass.recordIndirect(m_primary, *m_frame, cascade, m_lists.draws());
        if (m_host->draw) {
            m_host->draw(m_primary, cascade);
        }
    }
    m_primary.endRendering();
    m_device.endLabel(m_primary);
}

std::span<const vk::CommandBuffer> GpuDrivenPath::endDraws(const FrameView&) {
    if (m_host->into) {
        return {};
    }
    m_primary.end();
    m_endedDraws = std::exchange(m_primary, gpu::beginOnce(m_pool));
    return {&m_endedDraws, 1};
}

std::span<const vk::CommandBuffer> GpuDrivenPath::end(const FrameView&) {
    if (m_host->into) {
        return {};
    }
    m_primary.end();
    return {&m_primary, 1};
}

bool GpuDrivenPath::settle(FrameStats& stats) {
    const shaders::BinningResult* first = m_first ? settleOccluders(*m_first) : nullptr;
    const shaders::BinningResult* result = m_lists.settle();
    if (result == nullptr) {
        return false;
    }
    stats.draws = result->draws;
    stats.visible = result->drawsAndVisible - result->draws;
    stats.duplication =
        stats.visible > 0 ? static_cast<double>(stats.draws) / static_cast<double>(stats.visible) : 1.0;
    // Occluders that found no room hide nothing, and no frame is wrong for that.
    stats.occluders = {.draws = first != nullptr ? first->draws : 0, .hidden = result->hidden};
    return true;
}

} // namespace cdr::render
