#pragma once

#include <cdr/depth/technique.h>
#include <cdr/platform/trace.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/render/cascade_part.h>
#include <cdr/render/effects.h>
#include <cdr/render/focus.h>
#include <cdr/render/geometry/batching.h>
#include <cdr/render/geometry/snapping.h>
#include <cdr/render/layer_options.h>
#include <cdr/render/shadows/shadows.h>
#include <cdr/render/submit/submission.h>
#include <cdr/render/surface_path.h>
#include <cdr/render/targets/targets_choice.h>
#include <cdr/render/translucency/translucency.h>
#include <cdr/scene/mesh.h>
#include <cdr/visibility/level_choice.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::render {

/// Kinds of content that a world may hold later. A renderer makes their passes and pipelines at the start. Without this, it
/// makes its passes anew at the first material that is metallic-roughness, blends or emits light. It makes pipelines at the
/// first draw of a kind of materials and meshes, and at each further number of lights. A scene without such content is drawn
/// as if it had it. So metallic-roughness, blending and emission cost time in each frame.
struct PrepareFor {
    bool metallicRoughness = false; ///< materials with scene::Material::metallicRoughness
    bool blended = false;           ///< materials of scene::AlphaMode::blend
    bool emission = false;          ///< materials that emit light or have occlusion textures
    std::uint32_t lights = 0;       ///< so many point lights, at most kMaxPreparedLights
    bool shapedLights = false;      ///< lights with a cone or a range; `lights` says how many there may be
    /// Materials like these, of whatever colours and textures, on any mesh: they also say which of the above there may be.
    /// Of a texture only whether there is one matters.
    std::vector<scene::Material> materials{};

    bool operator==(const PrepareFor&) const = default;
};

/// Most PrepareFor::lights.
inline constexpr std::uint32_t kMaxPreparedLights = 65'536;

/// What a renderer is made with.
struct RenderOptions {
    std::uint32_t width = 1280;                  ///< of the picture in pixels
    std::uint32_t height = 720;                  ///< of the picture in pixels
    depth::Technique technique{};                ///< mapping, split and depth format
    TargetsChoice targets = TargetsKind::single; ///< how cascades reach the final G-buffer
    std::size_t threads = 1;                     ///< that cull, bin and record, the caller's included
    platform::Placement placement = platform::Placement::free; ///< of those threads but the caller's
    Submission submission = Submission::secondaries;           ///< how draws reach the device
    Batching batching = Batching::instanced;                   ///< how many instances a draw has
    SurfacePath surface = SurfacePath::gbuffer;                ///< what the geometry pass writes
    /// None by default. Meshes without levels are always drawn in full.
    visibility::Detail detail{};
    Effects effects{};                  ///< none by default
    Focus focus{};                      ///< on, it needs targets `layers`, and effects without occlusion
    TranslucencyOptions translucency{}; ///< of blended surfaces
    LayerOptions layers{};              ///< how surfaces in layers are drawn
    /// Opaque vertices are rounded to this many sub-pixel bits before the device sees them, as a device with
    /// as few does by itself. 0: not. At most kMaxSnapBits.
    std::uint32_t snapBits = 0;
    Snapping snapping = Snapping::byDevice; ///< how they get there
    /// Leaves out what opaque surfaces hide, after drawing the depth of what the last frame showed. The picture is the
    /// same, but with Snapping::inPlane on a device that does not round vertices as it tells: a gap of half a sub-pixel between
    /// two surfaces may be closed there. Unless gpu-driven, it waits for the device within each frame, and cannot be recorded into
    /// a host's commands. Not with a focus. Scenes with layers are drawn whole.
    bool occlusionCulling = false;
    /// None by default. Not with a focus or a part of the cascades, and only with levels of detail for which castsShadows().
    Shadows shadows{};
    std::size_t framesInFlight = 1; ///< that submit() lets the device lag behind, 1 to kMaxFramesInFlight
    /// Works out motion: how far each pixel's surface is from where it was in the last frame (Surfaces::motion,
    /// HostFrame::motion, Frame::motion). Each object must move as one, and a deformed mesh may show its object's motion alone
    /// (src/cdr/README.md, "Motion"). Not with a focus.
    bool motion = false;
    /// Keeps each pixel's light in half floats beside the picture, before exposure, tone mapping and antialiasing
    /// (Surfaces::linear, HostFrame::linear, Frame::linear). For who finishes pictures himself. Not with SurfacePath::lit.
    bool linear = false;
    PrepareFor prepareFor{}; ///< by default only what the scene holds
    /// Which cascades of each frame it draws, by default all. A frame's counts are those of all cascades.
    CascadePart part{};
    bool deviceClock = false; ///< times frames by the device's own clock too (FrameTimes::deviceMs)
    /// For tests: platform::WorkerPool::setSchedule() with this number; empty: threads take jobs as they can.
    std::optional<std::uint64_t> schedule{};
    /// Receives every frame's stages and jobs; must have `threads` tracks and outlive the renderer. Null for
    /// none.
    platform::Trace* trace = nullptr;

    bool operator==(const RenderOptions&) const = default;
};

/// Most frames in flight.
inline constexpr std::size_t kMaxFramesInFlight = 8;
/// Most sub-pixel bits that vertices are rounded to.
inline constexpr std::uint32_t kMaxSnapBits = 8;

} // namespace cdr::render
