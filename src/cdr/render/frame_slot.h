#pragma once

#include <cdr/gpu/device_clock.h>
#include <cdr/render/frame_cutter.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/occluders/device_occlusion.h>
#include <cdr/render/occluders/occlusion_culling.h>
#include <cdr/render/output/depth_output.h>
#include <cdr/render/output/frame_readback.h>
#include <cdr/render/output/motion_pass.h>
#include <cdr/render/renderer.h>
#include <cdr/render/shading/picture.h>
#include <cdr/render/shading/resolve_pass.h>
#include <cdr/render/shading/shading_pass.h>
#include <cdr/render/shadows/shadow_pass.h>
#include <cdr/render/submit/draw_path_factory.h>
#include <cdr/render/submit/one_of.h>
#include <cdr/render/targets/focus_layers.h>
#include <cdr/render/translucency/translucent_pass.h>

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace cdr::render {

/// What the passes of one frame in flight read. Made anew as a whole, where a scene has more lights than there is room for.
struct Renderer::SlotInputs {
    ShadingInputs shading;
    PassInputs resolve;                               ///< where a visibility buffer is drawn
    std::optional<TranslucentPass::Slot> translucent; ///< where the scene has blended materials
    std::optional<ShadowPass::Slot> shadows;          ///< where lights cast them
    FocusInputs focus;                                ///< where the lens has one
    std::optional<DepthOutput::Inputs> depthOutput;   ///< once a host asked for depth
    std::optional<MotionPass::Inputs> motion;         ///< where it is worked out
};

/// What one frame in flight owns, and what it was drawn from.
struct Renderer::Slot {
    std::unique_ptr<DrawPath> path;
    /// Where surfaces are lit while they are drawn: draws them once more, into a visibility buffer, for whoever reads that.
    std::unique_ptr<DrawPath> readPath;
    HostCommands host{};                       ///< of the frame that is being recorded
    std::vector<vk::CommandBuffer> commands{}; ///< that the frame submits; none that a host does
    std::unique_ptr<SlotInputs> inputs; ///< always there; some of them refer to others by their address
    vk::UniqueFence done;
    std::optional<gpu::DeviceClock> clock; ///< where frames are timed by it
    /// A host's timeline semaphore and the value that says that the frame is done, in place of `done`.
    struct Recorded {
        vk::Semaphore timeline;
        std::uint64_t value = 0;
    };
    std::optional<Recorded> recorded;
    bool isPending = false;
    host::Trace::Clock::time_point submitted;

    FrameView view;
    FrameStats stats;
    std::uint64_t revision = 0; ///< of the scene
    Destination destination = Destination::device;

    /// While a frame is on its way: what abandon() gives back.
    struct Before {
        FrameView view;
        FrameStats stats;
        Destination destination = Destination::device;
        depth::Cascades cut;           ///< the last frame's, as its split remembers them
        bool isMotionFollowed = false; ///< by the frame that is on its way
    };
    Before before;
};

/// Where a frame goes.
struct Renderer::Delivery {
    Destination destination = Destination::device;
    FrameSync sync{};
    const HostFrame* host = nullptr; ///< into which it is recorded; null: it is submitted
    /// Of a view among others, for which `m_visible` is filled already; null: the frame is culled and cut alone.
    const depth::Cascades* shared = nullptr;
    bool isAwaited = false;         ///< before anybody sees it, so that it can be drawn again
    bool areDrawsSubmitted = false; ///< by submitDraws(), ahead of the rest
};

/// What a renderer draws with, for a picture of one size and for what its scene needs.
struct Renderer::Passes {
    /// Focus layers where the lens has a focus.
    using OwnedTargets = std::variant<std::unique_ptr<Targets>, std::unique_ptr<FocusLayers>>;

    Passes(const gpu::Device& device, const DrawnScene& drawn, const RenderOptions& options,
           const Needs& needs);
    /// The G-buffer; of a visibility buffer the one that frames for the host resolve.
    const gpu::Image& gbuffer() const { return resolve != nullptr ? resolve->gbuffer() : targets.gbuffer(); }

    vk::Extent2D extent;
    std::unique_ptr<Targets>
        litTargets; ///< whose G-buffer is the picture; null unless surfaces are lit while drawn
    Picture picture;
    OwnedTargets ownTargets;
    Targets& targets; ///< those
    FrameCutter cutter;
    std::unique_ptr<ShadowPass> shadows; ///< where lights cast them
    ShadingPass shading;
    std::unique_ptr<ResolvePass> resolve;         ///< of a visibility buffer
    std::unique_ptr<TranslucentPass> translucent; ///< where the scene has blended materials
    std::unique_ptr<MotionPass> motion;           ///< where it is worked out
    /// Where the CPU, or the device, leaves out what is hidden.
    OneOf<OcclusionCulling, DeviceOcclusion> occlusion{};
    std::unique_ptr<DepthOutput> depthOutput{}; ///< once a host asked for depth
    FrameReadback readback;
    std::size_t lightRoom = 0; ///< of each slot's inputs
    std::vector<Slot> slots{}; ///< taken in turn
};

} // namespace cdr::render
