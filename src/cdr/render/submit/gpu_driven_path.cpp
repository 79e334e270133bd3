#include <cdr/base/error.h>
#include <cdr/render/submit/gpu_driven_path.h>

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
    : OnePrimaryPath(device, name, {}),
      m_binning(binning),
      m_pass(pass),
      m_occlusion(occlusion),
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
    beginPrimary(host.into);
    m_binning.recordCopies(primary(), m_copies);
    if (!m_first) {
        m_binning.record(primary(), BinningPass::Kept::all, view.cascades.size(), {*m_lists.set()});
        return;
    }
    m_occlusion->begin(primary());
    m_binning.record(primary(), BinningPass::Kept::occluders, view.cascades.size(),
                     {*m_first->set(), *m_occlusionSlot.set});
    m_occlusion->draw(primary(), m_occlusionSlot, m_first->draws(), view);
    m_binning.record(primary(), BinningPass::Kept::shown, view.cascades.size(),
                     {*m_lists.set(), *m_occlusionSlot.set});
}

void GpuDrivenPath::drawCascade(std::size_t cascade) {
    m_pass.recordIndirect(primary(), *m_frame, cascade, m_lists.draws());
    if (m_host->draw) {
        m_host->draw(primary(), cascade);
    }
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
