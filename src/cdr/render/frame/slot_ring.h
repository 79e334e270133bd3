#pragma once

#include <cdr/render/frame/frame_passes.h>

#include <cstddef>
#include <span>
#include <vector>

namespace cdr::render {

/// The slots of frames in flight, taken in turn: which frame has which, what was submitted and what is done.
class SlotRing {
  public:
    /// All must outlive the ring, but options.
    SlotRing(const gpu::Device& device, const RenderOptions& options, const DrawPathFactory& paths,
             const FramePasses& passes, platform::WorkerPool& workers, std::size_t lightRoom);

    /// That the next frame takes.
    FrameSlot& next() { return slotOf(m_frames); }
    /// Of the last frame that was committed; null before the first.
    FrameSlot* last() { return m_frames > 0 ? &slotOf(m_frames - 1) : nullptr; }
    /// Of the last frame; empty before the first.
    FrameStats lastStats() { return m_frames > 0 ? slotOf(m_frames - 1).stats : FrameStats(); }
    /// Those of the frames that were committed last, the oldest first.
    std::vector<FrameSlot*> inOrder();

    /// Lights that each slot's inputs have room for.
    std::size_t lightRoom() const { return m_lightRoom; }
    /// Makes the inputs of all slots anew, but for lists of fragments. Nothing may be in flight. Where this throws, all is as it was.
    void giveLightRoom(const FramePasses& passes, std::size_t room);

    /// Submits a slot's commands so far ahead of the rest of its frame, and without a fence.
    void submitDraws(FrameSlot& slot, std::span<const VkSemaphoreSubmitInfo> waits) const;
    /// Submits a slot's commands, unless a host will.
    void submit(FrameSlot& slot, const Delivery& delivery);
    /// Until the device has run what the slot submitted, which was pending.
    void wait(FrameSlot& slot) const;
    /// Its frame was submitted and is the last one now.
    void commit(FrameSlot& slot);

    /// A host has submitted the last frame, or will: drop() does nothing.
    void keepRecorded() { m_mayDrop = false; }
    /// Waits no more for the last frame, which a host recorded and does not submit. Returns its slot; null where the last
    /// frame was not recorded.
    FrameSlot* drop();

  private:
    FrameSlot& slotOf(std::size_t frame) { return m_slots[frame % m_slots.size()]; }

    const gpu::Device& m_device;
    std::size_t m_lightRoom;
    std::vector<FrameSlot> m_slots;
    std::size_t m_frames = 0; ///< committed so far, counted from 0
    bool m_mayDrop = false;   ///< the last frame was recorded for a host
};

} // namespace cdr::render
