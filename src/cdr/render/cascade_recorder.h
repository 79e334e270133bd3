#pragma once

#include <cdr/gpu/commands.h>
#include <cdr/render/geometry_pass.h>

#include <vulkan/vulkan.hpp>

#include <span>
#include <vector>

namespace cdr::render {

/// Cuts draw lists into jobs: contiguous ranges within one cascade, cascades in order, of about equal size.
/// One thread gets one job per cascade; more threads get a few each, so an uneven one does not hold up the
/// rest.
std::vector<DrawJob> makeJobs(const scene::DrawLists& lists, std::size_t threads);

/// Records cascades into secondary command buffers on worker threads, for one frame slot.
///
/// Each worker owns a command pool, reset whole at every frame. A job's secondary lands in the slot of the
/// job's index, so the order of execution never depends on which worker finished first.
class CascadeRecorder {
  public:
    CascadeRecorder(const gpu::Device& device, std::size_t threads, const std::string& name);

    /// Takes back the last frame's command buffers, which must have finished, and records this frame's.
    void record(base::WorkerPool& workers, const GeometryPass& pass,
                const GeometryPass::Recording& recording);

    /// The secondaries of one cascade, in draw order; valid until the next record().
    std::span<const vk::CommandBuffer> commands(std::size_t cascade) const;
    /// Those of all cascades, the nearest first.
    std::span<const vk::CommandBuffer> commands() const { return m_commands; }
    std::size_t jobs() const { return m_jobs.size(); }

  private:
    std::vector<gpu::CommandPool> m_pools; ///< by worker
    std::vector<DrawJob> m_jobs;
    std::vector<vk::CommandBuffer> m_commands; ///< by job
    std::vector<std::size_t> m_cascadeBegins;  ///< first job of each cascade, and the end
};

} // namespace cdr::render
