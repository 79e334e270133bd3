#pragma once

#include <cdr/depth/cascade_constants.h>
#include <cdr/depth/occupancy.h>
#include <cdr/render/surfaces.h>

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace cdr::render {

/// A depth image of the host's, which a frame fills with the depth that the host's own camera has of what cdr drew.
struct HostDepth {
    /// VK_FORMAT_D32_SFLOAT, made for VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, with a view. What it held is lost.
    SurfaceImage image{};
    /// Mapping::reversed or Mapping::standard: the host's depth range and compare. Background gets what it clears to.
    depth::Mapping mapping = depth::Mapping::reversed;
    double nearView = 0.1;           ///< of the host's projection, above 0
    std::optional<double> farView{}; ///< empty for reversed: infinity
};

/// One cascade while it is drawn, for the host to draw its own objects into.
struct HostCascade {
    /// Recording, inside the rendering scope of the cascade: a secondary with Submission::secondaries, else a primary.
    /// Viewport and scissor are set.
    VkCommandBuffer commands = VK_NULL_HANDLE;
    std::uint32_t index = 0; ///< the nearest cascade has 0; what cdrGBufferTexel() takes
    /// View distances that the cascade draws: objects that meet it belong here, and clip distances cut them.
    depth::Cascade clipRange;
    double anchorView = 0.0;           ///< in float64, what objects' view distances are taken relative to
    depth::CascadeConstants constants; ///< CdrCascade of cdr_depth.glsl
    /// How far a shifted lens moves x and y of a clip position, in units of its w. Subtract it times gl_Position.w from
    /// gl_Position.xy. 0 without Camera::lensShift.
    float lensX = 0.0f;
    float lensY = 0.0f; ///< as lensX
    /// The part of the depth buffer that the cascade has. The viewport moves interpolated depths into it. A fragment shader
    /// that sets its depth moves it itself: minDepth + depth * (maxDepth - minDepth). 0 and 1 but for TargetsKind::onePass.
    float minDepth = 0.0f;
    float maxDepth = 1.0f; ///< as minDepth
    /// Of the depth buffer. The colour format is that of a G-buffer, VK_FORMAT_R32G32B32A32_UINT.
    VkFormat depthFormat = VK_FORMAT_UNDEFINED;
    VkCompareOp depthCompare = VK_COMPARE_OP_LESS_OR_EQUAL; ///< that pipelines drawing here need
};

/// What a frame is recorded into. All of it is the host's.
struct HostFrame {
    /// A primary of the family of the device's queue that is recording, outside a rendering scope, an occlusion query, a query
    /// of pipeline statistics and conditional rendering. What the host bound before is not bound afterwards.
    VkCommandBuffer commands = VK_NULL_HANDLE;
    /// A timeline semaphore that reaches `doneValue` once the device has run `commands`. Signalled by the submission
    /// that they are in. The renderer waits for it before it takes back what the frame reads, in its destructor too. So it must
    /// outlive the renderer, or live until Renderer::finish(). A host that does not submit its commands calls
    /// Renderer::dropRecorded(), and nothing waits.
    VkSemaphore done = VK_NULL_HANDLE;
    std::uint64_t doneValue = 0; ///< that `done` reaches, above 0 and above what it has
    /// Where the picture goes: of the renderer's size, made for VK_IMAGE_USAGE_TRANSFER_DST_BIT, in a format that
    /// vkCmdBlitImage() writes; no view. What it held is lost, and `layout` is what the frame leaves it in. With `linear` there
    /// may be none. An sRGB format gets the encoded picture, and any other its linear values: in a UNORM format a window shows
    /// them far too dark.
    SurfaceImage color{};
    /// Where Surfaces::linear goes, with RenderOptions::linear: as `color`, in a format of three or four floats.
    std::optional<SurfaceImage> linear{};
    std::optional<HostDepth> depth{}; ///< where the depth of the host's own camera goes; empty: nowhere
    /// Where motion goes, with RenderOptions::motion: as `color`, in VK_FORMAT_R32G32_SFLOAT or another format of two or
    /// more signed floats. Half floats hold it in steps of 1/1024 of its length or finer, and cdrHasMotion() takes them too.
    /// What blends is seen through. What `draw` draws has the motion of the scene's object with its id; where there is
    /// none, that of an object that stands still.
    std::optional<SurfaceImage> motion{};
    /// Called for each cascade of RenderOptions::part, the nearest or the farthest first, on the caller's thread. Empty:
    /// the host draws nothing inside cascades. A surface writes a texel by cdr_gbuffer.glsl and is lit as cdr's own are. They hide
    /// each other to the step of the technique's depth. Only with SurfacePath::gbuffer, without a focus, and where no material
    /// of the scene emits light or has an occlusion texture, nor RenderOptions::prepareFor says that one may.
    std::function<void(const HostCascade&)> draw{};
    /// View distances of what `draw` draws: fitted cascades and shadow maps cover them too. Finite, each from near to far.
    /// Those behind the camera are below 0. What lies out of the camera's range counts for nothing.
    std::vector<depth::Interval> occupied{};
};

} // namespace cdr::render
