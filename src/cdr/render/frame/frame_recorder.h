#pragma once

#include <cdr/platform/stage_watch.h>
#include <cdr/render/frame/frame_passes.h>

namespace cdr::render {

/// Whether a host may read the images of a frame, in any pipeline stage.
enum class HostReads : std::uint8_t { none, anyStage };

/// Writes the commands of a frame that was decided, in their order. It keeps nothing: what it writes follows from the slot
/// and the passes. Each function adds to FrameSlot::commands and to what the slot's path records.
class FrameRecorder {
  public:
    /// All must outlive it.
    FrameRecorder(const gpu::Device& device, const DrawnScene& drawn, const RenderOptions& options,
                  FramePasses& passes)
        : m_device(device),
          m_drawn(drawn),
          m_options(options),
          m_passes(passes) {}

    /// First: lists the frame's draws and begins its commands. @param watch that times the frame up to its submission.
    void begin(FrameSlot& slot, const Delivery& delivery, const visibility::VisibleCells& visible,
               platform::StageWatch& watch) const;
    /// Makes the targets attachments, once a host that knows the frame's images has read the last one's. @param primary
    /// of this frame, or of another that is submitted before.
    void beginTargets(VkCommandBuffer primary, HostReads reads) const;
    /// The cascades, into the targets.
    void recordDraws(FrameSlot& slot) const;
    /// Ends the commands so far, which are submitted ahead of the rest.
    void endDraws(FrameSlot& slot) const;
    /// All that follows the draws.
    void recordRest(FrameSlot& slot, const Delivery& delivery) const;

  private:
    /// Where surfaces are lit while they are drawn: draws a visibility buffer for whoever reads the frame's surfaces.
    void recordReadSurfaces(FrameSlot& slot, const HostFrame* host,
                            const visibility::VisibleCells& visible) const;
    void recordShading(FrameSlot& slot) const;
    /// Resolves the G-buffer of a visibility buffer where somebody reads it, and works out motion.
    void recordSurfaces(FrameSlot& slot, const Delivery& delivery) const;

    const gpu::Device& m_device;
    const DrawnScene& m_drawn;
    const RenderOptions& m_options;
    FramePasses& m_passes;
};

} // namespace cdr::render
