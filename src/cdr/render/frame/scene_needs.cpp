#include <cdr/render/frame/scene_needs.h>

namespace cdr::render {

SceneNeeds needsOf(const DrawnScene& drawn, const RenderOptions& options) {
    const auto [kept, blended] = preparedSurfaces(drawn.uploaded, options.prepareFor);
    return {.kept = {.metallicRoughness = kept.metallicRoughness && keepsMetallicRoughness(options),
                     .emission = kept.emission && keepsEmission(options)},
            .blended = blended,
            .sky = drawn.scene.sky.has_value(),
            .air = drawn.scene.air.has_value(),
            .focusBackground = options.focus.isOn() ? drawn.scene.background : glm::vec3(0.0f)};
}

} // namespace cdr::render
