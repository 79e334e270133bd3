#pragma once

#include <cdr/gpu/device_clock.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/platform/trace.h>
#include <cdr/render/frame/delivery.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/output/depth_output.h>
#include <cdr/render/output/motion_pass.h>
#include <cdr/render/shading/shading_pass.h>
#include <cdr/render/shadows/shadow_pass.h>
#include <cdr/render/submit/draw_path.h>
#include <cdr/render/targets/focus_layers.h>
#include <cdr/render/translucency/translucent_pass.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace cdr::render {

/// What the passes of one frame in flight read. Made anew as a whole, where a scene has more lights than there is room for.
struct SlotInputs {
    ShadingInputs shading;
    PassInputs resolve;                               ///< where a visibility buffer is drawn
    std::optional<TranslucentPass::Slot> translucent; ///< where the scene has blended materials
    std::optional<ShadowPass::Slot> shadows;          ///< where lights cast them
    FocusInputs focus;                                ///< where the lens has one
    std::optional<PassInputs> depthOutput;            ///< once a host asked for depth
    std::optional<MotionPass::Inputs> motion;         ///< where it is worked out
};

/// What one frame in flight owns, and what it was drawn from.
struct FrameSlot {
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
    bool isPending = false; ///< launched, and not waited for yet
    platform::Trace::Clock::time_point submitted;

    FrameView view;
    FrameStats stats;
    std::uint64_t revision = 0;    ///< of the scene
    std::optional<FrameCopy> copy; ///< Delivery::copy

    /// While a frame is on its way: what is given back if it is abandoned.
    struct Before {
        FrameView view;
        FrameStats stats;
        std::optional<FrameCopy> copy;
        depth::Cascades cut;           ///< the last frame's, as its split remembers them
        bool isMotionFollowed = false; ///< by the frame that is on its way
    };
    Before before;
};

/// Whether somebody reads the frame's G-buffer, beside shading.
inline bool isRead(const FrameSlot& slot, const Delivery& delivery) {
    const bool wantsDepth = delivery.host != nullptr && delivery.host->depth.has_value();
    return delivery.copy == FrameCopy::everything || wantsDepth || slot.inputs->motion;
}

} // namespace cdr::render
