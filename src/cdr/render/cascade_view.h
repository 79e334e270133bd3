#pragma once

#include <cdr/depth/mapping.h>
#include <cdr/render/focus.h>
#include <cdr/scene/frustum.h>
#include <cdr/shaders/shared.h>

#include <vulkan/vulkan.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cdr::render {

/// A part of the depth range [0, 1], for a viewport and for shaders that write depth.
struct DepthSlice {
    float min = 0.0f;
    float max = 1.0f;
};

/// One cascade of one frame as it is drawn.
struct CascadeView {
    depth::Cascade range;     ///< of the split: view distances that only this cascade holds
    depth::Cascade clipRange; ///< what it draws: `range` and its overlap with the next cascade
    depth::ClipTerms terms;   ///< how its view distances become clip z
    DepthSlice slice;         ///< where in the depth buffer it draws
    vk::Extent2D extent;      ///< of the image it is drawn into, pixels
};

/// What all cascades of a frame have in common.
struct CascadeViewOptions {
    depth::Mapping mapping = depth::Mapping::standard;
    depth::FarEnd farEnd = depth::FarEnd::open; ///< of the last cascade
    vk::Extent2D extent;                        ///< of the picture, pixels
    /// Draws what is out of focus into smaller images.
    std::optional<FocusLens> lens;
    bool overlaps = false; ///< with a lens: cascades that touch overlap, so that they can fade
};

/// Nearest first, as the split has them. Each draws in the whole depth range.
std::vector<CascadeView> makeCascadeViews(const depth::Cascades& split, const CascadeViewOptions& options);

/// By cascade.
depth::Cascades rangesOf(std::span<const CascadeView> views);
depth::Cascades clipRangesOf(std::span<const CascadeView> views);
/// View distance of each cascade's anchor plane, 0 where the mapping is not anchored.
std::vector<double> anchorsOf(std::span<const CascadeView> views);

/// The last form of a view: what its shaders read. Never read back.
shaders::CascadePush makeCascadePush(const CascadeView& view, const scene::Frustum& frustum,
                                     std::size_t cascade);

} // namespace cdr::render
