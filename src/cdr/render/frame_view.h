#pragma once

#include <cdr/depth/cascade_constants.h>
#include <cdr/depth/mapping.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/frustum.h>
#include <cdr/shaders/shared.h>
#include <cdr/visibility/level_choice.h>

#include <cstddef>
#include <vector>

namespace cdr::render {

/// A part of the depth range, [0, 1], for a viewport and for shaders that set their depth.
struct DepthSlice {
    float min = 0.0f;
    float max = 1.0f;

    bool operator==(const DepthSlice&) const = default;
};

/// One cascade of a frame, in float64. What the device reads is made from it when commands are recorded.
struct CascadeView {
    depth::Cascade range;     ///< as the split cut it
    depth::Cascade clipRange; ///< what is binned and clipped against: `range`, and what neighbours share
    depth::ClipTerms terms;   ///< view distance to depth; its anchorView is 0 unless the mapping is anchored
    DepthSlice slice{};       ///< of the depth buffer
    vk::Extent2D extent;      ///< of what the cascade is drawn into
};

/// Of cascades that each have all of the depth range and of the picture.
/// @param drawn what each draws of the view: `ranges`, or more where cascades overlap.
/// @param farEnd of the last one.
std::vector<CascadeView> cascadeViews(depth::Mapping mapping, const depth::Cascades& ranges,
                                      const depth::Cascades& drawn, depth::FarEnd farEnd,
                                      vk::Extent2D extent);

/// One frame as the CPU sees it: who looks, through what, and the cascades that the view is cut into.
struct FrameView {
    scene::Camera camera;
    scene::Frustum frustum;              ///< of the camera and the picture
    visibility::LevelRule levels;        ///< at which level of detail each draw is drawn
    std::vector<CascadeView> cascades{}; ///< nearest first
    platform::IndexRange drawn{};        ///< cascades that this renderer draws
    /// What the colour attachment is cleared to: the background where surfaces are lit while they are drawn, else 0.
    glm::vec4 clearColor{0.0f};

    depth::Cascades ranges() const;
    depth::Cascades clipRanges() const;
    std::vector<double> anchorsView() const;
};

/// What clip x and y have less because the lens is shifted, in units of clip w; y points down.
glm::vec2 clipLensShift(const scene::Frustum& frustum);

/// What a vertex shader needs of a cascade.
depth::CascadeConstants makeCascadeConstants(const FrameView& view, std::size_t cascade);
/// What every draw of a cascade is pushed.
shaders::CascadePush makeCascadePush(const FrameView& view, std::size_t cascade);

} // namespace cdr::render
