#pragma once

#include <cdr/base/export.h>
#include <cdr/platform/worker_pool.h>

#include <cstddef>

namespace cdr::render {

struct RenderOptions;

/// A renderer's part in frames that several draw: neighbouring cascades of each frame. The first part has the nearest
/// ones, so the nearest part with a surface at a pixel decides it, without a comparison of depth. A part without cascades
/// shows the background.
struct CascadePart {
    std::size_t index = 0; ///< below `count`
    std::size_t count = 1; ///< parts, 1 or more

    /// Its cascades, where a frame has so many. Where they do not come out even, the nearer parts have one more.
    /// @errors None: that there is such a part is not checked.
    platform::IndexRange of(std::size_t cascades) const {
        const platform::IndexRange mirrored = platform::evenRange(cascades, count - 1 - index, count);
        return {cascades - mirrored.end, cascades - mirrored.begin};
    }
    bool operator==(const CascadePart&) const = default;
};

/// What of a scene decides how a renderer is set up.
struct SceneTraits {
    bool blended = false; ///< it has blended materials
};

/// Refuses what several renderers cannot draw together.
/// @throws base::InputError for what reads more than a pixel's own surface, or needs other cascades.
///         Antialiasing, ambient occlusion over the whole picture, shadows, a lens with a focus, motion and linear light do.
///         So do occlusion culling, blended surfaces and gpu-driven draws. Also for a part that does not exist.
CDR_EXPORT void requireDivisible(const RenderOptions& options, const SceneTraits& scene);

} // namespace cdr::render
