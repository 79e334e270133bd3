#pragma once

#include <cdr/render/submit/host_draws.h>
#include <cdr/render/submit/worker_command_pools.h>

#include <memory>
#include <string>
#include <vector>

namespace cdr::render {

/// The control without secondaries. Each rendering scope is a primary of its own, which any worker records. What belongs
/// between scopes is in primaries of its own too. One submit takes them all in order. A scope that clears depth between
/// cascades becomes one for each. So no more threads have work than there are cascades, and one-pass targets keep one busy. A
/// suspended scope could go on in the next primary. But the validation layer of Debian 12 (1.3.239) reports that as an error
/// from the third primary on.
class PrimaryPath final : public DrawPath {
  public:
    PrimaryPath(const gpu::Device& device, std::unique_ptr<HostDraws> draws, const std::string& name);

    bool needsVisible() const override { return true; }
    void bin(const FrameView& view, const visibility::VisibleCells& visible, FrameStats& stats) override {
        m_draws->bin(view, visible, stats);
    }
    void begin(const FrameView& view, const HostCommands&) override;
    bool isEmpty(std::size_t cascade) const override { return m_draws->lists().range(cascade).size() == 0; }
    vk::CommandBuffer primary() override;
    void drawScope(const GBufferScope& scope, std::span<const std::size_t> cascades) override;
    std::span<const vk::CommandBuffer> endDraws(const FrameView& view) override;
    std::span<const vk::CommandBuffer> end(const FrameView& view) override { return endDraws(view); }
    bool settle(FrameStats&) override { return true; }
    vk::BufferView facets() const override { return m_draws->facets(); }

  private:
    /// A rendering scope: all that the targets asked for, or one cascade of it.
    struct Part {
        GBufferScope scope;
        std::vector<std::size_t> cascades;
        std::size_t slot; ///< into m_commands
    };
    void recordPart(vk::CommandBuffer commands, const Part& part, const FrameView& view) const;
    void closeBetween();

    const gpu::Device& m_device;
    std::unique_ptr<HostDraws> m_draws;
    WorkerCommandPools m_pools;
    gpu::CommandPool m_betweenPool;
    vk::CommandBuffer m_between; ///< recording; null where a scope came last
    std::vector<Part> m_parts;
    std::vector<vk::CommandBuffer> m_commands; ///< in the order they run; null where a scope's goes
    std::size_t m_ended = 0;                   ///< of them, by endDraws()
};

} // namespace cdr::render
