#pragma once

#include <cdr/gpu/commands.h>
#include <cdr/render/submit/binning_pass.h>

#include <array>
#include <string>

namespace cdr::render {

/// Compute passes cull and bin into indirect draws with counts; the CPU writes the camera and a handful of
/// commands. Ranks come from masks and sums, not from who is first, so the draws are the CPU path's in the
/// CPU path's order.
class GpuDrivenPath final : public DrawPath {
  public:
    GpuDrivenPath(const gpu::Device& device, BinningPass& binning, const GeometryPass& pass,
                  const std::string& name);

    bool needsVisible() const override { return false; }
    void bin(const FrameView& view, const visibility::VisibleCells&, FrameStats& stats) override;
    void begin(const FrameView& view, const HostCommands& host) override;
    bool isEmpty(std::size_t) const override { return false; } ///< only the device knows
    vk::CommandBuffer primary() override { return m_primary; }
    void drawScope(const GBufferScope& scope, host::IndexRange cascades) override;
    std::span<const vk::CommandBuffer> end(const FrameView& view) override;
    bool settle(FrameStats& stats) override;

  private:
    enum List : std::size_t { landings, blockDraws, runFirsts, records, commands, counts, kLists };
    void growLists(std::size_t cascades);
    void growRecords(std::size_t draws);
    void grow(List list, std::size_t bytes);

    const gpu::Device& m_device;
    BinningPass& m_binning;
    const GeometryPass& m_pass;
    gpu::CommandPool m_pool;
    vk::CommandBuffer m_primary;
    gpu::Buffer m_view;
    gpu::Buffer m_result;
    std::array<gpu::Buffer, kLists> m_lists; ///< the slot's own, bindings from kFirstList on
    std::size_t m_recordCapacity = 0;
    vk::UniqueDescriptorPool m_descriptors;
    vk::DescriptorSet m_binningSet;
    BinningPass::Copies m_copies;
    GeometryPass::IndirectDraws m_draws;
    const FrameView* m_frame = nullptr; ///< that is being recorded
    const HostCommands* m_host = nullptr;
};

} // namespace cdr::render
