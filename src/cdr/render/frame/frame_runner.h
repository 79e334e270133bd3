#pragma once

#include <cdr/platform/worker_pool.h>
#include <cdr/render/frame/frame_decider.h>
#include <cdr/render/frame/frame_equipment.h>
#include <cdr/render/frame/frame_recorder.h>
#include <cdr/render/frame/scene_follower.h>

#include <cstdint>
#include <utility>

namespace cdr::render {

/// Takes frames through their states: decided, recorded, submitted, and committed or abandoned; then settled. README.md of
/// this folder draws them. run() does all but the last; whoever draws several views at a time goes through the steps.
class FrameRunner {
  public:
    /// The device and the scene must outlive it. base::InputError, base::RunError and std::system_error as Renderer.
    FrameRunner(const gpu::Device& device, const SceneFollower& scene, const RenderOptions& options);
    /// Waits for what is in flight.
    ~FrameRunner();
    FrameRunner(const FrameRunner&) = delete;
    FrameRunner& operator=(const FrameRunner&) = delete;

    /// Decides, records, submits and commits a frame. Where it throws, the frame was abandoned.
    FrameSlot& run(const scene::Camera& camera, const Delivery& delivery);
    /// Goes past a frame without drawing it.
    void skip(const scene::Camera& camera);
    /// base::InputError unless a frame can be recorded into what a host hands in.
    void requireRecordable(const HostFrame& frame);
    void dropRecorded();
    /// For pictures of another size, made once what is in flight is done. Where this throws, the size is as it was.
    FrameEquipment::Made resized(std::uint32_t width, std::uint32_t height);
    /// Goes on with what resized() made. Throws nothing.
    void take(FrameEquipment::Made made) { m_equipment.take(std::move(made)); }
    /// From now on frames wait for the host's reads of the images.
    void nameSurfaces() { m_reads = HostReads::anyStage; }

    // The steps of a frame, in this order.

    /// Takes over what changed in the scene.
    void followScene();
    /// The first step: decides what a frame shows and draws, once its slot is free. commit() or abandon() ends the frame;
    /// where this throws, it was abandoned.
    FrameSlot& prepare(const scene::Camera& camera, const Delivery& delivery);
    /// All steps from here up to commit(): records a frame and submits it.
    void launch(FrameSlot& slot, const Delivery& delivery);
    /// Lists a frame's draws and begins its commands. @param watch that times the frame up to its submission.
    void begin(FrameSlot& slot, const Delivery& delivery, platform::StageWatch& watch);
    /// @param primary of this frame, or of another that is submitted before.
    void beginTargets(VkCommandBuffer primary) { recorder().beginTargets(primary, m_reads); }
    void recordDraws(FrameSlot& slot) { recorder().recordDraws(slot); }
    /// Submits what was recorded so far ahead of the rest, and without a fence.
    void submitDraws(FrameSlot& slot, std::span<const VkSemaphoreSubmitInfo> waits,
                     platform::StageWatch& watch);
    /// Records all that follows the draws, and submits it.
    void finishFrame(FrameSlot& slot, const Delivery& delivery, platform::StageWatch& watch);
    /// It was submitted and is the last frame now.
    void commit(FrameSlot& slot) { m_equipment.slots().commit(slot); }
    /// An error ended it: the frame before stays the last one.
    void abandon(FrameSlot& slot) { m_decider.takeBack(slot); }

    /// Waits for the frame of a slot, and gives its lists the room that they lacked. False where they lacked some, and true
    /// where none is in flight. It draws nothing: a host may still read the images, and only the next frame waits for that.
    bool settle(FrameSlot& slot);
    /// Settles it. Draws it again where its lists had no room and nothing came after it.
    void complete(FrameSlot& slot);
    /// The same, and notes when it was done. Where it throws, the next frame is decided as a first one.
    void waitFor(FrameSlot& slot);
    /// Completes all frames, in the order in which they were submitted: those after one that fails too, so that nothing is in
    /// flight then. Throws the first error.
    void finish();

    // What it is made of.

    const gpu::Device& device() const { return m_device; }
    const DrawnScene& drawn() const { return m_scene.drawn(); }
    platform::WorkerPool& workers() { return m_workers; }
    const RenderOptions& options() const { return m_equipment.options(); }
    FramePasses& passes() const { return m_equipment.passes(); }
    SlotRing& slots() const { return m_equipment.slots(); }
    FrameDecider& decider() { return m_decider; }

  private:
    FrameRecorder recorder() const { return {m_device, drawn(), options(), passes()}; }
    bool hasRoomSufficed(FrameSlot& slot) const;
    /// As finish(), but settles: what follows replaces the images of the last frame, or what they were drawn from.
    void settleAll();

    const gpu::Device& m_device;
    SceneFollower m_scene;
    platform::WorkerPool m_workers;
    FrameEquipment m_equipment;
    FrameDecider m_decider;
    HostReads m_reads = HostReads::none;
};

} // namespace cdr::render
