#pragma once

#include <cdr/platform/stage_watch.h>
#include <cdr/render/frame/frame_equipment.h>
#include <cdr/render/output/motion_history.h>

#include <optional>

namespace cdr::render {

/// Decides what a frame shows and draws: what the camera sees, cascades, motion, shadows, occluders, translucent draws.
/// Remembers where things were in the last frame, for motion.
class FrameDecider {
  public:
    /// All must outlive it.
    FrameDecider(const gpu::Device& device, const DrawnScene& drawn, FrameEquipment& equipment,
                 platform::WorkerPool& workers);

    /// Fills a slot's view, statistics and inputs. What it replaces is kept in FrameSlot::before, for takeBack(). Where it
    /// throws, all was taken back.
    void decide(FrameSlot& slot, const scene::Camera& camera, const Delivery& delivery);
    /// The frame of decide() is not drawn: the frame before stays the last one.
    void takeBack(FrameSlot& slot);
    /// Before a frame is drawn again: lists once more what its slot no longer has.
    void decideAgain(FrameSlot& slot);

    /// Goes past a frame: motion is measured from it.
    void followMotion(const scene::Camera& camera);
    /// Goes past a frame: fitted cascades keep to it.
    void followCut(const scene::Camera& camera);
    /// The next frame is decided as a first one.
    void forgetFrames();
    /// The same of motion alone: nothing moves in the next frame.
    void forgetMotion();

    /// Whether a frame of the next slot reads the visible list.
    bool readsVisible() const { return readsVisible(m_equipment.slots().next()); }
    /// What the camera sees but blended instances. Whoever culls for several views fills it.
    visibility::VisibleCells& visible() { return m_visible; }

  private:
    /// What is seen, and the cascades that it is cut into.
    void decideView(FrameSlot& slot, const scene::Camera& camera, const Delivery& delivery,
                    platform::StageWatch& watch);
    /// What each pass reads of that.
    void decideInputs(FrameSlot& slot, const Delivery& delivery, platform::StageWatch& watch);
    void decideMotion(FrameSlot& slot);
    void decideTranslucent(FrameSlot& slot, const Delivery& delivery);
    bool readsVisible(const FrameSlot& slot) const;
    void cull(const FrameView& view);

    const gpu::Device& m_device;
    const DrawnScene& m_drawn;
    FrameEquipment& m_equipment;
    platform::WorkerPool& m_workers;
    std::optional<MotionHistory> m_motion; ///< where motion is worked out
    visibility::VisibleCells m_visible;    ///< kept from frame to frame so that a warm one allocates nothing
};

} // namespace cdr::render
