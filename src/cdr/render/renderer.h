#pragma once

#include <cdr/depth/technique.h>
#include <cdr/host/worker_pool.h>
#include <cdr/render/effects.h>
#include <cdr/render/focus.h>
#include <cdr/render/frame.h>
#include <cdr/render/frame_split.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/render/readback.h>
#include <cdr/render/shading/picture.h>
#include <cdr/render/shading/shading_pass.h>
#include <cdr/render/submit/draw_path.h>
#include <cdr/render/targets/targets.h>
#include <cdr/render/translucency/translucent_pass.h>
#include <cdr/visibility/cull.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cdr::render {

class BinningPass;
class FocusLayers;

struct RenderOptions {
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    depth::Technique technique;
    TargetsChoice targets = TargetsKind::single;
    std::size_t threads = 1;                           ///< that cull, bin and record, the caller's included
    host::Placement placement = host::Placement::free; ///< of those threads but the caller's
    Submission submission = Submission::secondaries;
    Batching batching = Batching::instanced;
    visibility::Detail
        detail{}; ///< none unless told; meshes without levels are drawn in full whatever it says
    Effects effects{};
    Focus focus{}; ///< on, it needs targets `layers`, and effects without occlusion
    TranslucencyOptions translucency{};
    std::size_t framesInFlight = 1; ///< that submit() lets the device lag behind, 1 to kMaxFramesInFlight
    /// Receives every frame's stages and jobs; must have `threads` tracks and outlive the renderer. Null for
    /// none.
    host::Trace* trace = nullptr;
};

inline constexpr std::size_t kMaxFramesInFlight = 8;

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
    void forgetFrames() { m_split.forget(); }

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
    enum class Destination { device, hostColor, host };
    std::unique_ptr<FocusLayers> makeFocusLayers() const;
    std::unique_ptr<DrawPath> makePath(const std::string& name);
    Slot& nextSlot();
    /// What is drawn into the G-buffer: all but blended instances.
    const scene::Instances& opaque() const { return m_opaque ? *m_opaque : m_scene.instances; }
    void cull(const scene::Camera& camera);
    void cut(const scene::Camera& camera, Slot& slot);
    void shade(Slot& slot);
    bool hasRoomSufficed(Slot& slot);
    void launch(Slot& slot, Destination destination);
    void settle(Slot& slot);
    void waitFor(Slot& slot);
    Slot& run(const scene::Camera& camera, Destination destination);
    void recordReadback(vk::CommandBuffer primary, Destination destination) const;
    Frame fetch(const Slot& slot) const;

    const gpu::Device& m_device;
    const scene::Scene& m_scene;
    std::optional<scene::Instances> m_opaque; ///< where the scene has blended instances
    RenderOptions m_options;
    vk::Extent2D m_extent;
    double m_aspect;
    FrameSplit m_split;
    host::WorkerPool m_workers;
    std::string m_note; ///< FrameStats::note of every frame
    bool m_shiny;       ///< whether the G-buffer keeps how surfaces shine
    GeometryPass m_geometry;
    std::unique_ptr<BinningPass> m_binning; ///< for Submission::gpuDriven
    Picture m_picture;
    std::unique_ptr<FocusLayers> m_focus; ///< where the lens has a focus
    std::unique_ptr<Targets> m_plain;     ///< where it has none
    Targets& m_targets;                   ///< the one of both that is there
    ShadingPass m_shading;
    std::unique_ptr<TranslucentPass> m_translucent; ///< where the scene has blended instances
    Readback m_colorCopy;
    Readback m_gbufferCopy;
    visibility::VisibleList m_visible; ///< kept from frame to frame so that a warm one allocates nothing
    std::vector<Slot> m_slots;         ///< taken in turn
    std::size_t m_frames = 0;          ///< begun so far
};

} // namespace cdr::render
