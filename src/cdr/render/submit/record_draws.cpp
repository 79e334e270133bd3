#include <cdr/render/submit/record_draws.h>

namespace cdr::render {

void RecordDraws::makeRoom(std::size_t draws) {
    gpu::growRecords(device(), m_records, draws, sizeof(shaders::DrawRecord), "draws");
}

void RecordDraws::record(vk::CommandBuffer commands, const DrawJob& job, const FrameView& view) const {
    m_pass.record(commands, job,
                  {.view = view,
                   .lists = lists(),
                   .radii = scene().instances.radius,
                   .records = m_records.as<shaders::DrawRecord>(lists().draws()),
                   .recordBuffer = m_records.handle()});
}

} // namespace cdr::render
