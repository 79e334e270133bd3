#pragma once

#include <cdr/render/submit/draw_path.h>
#include <cdr/visibility/bin.h>

namespace cdr::render {

/// Draws that the CPU bins, and the buffer their records are written to: what both recorded paths share.
class HostDraws {
  public:
    HostDraws(const gpu::Device& device, const scene::Scene& scene, const GeometryPass& pass,
              host::WorkerPool& workers, host::Trace* trace)
        : m_device(device),
          m_scene(scene),
          m_pass(pass),
          m_workers(workers),
          m_trace(trace) {}

    /// Bins, chooses levels of detail and makes room for the records. base::RunError when the device has no
    /// buffer as large.
    void bin(const CutView& view, FrameStats& stats);
    /// What recording the binned draws reads; the view must outlive it.
    GeometryPass::Recording recording(const CutView& view) const;
    /// Shows the records to the device. Once all are written, before the frame is submitted.
    void flush() const { m_records.flush(); }

    const visibility::DrawLists& lists() const { return m_lists; }
    const GeometryPass& pass() const { return m_pass; }
    host::WorkerPool& workers() const { return m_workers; }

  private:
    void growRecords();

    const gpu::Device& m_device;
    const scene::Scene& m_scene;
    const GeometryPass& m_pass;
    host::WorkerPool& m_workers;
    host::Trace* m_trace;
    visibility::DrawLists m_lists; ///< kept from frame to frame so that a warm one allocates nothing
    gpu::Buffer m_records;
};

} // namespace cdr::render
