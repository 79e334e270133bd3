#pragma once

#include <cdr/base/export.h>
#include <cdr/host/worker_pool.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/frame.h>
#include <cdr/render/host_frame.h>
#include <cdr/render/render_options.h>
#include <cdr/render/surfaces.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace cdr::host {
class StageWatch;
} // namespace cdr::host

namespace cdr::visibility {
struct VisibleCells;
}

/// The frame. Renderers, and what they draw, belong to one thread at a time; those of one device take turns.
/// @threads Functions keep nothing: many threads may call them at once.
namespace cdr::render {

class DrawPathFactory;
class MotionHistory;
class Targets;
struct FrameView;

/// Renders a scene with one technique into one kind of targets, frame by frame.
///
/// Data flows one way: camera -> cull -> split -> bin -> record on workers -> execute -> shade -> translucent
/// surfaces -> Frame.
/// @threads One thread at a time. Those of one device take turns, since they share its queue.
/// @errors None but those that a function names.
/// @lifetime The device and what is drawn must outlive the renderer, and stay where they are.
class CDR_EXPORT Renderer {
  public:
    /// For a scene that does not change.
    /// @param gpuScene of `scene`
    /// @throws base::InputError for options that are out of range, do not go together or need more than the
    /// device has. Examples are no or too many pixels, and a depth format that the device lacks.
    /// @throws base::InputError for the GpuScene of another scene, or of a world, which changes.
    /// @throws base::RunError with both figures when the device's memory or its limits do not suffice.
    /// @throws std::system_error for Vulkan's other errors, and when the system starts no more threads.
    Renderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
             const RenderOptions& options);
    /// For a world: each frame shows its state when the frame begins.
    /// @errors base::InputError, base::RunError and std::system_error as above.
    Renderer(const gpu::Device& device, GpuScene& live, const RenderOptions& options);
    /// Waits for what is in flight, a recorded frame that the host has not submitted yet among them: dropRecorded().
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Renders one frame, waits for it and copies it to main memory; Frame::gbuffer stays empty unless asked for. After an
    /// error the last frame is still the one before. Motion of the next frame is measured from that one, or there is none.
    /// @throws base::InputError for an unusable camera or split, and with RenderOptions::motion where instances of one
    /// object moved apart since the last frame. Also with a visibility buffer while a world holds what that cannot show;
    /// frames are drawn again once it is removed. Also for what GpuScene::update() refuses.
    /// @throws base::RunError when what the frame draws has no room on the device.
    /// @throws std::system_error for Vulkan's other errors, a lost device among them.
    Frame render(const scene::Camera& camera, FrameCopy copy = FrameCopy::everything);

    /// Goes past a frame without drawing it: the next one is the same as if this one had been rendered. It costs culling
    /// where a fitted split keeps to the frame before, and next to nothing where no frame depends on another.
    /// @errors base::InputError, base::RunError and std::system_error as render().
    void skip(const scene::Camera& camera);

    /// The next frame is rendered as a first one is: a fitted split does not keep to the last frame's, and nothing moved.
    void forgetFrames();

    /// Renders one frame and waits for it, but leaves it on the device: what experiments time.
    /// @errors base::InputError, base::RunError and std::system_error as render().
    FrameStats draw(const scene::Camera& camera);

    /// Renders one frame without waiting for it: the CPU is at most `framesInFlight` ahead of the device. A
    /// frame whose lists had too little room (gpu-driven, or translucent surfaces sorted) signals nonetheless.
    /// Once that is seen, the whole frame is drawn again, unless a later frame was submitted.
    /// @errors base::InputError, base::RunError and std::system_error as render(), of an earlier frame too.
    void submit(const scene::Camera& camera, const FrameSync& sync = {});
    /// Records one frame into a host's command buffer and images. The host submits it to the device's queue,
    /// before this or any other renderer of the device begins its next frame, or calls dropRecorded(). Waits for the frame
    /// that was recorded `framesInFlight` calls before.
    ///
    /// A frame whose lists had too little room, as for submit(), lacks what found none; the next one has the room. Where
    /// lists of fragments may not grow, those after it are drawn weighted, until the scene or the size changes.
    /// @throws base::InputError as render(), for what cannot be recorded into, and with Submission::primaries, which
    ///         needs command buffers of its own; then nothing was recorded.
    /// @throws base::RunError as render(). After this or any other error, one of HostFrame::draw's too, the host's
    ///         commands are to be reset.
    /// @throws std::system_error as render().
    void record(const scene::Camera& camera, const HostFrame& frame);
    /// The host does not submit the frame that record() recorded last: its commands are reset. Nothing waits for that frame
    /// then, and the next one shows all edits. The effect is that of skip(), but surfaces() describes that frame until there
    /// is another. Call it before anything else of this renderer, its destructor too. Does nothing where the last frame was
    /// not recorded, or record() threw.
    /// @errors None.
    void dropRecorded();
    /// Waits for all that was submitted or recorded.
    /// @errors base::RunError and std::system_error of these frames, as render().
    void finish();
    /// Where the last frame is. From this function's first call on, frames wait for the host's reads of these images, in any
    /// pipeline stage. Call it before the frame that is to wait is submitted or recorded, and not at the same time.
    /// @lifetime The images are valid until the next frame, or resize().
    Surfaces surfaces() const;

    /// Statistics of the last frame, whichever call made it; empty before the first, and after resize(). It does not wait. So
    /// until finish() FrameTimes::deviceMs is empty, and numbers that the device counts are 0: with gpu-driven submission the
    /// draws, with sorted translucency its fragments. FrameTimes::executeMs is 0 of frames that were submitted or recorded.
    /// @errors None.
    FrameStats lastStats() const;

