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

    scene::Camera camera;
    Lens lens;
    depth::Cascades cascades;
    depth::Cascades clipRanges;
    std::vector<CascadeDraws> draws; ///< by cascade
    FrameStats stats;
    Destination destination = Destination::device;

    std::vector<double> anchorsView() const {
        std::vector<double> anchors;
        for (const CascadeDraws& cascade : draws) {
            anchors.push_back(cascade.anchorView);
        }
        return anchors;
    }
};

} // namespace cdr::render
