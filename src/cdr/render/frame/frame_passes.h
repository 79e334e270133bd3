#pragma once

#include <cdr/render/frame/frame_slot.h>
#include <cdr/render/frame/scene_needs.h>
#include <cdr/render/frame_cutter.h>
#include <cdr/render/occluders/device_occlusion.h>
#include <cdr/render/occluders/occlusion_culling.h>
#include <cdr/render/output/frame_readback.h>
#include <cdr/render/shading/picture.h>
#include <cdr/render/submit/draw_path_factory.h>
#include <cdr/render/submit/one_of.h>

#include <cstddef>
#include <memory>
#include <variant>

namespace cdr::render {

/// Makes the G-buffer that a visibility buffer stands for, for those who read it back.
struct ResolvePass {
    gpu::Image gbuffer;
    FullscreenPass pass;
};

/// The images and passes of a picture of one size, and for what its scene needs.
struct FramePasses {
    /// Focus layers where the lens has a focus.
    using OwnedTargets = std::variant<std::unique_ptr<Targets>, std::unique_ptr<FocusLayers>>;

    /// All must outlive the passes, but options and needs. base::InputError and base::RunError as Renderer.
    FramePasses(const gpu::Device& device, const DrawnScene& drawn, const RenderOptions& options,
                const SceneNeeds& needs, const DrawPathFactory& paths, platform::WorkerPool& workers);

    /// The G-buffer; of a visibility buffer the one that frames for the host resolve.
    const gpu::Image& gbuffer() const {
        const ResolvePass* made = resolve.get();
        return made != nullptr ? made->gbuffer : targets.gbuffer();
    }
    /// What a frame draws into.
    Targets& drawnTargets() const { return litTargets != nullptr ? *litTargets : targets; }
    /// Those of one slot. @param lightRoom lights that they have room for.
    std::unique_ptr<SlotInputs> makeInputs(std::size_t lightRoom) const;
    /// The next frame is drawn as a first one.
    void forgetFrames();

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
};

} // namespace cdr::render
