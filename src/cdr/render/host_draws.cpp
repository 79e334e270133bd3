#include <cdr/base/error.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/host_draws.h>

#include <fmt/format.h>

#include <algorithm>

namespace cdr::render {

void HostDraws::bin(const CutView& view, FrameStats& stats) {
    scene::binByDistance(view.visible, view.clipRanges, m_pass.pipelines().wideSpan(view.clipRanges.size()),
                         m_workers, m_lists);
    growRecords();
    stats.visible = m_lists.visible;
    stats.draws = m_lists.draws();
    stats.duplication = m_lists.duplication();
}

void HostDraws::growRecords() {
    const std::size_t draws = m_lists.draws();
    if (m_set && draws <= m_records.size() / sizeof(shaders::DrawRecord)) {
        return;
    }
    // Half as many again, so that a camera that turns does not make a new buffer at every frame.
    const std::size_t bytes = std::max<std::size_t>(draws + draws / 2, 1024) * sizeof(shaders::DrawRecord);
    if (bytes > m_device.info().maxStorageBufferBytes) {
        throw base::RunError(fmt::format("{} draws need a {} byte buffer, {} allows {}", draws, bytes,
                                         m_device.info().name, m_device.info().maxStorageBufferBytes));
    }
    m_records = gpu::Buffer(m_device, bytes, vk::BufferUsageFlagBits::eStorageBuffer,
                            gpu::MemoryUse::hostWrites, "draw records");
    m_pool = gpu::makeDescriptorPool(m_device, 1, 1, {vk::DescriptorType::eStorageBuffer});
    m_set = m_pass.makeRecordSet(m_device, *m_pool, m_records.handle());
}

GeometryPass::Recording HostDraws::recording(const CutView& view) const {
    return {.camera = view.camera,
            .lists = m_lists,
            .cascades = view.cascades,
            .records = m_records.as<shaders::DrawRecord>(m_lists.draws()),
            .recordSet = m_set,
            .extent = m_extent,
            .trace = m_trace};
}

} // namespace cdr::render
