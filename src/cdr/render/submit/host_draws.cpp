#include <cdr/render/submit/host_draws.h>

#include <fmt/format.h>

#include <algorithm>

namespace cdr::render {

void HostDraws::bin(const FrameView& view, const visibility::VisibleList& visible, FrameStats& stats) {
    const depth::Cascades clipRanges = view.clipRanges();
    visibility::binByDistance(visible, clipRanges, m_pass.pipelines().wideSpan(clipRanges.size()), m_workers,
                              m_lists);
    visibility::chooseLevels(m_scene, view.camera, clipRanges, view.levels, m_workers, m_lists);
    growRecords();
    stats.visible = m_lists.visible;
    stats.draws = m_lists.draws();
    stats.duplication = m_lists.duplication();
}

void HostDraws::growRecords() {
    const std::size_t draws = m_lists.draws();
    if (m_records.size() > 0 && draws <= m_records.size() / sizeof(shaders::DrawRecord)) {
        return;
    }
    // Half as many again, so that a camera that turns does not make a new buffer at every frame.
    const std::size_t bytes = std::max<std::size_t>(draws + draws / 2, 1024) * sizeof(shaders::DrawRecord);
    gpu::requireDeviceBytes(m_device, bytes, fmt::format("the records of {} draws", draws));
    m_records = gpu::Buffer(m_device, bytes, vk::BufferUsageFlagBits::eVertexBuffer,
                            gpu::MemoryUse::hostWrites, "draw records");
}

GeometryPass::Recording HostDraws::recording(const FrameView& view) const {
    return {.view = view,
            .lists = m_lists,
            .records = m_records.as<shaders::DrawRecord>(m_lists.draws()),
            .recordBuffer = m_records.handle(),
            .trace = m_trace};
}

} // namespace cdr::render
