#include <cdr/render/frame/scene_needs.h>
#include <cdr/render/renderer_setup.h>

namespace cdr::render {

SceneNeeds needsOf(const DrawnScene& drawn, const RenderOptions& options) {
    const GpuScene& uploaded = drawn.uploaded;
    const PreparedSurfaces prepared = preparedSurfaces(options.prepareFor);
    return {.metallicRoughness = (uploaded.hasMetallicRoughness() || prepared.metallicRoughness) &&
                                 keepsMetallicRoughness(options),
            .blended = uploaded.hasBlended() || prepared.blended,
            .emission = (uploaded.hasEmission() || prepared.emission) && keepsEmission(options),
            .sky = drawn.scene.sky.has_value(),
            .air = drawn.scene.air.has_value(),
            .focusBackground = options.focus.isOn() ? drawn.scene.background : glm::vec3(0.0f)};
}

} // namespace cdr::render
