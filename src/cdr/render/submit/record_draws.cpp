#include <cdr/render/submit/record_draws.h>

#include <fmt/format.h>

namespace cdr::render {

void RecordDraws::makeRoom(std::size_t draws) {
    if (m_records.size() > 0 && draws <= m_records.size() / sizeof(shaders::DrawRecord)) {
        return;
    }
    const std::size_t bytes = roomFor(draws) * sizeof(shaders::DrawRecord);
    gpu::requireDeviceBytes(device(), bytes, fmt::format("the records of {} draws", draws));
    m_records = gpu::Buffer(device(), bytes, vk::BufferUsageFlagBits::eVertexBuffer,
                            gpu::MemoryUse::hostWrites, "draw records");
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
