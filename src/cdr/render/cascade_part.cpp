#include <cdr/base/format_error.h>
#include <cdr/render/cascade_part.h>
#include <cdr/render/render_options.h>

namespace cdr::render {

namespace {

/// Null where nothing is in the way.
const char* whatNeedsAllCascades(const RenderOptions& options, const SceneTraits& scene) {
    if (options.effects.antialias != Antialias::none) {
        return "smoothed edges";
    }
    if (options.effects.occlusion.radius > 0.0 && !options.effects.occlusion.perLayer) {
        return "ambient occlusion over the whole picture";
    }
    if (options.shadows.isOn()) {
        return "shadows"; // what another part draws casts them too
    }
    if (options.focus.isOn()) {
        return "a lens with a focus";
    }
    if (options.motion) {
        return "motion";
    }
    if (options.linear) {
        return "pictures of linear light";
    }
    if (scene.blended) {
        return "blended materials";
    }
    if (options.occlusionCulling) {
        return "occlusion culling";
    }
    return options.submission == Submission::gpuDriven ? "gpu-driven draws" : nullptr;
}

} // namespace

void requireDivisible(const RenderOptions& options, const SceneTraits& scene) {
    if (const char* what = whatNeedsAllCascades(options, scene)) {
        throw base::inputError("cascades cannot be divided: {} need all of them", what);
    }
    if (options.part.index >= options.part.count) {
        throw base::inputError("part {} of {} of the cascades: parts count from 0", options.part.index,
                               options.part.count);
    }
}

} // namespace cdr::render
