#include "finish.h"

#include <array>
#include <cstddef>

namespace cdr::viewer {

void apply(const Finish& finish, render::RenderOptions& options) {
    options.detail = finish.detail;
    options.translucency = finish.translucency;
    options.effects = finish.effects;
    options.effects.occlusion.perLayer = finish.effects.occlusion.perLayer && hasLayers(options.targets.kind);
    if (options.targets.kind == render::TargetsKind::layers) {
        options.focus = finish.focus;
    }
    if (castsShadows(finish, options.targets.kind)) {
        options.shadows = finish.shadows;
    }
}

bool castsShadows(const Finish& finish, render::TargetsKind targets) {
    const bool isFocused = targets == render::TargetsKind::layers && finish.focus.isOn();
    return finish.shadows.isOn() && !isFocused && render::castsShadows(finish.detail.mode);
}

std::string_view explanationOf(visibility::DetailMode detail) {
    constexpr std::array<std::string_view, 4> kTexts{
        "Every mesh in full. It is slow where they are dense and small.",
        "Each object at the coarsest level whose error stays under half a pixel. The level is the same in "
        "all its cascades, so there are no cracks.",
        "Each cascade chooses, as in the thesis. An object that crosses a boundary is drawn at two levels, "
        "which may leave cracks.",
        "Each piece of a large mesh at a level of its own, by its distance. Near parts are fine and far ones "
        "coarse, without cracks. Small meshes are drawn by object."};
    return kTexts[static_cast<std::size_t>(detail)];
}

std::string_view explanationOf(render::Translucency translucency) {
    return translucency == render::Translucency::weighted
               ? "Blended surfaces of a cascade are averaged by weight, and cascades are composited. It is "
                 "fast, and approximate where surfaces overlap."
               : "Every blended fragment is kept, sorted by its distance and composited. It is exact, but "
                 "takes memory.";
}

std::string_view explanationOf(render::ShadowMethod shadows) {
    constexpr std::array<std::string_view, 3> kTexts{
        "There are no shadows.",
        "The first four lights cast shadows, each by a map for every range of distances that is seen. There "
        "are none with a focus, nor with levels of detail by cascade or cluster.",
        "Today's practice: four maps for each light, for any distances. There are none with a focus, nor with "
        "levels of detail by cascade or cluster."};
    return kTexts[static_cast<std::size_t>(shadows)];
}

std::string_view explanationOf(render::Antialias antialias) {
    return antialias == render::Antialias::none
               ? "Pixels as they were sampled, as measurements use them."
               : "Steps along edges of brightness are smoothed after shading.";
}

std::string_view explanationOf(render::ToneMap toneMap) {
    constexpr std::array<std::string_view, 3> kTexts{
        "Highlights are compressed under a sky, which models have, or through air. Otherwise they are cut "
        "off.",
        "What is brighter than the picture's white is cut off.",
        "Highlights are compressed, and base colours stay as they are (Khronos PBR Neutral)."};
    return kTexts[static_cast<std::size_t>(toneMap)];
}

std::string_view explanationOf(const render::Occlusion& occlusion) {
    if (occlusion.radius <= 0.0) {
        return "Corners get as much ambient light as open ground.";
    }
    return occlusion.perLayer
               ? "Corners lose ambient light, on each cascade alone (thesis method 2). Surfaces in "
                 "another cascade do not darken them. It needs layered targets."
               : "Corners lose ambient light, by distances that all cascades share. So no boundary is "
                 "visible.";
}

std::string_view explanationOf(const render::Fog& fog) {
    return fog.visibility <= 0.0 ? "Clear air." : "At this distance 2 % of a colour is left.";
}

std::string_view explanationOf(const render::Focus& focus) {
    if (!focus.isOn()) {
        return "Everything is sharp. With the targets layers a lens can be focused on a distance.";
    }
    return focus.blend ? "What is out of focus is drawn in fewer pixels, cascade by cascade. Cascades that "
                         "meet fade into each other."
                       : "What is out of focus is drawn in fewer pixels, cascade by cascade, as the thesis "
                         "proposes. A seam is visible where cascades meet.";
}

} // namespace cdr::viewer
