#pragma once

#include <cdr/render/occluders/device_occlusion.h>
#include <cdr/render/submit/device_lists.h>

#include <optional>
#include <string>

namespace cdr::render {

/// Compute passes cull and bin into indirect draws with counts; the CPU writes the camera and a handful of
/// commands. Ranks come from masks and sums, not from who is first, so the draws are the CPU path's in the
/// CPU path's order.
class GpuDrivenPath final : public OnePrimaryPath {
  public:
    /// @param occlusion leaves out what is hidden, or null.
    GpuDrivenPath(const gpu::Device& device, BinningPass& binning, const GeometryPass& pass,
                  DeviceOcclusion* occlusion, const std::string& name);

    bool needsVisible() const override { return false; }
    void bin(const FrameView& view, const visibility::VisibleCells&, FrameStats& stats) override;
    void begin(const FrameView& view, const HostCommands& host) override;
    bool isEmpty(std::size_t) const override { return false; } ///< only the device knows
    void noteLaunched() override { m_binning.noteLaunched(); }
    void noteDropped() override { m_binning.noteDropped(); }
    bool settle(FrameStats& stats) override;

  private:
    void drawCascade(std::size_t cascade) override;

    BinningPass& m_binning;
    const GeometryPass& m_pass;
    DeviceOcclusion* m_occlusion; ///< null without occlusion culling
    DeviceLists m_lists;
    std::optional<DeviceLists> m_first; ///< of occluders
    DeviceOcclusion::Slot m_occlusionSlot;
    BinningPass::Copies m_copies;
    const FrameView* m_frame = nullptr; ///< that is being recorded
    const HostCommands* m_host = nullptr;
};

} // namespace cdr::render
