#pragma once

#include <cdr/depth/technique.h>
#include <cdr/host/trace.h>
#include <cdr/host/worker_pool.h>
#include <cdr/render/effects.h>
#include <cdr/render/focus.h>
#include <cdr/render/geometry/batching.h>
#include <cdr/render/submit/submission.h>
#include <cdr/render/surface_path.h>
#include <cdr/render/targets/targets_choice.h>
#include <cdr/render/translucency/translucency.h>
#include <cdr/visibility/level_choice.h>

#include <cstddef>
#include <cstdint>

namespace cdr::render {

/// What a renderer is made with.
struct RenderOptions {
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    depth::Technique technique;
    TargetsChoice targets = TargetsKind::single;
    std::size_t threads = 1;                           ///< that cull, bin and record, the caller's included
    host::Placement placement = host::Placement::free; ///< of those threads but the caller's
    Submission submission = Submission::secondaries;
    Batching batching = Batching::instanced;
    SurfacePath surface = SurfacePath::gbuffer;
    /// None unless told. Meshes without levels are drawn in full whatever it says.
    visibility::Detail detail{};
    Effects effects{};
    Focus focus{}; ///< on, it needs targets `layers`, and effects without occlusion
    TranslucencyOptions translucency{};
    /// Opaque vertices are rounded to this many sub-pixel bits before the device sees them, as a device with
    /// as few does by itself; 0: not. At most kMaxSnapBits.
    std::uint32_t snapBits = 0;
    std::size_t framesInFlight = 1; ///< that submit() lets the device lag behind, 1 to kMaxFramesInFlight
    /// Receives every frame's stages and jobs; must have `threads` tracks and outlive the renderer. Null for
    /// none.
    host::Trace* trace = nullptr;

    bool operator==(const RenderOptions&) const = default;
};

inline constexpr std::size_t kMaxFramesInFlight = 8;
inline constexpr std::uint32_t kMaxSnapBits = 8;

} // namespace cdr::render
