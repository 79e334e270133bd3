#pragma once

#include <cdr/render/submit/host_draws.h>
#include <cdr/render/submit/worker_command_pools.h>

#include <memory>
#include <string>
#include <vector>

namespace cdr::render {

/// Cuts draw lists into jobs: contiguous ranges within one cascade, cascades in order, of about equal size.
/// One thread gets one job per cascade; more threads get a few each, so an uneven one does not hold up the
/// rest.
std::vector<DrawJob> makeJobs(const visibility::DrawLists& lists, std::size_t threads);

/// Workers record the cascades into secondary command buffers, one primary executes them.
///
/// Each worker owns a command pool, reset whole at every frame. A job's secondary lands in the slot of the
/// job's index, so the order of execution never depends on which worker finished first.
class SecondaryPath final : public OnePrimaryPath {
  public:
    SecondaryPath(const gpu::Device& device, std::unique_ptr<HostDraws> draws, const std::string& name);

    bool needsVisible() const override { return true; }
    void bin(const FrameView& view, const visibility::VisibleCells& visible, FrameStats& stats) override {
        m_draws->bin(view, visible, stats);
    }
    void begin(const FrameView& view, const HostCommands& host) override;
    bool isEmpty(std::size_t cascade) const override {
        return !hostCommandsOf(cascade) && m_draws->lists().range(cascade).size() == 0;
    }
    /// Draws inside a rendering scope that the caller began in primary(), for secondaries.
    void drawInside(platform::IndexRange cascades);
    bool settle(FrameStats&) override { return true; }
    vk::BufferView facets() const override { return m_draws->facets(); }

  private:
    void drawCascade(std::size_t cascade) override { drawInside({cascade, cascade + 1}); }
    void recordJobs(const FrameView& view);
    void recordHost(platform::IndexRange cascades, const HostCommands& host);
    /// Of what a host draws; null where it draws nothing.
    vk::CommandBuffer hostCommandsOf(std::size_t cascade) const {
        return cascade < m_hostCommands.size() ? m_hostCommands[cascade] : vk::CommandBuffer();
    }

    std::unique_ptr<HostDraws> m_draws;
    WorkerCommandPools m_pools;
    gpu::CommandPool m_hostPool;
    std::vector<DrawJob> m_jobs;
    std::vector<vk::CommandBuffer> m_commands;     ///< by job
    std::vector<std::size_t> m_cascadeBegins;      ///< first job of each cascade, and the end
    std::vector<vk::CommandBuffer> m_hostCommands; ///< by cascade, up to the last in which a host draws
};

} // namespace cdr::render
