#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/geometry/draw_job.h>
#include <cdr/render/submit/draw_path.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/visibility/bin_cells.h>

namespace cdr::render {

/// What draws on the CPU are made with.
struct HostDrawsContext {
    const gpu::Device& device;
    const scene::Scene& scene;
    platform::WorkerPool& workers;
    platform::Trace* trace = nullptr;
};

/// Draws that the CPU bins and writes for the device: what both recorded paths share. What is written depends on
/// the surfaces that are drawn.
class HostDraws {
  public:
    explicit HostDraws(const HostDrawsContext& context) : m_context(context) {}
    virtual ~HostDraws() = default;
    HostDraws(const HostDraws&) = delete;
    HostDraws& operator=(const HostDraws&) = delete;

    /// Bins, chooses levels of detail and makes room. base::RunError when the device has no buffers as large.
    void bin(const FrameView& view, const visibility::VisibleCells& visible, FrameStats& stats);
    /// Writes what the draws of a job read, and their commands. `commands` is recording, inside a rendering scope.
    virtual void record(vk::CommandBuffer commands, const DrawJob& job, const FrameView& view) const = 0;
    /// Shows what was written to the device. Once all jobs are, before the frame is submitted.
    virtual void flush() const = 0;
    /// Of the scope that the draws are in.
    virtual ScopeFormats formats() const = 0;
    /// The records of all facets, two texels each; none where the surfaces are not facets.
    virtual vk::BufferView facets() const { return {}; }

    const visibility::DrawLists& lists() const { return m_lists; }
    platform::WorkerPool& workers() const { return m_context.workers; }
    platform::Trace* trace() const { return m_context.trace; }

  protected:
    const gpu::Device& device() const { return m_context.device; }
    const scene::Scene& scene() const { return m_context.scene; }
    virtual depth::Mapping mapping() const = 0;
    virtual void makeRoom(std::size_t draws) = 0;

  private:
    HostDrawsContext m_context;
    visibility::CellBinner m_binner;
    visibility::DrawLists m_lists; ///< kept from frame to frame so that a warm one allocates nothing
};

} // namespace cdr::render
