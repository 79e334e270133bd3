#pragma once

#include <cdr/host/worker_pool.h>
#include <cdr/render/frame.h>
#include <cdr/render/frame_cutter.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/readback.h>
#include <cdr/render/render_options.h>
#include <cdr/render/shading/picture.h>
#include <cdr/render/shading/shading_pass.h>
#include <cdr/render/submit/draw_path_factory.h>
#include <cdr/render/targets/targets.h>
#include <cdr/render/translucency/translucent_pass.h>
#include <cdr/visibility/cull.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cdr::render {

class FocusLayers;

/// What Renderer::render() copies to the host: the picture, or the G-buffer too, which is four times as
/// large.
enum class FrameCopy : std::uint8_t { color, everything };

/// Renders a scene with one technique into one kind of targets, frame by frame.
///
/// Data flows one way: camera -> cull -> split -> bin -> record on workers -> execute -> shade -> translucent
/// surfaces -> Frame.
class Renderer {
  public:
    /// The device, the scene and its GpuScene must outlive the renderer.
    /// base::InputError for a picture of no or too many pixels, a depth format the device lacks, a
    /// submission it cannot do, or an unusable detail; base::RunError when its memory does not suffice, with
    /// both figures.
    Renderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
             const RenderOptions& options);
    /// Waits for what is in flight.
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Renders one frame, waits for it and copies it to the host; Frame::gbuffer stays empty unless asked
    /// for. base::InputError for an unusable camera or split.
    Frame render(const scene::Camera& camera, FrameCopy copy = FrameCopy::everything);

    /// The next frame is rendered as a first one is: a fitted split does not keep to the last frame's.
    void forgetFrames() { m_cutter.forget(); }

    /// Renders one frame and waits for it, but leaves it on the device: what experiments time.
    FrameStats draw(const scene::Camera& camera);

    /// Renders one frame without waiting for it: the CPU is at most `framesInFlight` ahead of the device.
    /// Errors of an earlier frame may come up here.
    void submit(const scene::Camera& camera);
    /// Waits for all that was submitted.
    void finish();

    const RenderOptions& options() const { return m_options; }

  private:
    struct Slot;
    /// Focus layers where the lens has a focus.
    using OwnedTargets = std::variant<std::unique_ptr<Targets>, std::unique_ptr<FocusLayers>>;
    enum class Destination { device, hostColor, host };
    OwnedTargets makeOwnTargets() const;
    Slot& nextSlot();
    /// Lists what is drawn into the G-buffer: all that is seen but blended instances.
    void cull(const FrameView& view);
    void shade(Slot& slot);
    bool hasRoomSufficed(Slot& slot);
    void launch(Slot& slot, Destination destination);
    void settle(Slot& slot);
    void waitFor(Slot& slot);
    Slot& run(const scene::Camera& camera, Destination destination);
    void recordReadback(vk::CommandBuffer primary, Destination destination) const;
    Frame fetch(const Slot& slot) const;

    const gpu::Device& m_device;
    std::vector<std::uint32_t> m_blended; ///< instances, ascending
    DrawnScene m_drawn;
    RenderOptions m_options;
    vk::Extent2D m_extent;
    host::WorkerPool m_workers;
    bool m_lostShine; ///< FrameStats::lostShine of every frame
    bool m_shiny;     ///< whether the G-buffer keeps how surfaces shine
    DrawPathFactory m_paths;
    Picture m_picture;
    OwnedTargets m_ownTargets;
    Targets& m_targets; ///< those
    FrameCutter m_cutter;
    ShadingPass m_shading;
    std::unique_ptr<TranslucentPass> m_translucent; ///< where the scene has blended instances
    Readback m_colorCopy;
    Readback m_gbufferCopy;
    visibility::VisibleList m_visible; ///< kept from frame to frame so that a warm one allocates nothing
    std::vector<Slot> m_slots;         ///< taken in turn
    std::size_t m_frames = 0;          ///< begun so far
};

} // namespace cdr::render
