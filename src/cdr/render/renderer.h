#pragma once

#include <cdr/base/export.h>
#include <cdr/render/frame.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/host_frame.h>
#include <cdr/render/render_options.h>
#include <cdr/render/surfaces.h>

#include <cstdint>
#include <memory>

/// The frame. Renderers, and what they draw, belong to one thread at a time; those of one device take turns.
/// @threads Functions keep nothing: many threads may call them at once.
namespace cdr::render {

class FrameRunner;

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
    /// @param gpuScene of `scene`, made on `device`
    /// @throws base::InputError for options that are out of range, do not go together or need more than the
    /// device has. Examples are no or too many pixels, and a depth format that the device lacks.
    /// @throws base::InputError for the GpuScene of another scene, or of a world, which changes, and for one that was made on
    ///         another device.
    /// @throws base::RunError when the device's memory or its limits do not suffice, with both figures where that is known before.
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
    /// But where the error comes after the frame was submitted, that frame is the last one: surfaces() and lastStats() describe
    /// it, though it may lack what found no room. Where it was waited for in vain, the next frame is rendered as a first one is:
    /// forgetFrames(). Where only the copy failed, it is a whole frame, and the next one goes on from it.
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
    /// frame whose lists had too little room (gpu-driven, or translucent surfaces sorted) signals nonetheless, and lacks what
    /// found none. finish() draws it again, whole, unless a later frame was begun or the scene changed.
    /// @errors base::InputError, base::RunError and std::system_error as render(), of an earlier frame too.
    void submit(const scene::Camera& camera, const FrameSync& sync = {});
    /// Records one frame into a host's command buffer and images. The host submits it to the device's queue, or calls
    /// dropRecorded(), before anything else is called that follows the scene: a frame, skip(), resize() or constructor of this or
    /// any other renderer of the device, or GpuScene::update(). Waits for the frame that was recorded `framesInFlight` calls before.
    ///
    /// A frame whose lists had too little room, as for submit(), lacks what found none. Each instance has room for a draw,
    /// and those that several cascades share may need more. The `framesInFlight`th frame after it has the room, since each
    /// frame in flight has lists of its own. Where lists of fragments may not grow, those after it are drawn weighted, until
    /// the scene or the size changes.
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
    /// Waits for all that was submitted or recorded. Where the last submitted frame lacks something (submit()), draws it again
    /// into the same images: what a host reads of them on other queues has to be done.
    /// @errors base::RunError and std::system_error of these frames, as render().
    void finish();
    /// Where the last frame is. From this function's first call on, frames wait for the host's reads of these images, in any
    /// pipeline stage. Call it before the frame that is to wait is submitted or recorded, and not at the same time.
    ///
    /// Where a world came to need other passes, as for a sky or the first material that blends, the next frame or skip() makes the
    /// images anew. It first waits for all that the device's queue was given; reads on other queues have to be done before.
    /// Until a frame is drawn after that, this names images that were never drawn, and lastStats() is empty: also where that
    /// frame is refused.
    /// @lifetime The images are valid until the next frame, skip(), resize(), or the renderer's end. The latter two do not wait for
    ///         the host's reads, so these have to be done by then.
    Surfaces surfaces() const;

    /// Statistics of the last frame, whichever call made it; empty before the first, and after resize() or once images were made
    /// anew for other passes (surfaces()). It does not wait. So until finish() FrameTimes::deviceMs is empty, and numbers that the
    /// device counts are 0: with gpu-driven submission the draws, with sorted translucency its fragments. FrameTimes::executeMs is
    /// 0 of frames that were submitted or recorded.
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
    const RenderOptions& options() const;

  private:
    std::unique_ptr<FrameRunner> m_frames;
};

} // namespace cdr::render
