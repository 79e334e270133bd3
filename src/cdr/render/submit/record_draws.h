#pragma once

#include <cdr/render/geometry/geometry_pass.h>
#include <cdr/render/submit/host_draws.h>

namespace cdr::render {

/// Draws into a G-buffer, each with a draw record.
class RecordDraws final : public HostDraws {
  public:
    RecordDraws(const HostDrawsContext& context, const GeometryPass& pass)
        : HostDraws(context),
          m_pass(pass) {}

    void record(vk::CommandBuffer commands, const DrawJob& job, const FrameView& view) const override {
        m_pass.record(commands, job,
                      {.view = view,
                       .lists = lists(),
                       .radii = scene().instances.radius,
                       .records = m_records.as<shaders::DrawRecord>(lists().draws()),
                       .recordBuffer = m_records.handle()});
    }
    void flush() const override { m_records.flush(); }
    ScopeFormats formats() const override { return m_pass.pipelines().formats(); }

  protected:
    depth::Mapping mapping() const override { return m_pass.pipelines().mapping(); }
    void makeRoom(std::size_t draws) override {
        gpu::growRecords(device(), m_records, draws, sizeof(shaders::DrawRecord), "draws");
    }

  private:
    const GeometryPass& m_pass;
    gpu::Buffer m_records;
};

} // namespace cdr::render
