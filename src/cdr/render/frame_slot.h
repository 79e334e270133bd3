#pragma once

#include <cdr/render/renderer.h>
#include <cdr/render/targets/focus_layers.h>

namespace cdr::render {

/// What one frame in flight owns, and what it was drawn from.
struct Renderer::Slot {
    std::unique_ptr<DrawPath> path;
    ShadingInputs shading;
    std::optional<TranslucentPass::Slot> translucent; ///< where the scene has blended instances
    FocusInputs focus;                                ///< where the lens has one
    vk::UniqueFence done;
    bool isPending = false;
    host::Trace::Clock::time_point submitted;

    FrameView view;
    FrameStats stats;
    Destination destination = Destination::device;
};

} // namespace cdr::render
