#pragma once

#include <cdr/base/export.h>
#include <cdr/render/renderer.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cdr::render {

class FrameRunner;
class FrameSplit;
struct FrameSlot;
struct Delivery;

/// Renders one scene from several cameras at a time: the two eyes of a scene::StereoRig, the six scene::cubeSides().
///
/// The cameras have one lens. They share one walk over the scene's cells and one set of cascades, which fits what any of
/// them sees. Each has targets, lists of draws and memories of the last frame of its own. So the picture of each camera
/// is the one of a Renderer with the same cascades, to the bit.
/// @threads One thread at a time, as Renderer. Each view has a pool of RenderOptions::threads, which work in turn.
/// @errors None but those that a function names.
/// @lifetime The device and what is drawn must outlive it, and stay where they are.
class CDR_EXPORT ViewsRenderer {
  public:
    /// For a scene that does not change.
    /// @param views how many cameras look, 1 to kMaxViews
    /// @throws base::InputError for another number of views, or as Renderer, for a GpuScene on another device among them.
    /// @throws base::RunError, std::system_error as Renderer.
    ViewsRenderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
                  const RenderOptions& options, std::size_t views);
    /// For a world: all views of a frame show its state when the frame begins.
    /// @errors base::InputError, base::RunError and std::system_error as above.
    ViewsRenderer(const gpu::Device& device, GpuScene& live, const RenderOptions& options, std::size_t views);
    /// Waits for what is in flight.
    ~ViewsRenderer();
    ViewsRenderer(const ViewsRenderer&) = delete;
    ViewsRenderer& operator=(const ViewsRenderer&) = delete;

    /// Renders one frame of each camera, waits for all and copies them to main memory.
    /// @param cameras one for each view, with one lens
    /// @throws base::InputError for another number of cameras, for lenses that differ, or as Renderer::render().
    /// @throws base::RunError, std::system_error as Renderer::render(). Views whose draws were submitted before keep them.
    std::vector<Frame> render(std::span<const scene::Camera> cameras, FrameCopy copy = FrameCopy::everything);
    /// Renders one frame of each camera and waits for all, but leaves them on the device. FrameTimes::cullMs of
    /// the first is of all, their split included. executeMs begins when the view's draws are submitted, so it
    /// contains what other views draw meanwhile.
    /// @errors base::InputError, base::RunError and std::system_error as render().
    std::vector<FrameStats> draw(std::span<const scene::Camera> cameras);
    /// Renders one frame of each camera without waiting, as Renderer::submit().
    /// @param sync waited for before the first view and signalled after the last.
    /// @errors base::InputError, base::RunError and std::system_error as render(), of earlier frames too. Before one of the
    ///         latter two it waits for draws that it submitted, and so for FrameSync::waits.
    void submit(std::span<const scene::Camera> cameras, const FrameSync& sync = {});
    /// Records one frame of each camera into a host's command buffers and images, as Renderer::record(). Views may share
    /// a command buffer or have one each, which the host submits in the order of the views. What all frames occupy is
    /// covered by the cascades, which the views share.
    /// @param frames one for each view, each with images of its own
    /// @throws base::InputError for another number of cameras or frames, and for lenses that differ. The same for a frame
    /// that Renderer::record() refuses, and for two frames that share an image. Then nothing was recorded.
    /// @throws base::RunError, std::system_error as Renderer::record(): the commands of all views are then to be reset.
    void record(std::span<const scene::Camera> cameras, std::span<const HostFrame> frames);
    /// The host does not submit the frames that record() recorded last, as Renderer::dropRecorded(): of all views or none.
    /// @errors None.
    void dropRecorded();
    /// Waits for all that was submitted or recorded, as Renderer::finish().
    /// @errors base::RunError and std::system_error of these frames, as render().
    void finish();
    /// Goes past a frame without drawing it, as Renderer::skip().
    /// @errors base::InputError, base::RunError and std::system_error as render().
    void skip(std::span<const scene::Camera> cameras);
    /// The next frame is rendered as a first one is.
    void forgetFrames();
    /// Where the last frame of a view is.
    /// @param view below views()
    /// @lifetime As of Renderer::surfaces().
    Surfaces surfaces(std::size_t view) const;
    /// Statistics of the last frame of a view, as Renderer::lastStats().
    /// @param view below views()
    /// @errors None.
    FrameStats lastStats(std::size_t view) const;
    /// Makes pictures of another size, as Renderer::resize().
    /// @param width of each in pixels. @param height the same.
    /// @errors base::InputError, base::RunError and std::system_error as the constructor; all sizes are then as they were.
    ///         While it works, the device holds the images of both sizes of all views.
    void resize(std::uint32_t width, std::uint32_t height);

    /// How many cameras look.
    std::size_t views() const { return m_views.size(); }
    /// What it was made with; resize() changes the size.
    /// @lifetime As long as the renderer.
    const RenderOptions& options() const;

  private:
    using Cameras = std::span<const scene::Camera>;
    template <typename Make>
    ViewsRenderer(std::size_t views, const RenderOptions& options, const Make& make);
    struct Launch;
    /// Culls and cuts for all cameras.
    /// @param occupied view distances of what the scene does not hold
    depth::Cascades look(Cameras cameras, std::span<const depth::Interval> occupied);
    void launch(Cameras cameras, const Launch& how);
    /// The frames before were submitted, also where the next ones are refused.
    void keepRecorded();
    /// Of all views: some may have gone on to a frame that others refused, and refuse once more what moved apart in it.
    void forgetMotion();
    /// Decides the frames of all views, then submits or records them. @param isTogether the draws of all come first, so that
    /// none wait for another view's frame to be done; else one view comes after the other.
    void launchAll(Cameras cameras, std::span<Delivery> deliveries, bool isTogether);
    /// What comes first where they are together. @param begun frames that were decided, by view
    void launchDraws(std::span<FrameSlot* const> begun, std::span<Delivery> deliveries);
    /// For the last frame of a view. Where it throws, the next frame of all views is rendered as a first one is.
    const FrameSlot& waitFor(FrameRunner& view);
    /// Not where each view is timed alone, or has a host's command buffer of its own.
    bool mayBeTogether(const Launch& how) const;

    std::vector<std::unique_ptr<FrameRunner>> m_views;
    std::unique_ptr<FrameSplit> m_split;
};

/// Most views of a ViewsRenderer.
inline constexpr std::size_t kMaxViews = 32;

} // namespace cdr::render
