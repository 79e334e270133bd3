#pragma once

#include <cdr/render/cascade_part.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/render_options.h>
#include <cdr/render/submit/draw_path_factory.h>

#include <glm/glm.hpp>

namespace cdr::render {

/// What of a scene decides which passes and pipelines there are.
struct SceneNeeds {
    bool metallicRoughness = false;
    bool blended = false;
    bool emission = false;
    bool sky = false;
    bool air = false;
    glm::vec3 focusBackground{0.0f}; ///< that layers of a lens with a focus are cleared to; 0 of others

    SceneTraits traits() const { return {.blended = blended}; }
    KeptSurfaces kept() const { return {.metallicRoughness = metallicRoughness, .emission = emission}; }
    bool operator==(const SceneNeeds&) const = default;
};

/// Those of the scene as it was uploaded last, and of what the options prepare for.
SceneNeeds needsOf(const DrawnScene& drawn, const RenderOptions& options);

} // namespace cdr::render