    /// Makes pictures of another size. Pipelines stay, unless vertices are snapped. Waits for what is in
    /// flight.
    /// @param width in pixels
    /// @param height in pixels
    /// @errors base::InputError, base::RunError and std::system_error as the constructor; the size is then as it was.
    void resize(std::uint32_t width, std::uint32_t height);

    /// What it was made with; resize() changes the size.
    /// @lifetime As long as the renderer.
    const RenderOptions& options() const { return m_options; }

  private:
    friend class ViewsRenderer; // culls and cuts for several at once
    struct Slot;
    struct SlotInputs;
    struct Passes;
    struct Delivery;
    /// What of the scene decides which passes and pipelines there are.
    struct Needs {
        bool metallicRoughness = false;
        bool blended = false;
        bool emission = false;
        bool sky = false;
        bool air = false;
        glm::vec3 focusBackground{0.0f}; ///< that layers of a lens with a focus are cleared to; 0 of others

        SceneTraits traits() const { return {.blended = blended}; }
        bool operator==(const Needs&) const = default;
    };
    enum class Destination { device, hostColor, host };
    Renderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene, GpuScene* live,
             const RenderOptions& options);
    /// What facets were made from.
    struct FacetsMadeFrom {
        std::uint64_t meshesRevision = 0;
        std::size_t kinds = 0;

        bool operator==(const FacetsMadeFrom&) const = default;
    };
    Needs needs() const;
    void makePasses();
    /// For what the scene needs, or for a picture of another size. Nothing may be in flight.
    void remake(const Needs& needs, const RenderOptions& options);
    /// Those of one slot.
    std::unique_ptr<SlotInputs> makeInputs(std::size_t lightRoom) const;
    /// Takes over what changed in the scene.
    void followScene();
    /// base::InputError unless record() can record into a frame.
    void requireRecordable(const HostFrame& frame);
    /// Makes the facets anew if meshes, materials or kinds changed.
    void followFacets();
    /// @param frame counted from 0, since the passes were made
    Slot& slotOf(std::size_t frame) const;
    /// Lists what is drawn into the G-buffer: all that is seen but blended instances.
    void cull(const FrameView& view);
    /// Whether a frame of the slot reads that list.
    bool readsVisible(const Slot& slot) const;
    void shade(Slot& slot);
    /// Whether somebody reads the frame's G-buffer, beside shading.
    static bool isRead(const Slot& slot, const Delivery& delivery);
    /// Where surfaces are lit while they are drawn: draws a visibility buffer for whoever reads the frame's surfaces.
    void recordReadSurfaces(Slot& slot, const HostFrame* host);
    /// Resolves the G-buffer of a visibility buffer where somebody reads it, and works out motion.
    void recordSurfaces(Slot& slot, const Delivery& delivery);
    bool hasRoomSufficed(Slot& slot);
    /// Records a frame and submits it.
    void launch(Slot& slot, const Delivery& delivery);
    /// What the frame draws into.
    Targets& drawnTargets() const;
    /// Makes them attachments, once a host that knows the frame's images has read the last one's.
    void beginTargets(VkCommandBuffer primary);
    /// Lists a frame's draws and begins its commands. @param watch that times the frame up to its submission.
    void beginFrame(Slot& slot, const Delivery& delivery, host::StageWatch& watch);
    /// Records the cascades into drawnTargets(), which somebody began.
    void recordDraws(Slot& slot);
    /// Submits what was recorded so far ahead of the rest, and without a fence.
    void submitDraws(Slot& slot, std::span<const VkSemaphoreSubmitInfo> waits, host::StageWatch& watch);
    /// Records all that follows the draws, and submits it.
    void finishFrame(Slot& slot, const Delivery& delivery, host::StageWatch& watch);
    void recordOutputs(Slot& slot, const HostFrame& host);
    void settle(Slot& slot);
    void waitFor(Slot& slot);
    /// Decides what a frame shows and draws, up to beginFrame(). commit() or abandon() ends the frame; where this throws, it
    /// was abandoned.
    Slot& prepare(const scene::Camera& camera, const Delivery& delivery);
    void decide(Slot& slot, const scene::Camera& camera, const Delivery& delivery);
    /// It was launched and is the last frame now.
    void commit(Slot& slot);
    /// An error ended it: the frame before stays the last one.
    void abandon(Slot& slot);
    Slot& run(const scene::Camera& camera, const Delivery& delivery);
    static FrameCopy copyOf(Destination destination) {
        return destination == Destination::host ? FrameCopy::everything : FrameCopy::color;
    }
    void recordReadback(VkCommandBuffer commands, Destination destination) const;
    Frame fetch(const Slot& slot) const;

    const gpu::Device& m_device;
    GpuScene* m_live; ///< null for a scene that stays as it is
    DrawnScene m_drawn;
    RenderOptions m_options;
    host::WorkerPool m_workers;
    Needs m_needs;
    std::uint64_t m_revision = 0;            ///< of the scene, as the passes know it
    mutable bool m_areSurfacesNamed = false; ///< by surfaces(), so a host may read them in any stage
    FacetsMadeFrom m_facetsMadeFrom;
    std::unique_ptr<DrawPathFactory> m_paths;
    std::unique_ptr<Passes> m_passes;
    std::unique_ptr<MotionHistory> m_motion; ///< where motion is worked out
    std::unique_ptr<visibility::VisibleCells>
        m_visible;            ///< kept from frame to frame so that a warm one allocates nothing
    bool m_mayDrop = false;   ///< the last frame was recorded for a host
    std::size_t m_frames = 0; ///< launched so far with these passes
};

} // namespace cdr::render
