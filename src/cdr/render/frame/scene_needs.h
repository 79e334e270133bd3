#pragma once

#include <cdr/render/cascade_part.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/render_options.h>
#include <cdr/render/renderer_setup.h>

#include <glm/glm.hpp>

namespace cdr::render {

/// What of a scene decides which passes and pipelines there are.
struct SceneNeeds {
    KeptSurfaces kept{};
    bool blended = false;
    bool sky = false;
    bool air = false;
    glm::vec3 focusBackground{0.0f}; ///< that layers of a lens with a focus are cleared to; 0 of others

    SceneTraits traits() const { return {.blended = blended}; }
    bool operator==(const SceneNeeds&) const = default;
};

/// Those of the scene as it was uploaded last, and of what the options prepare for.
SceneNeeds needsOf(const DrawnScene& drawn, const RenderOptions& options);

} // namespace cdr::render
