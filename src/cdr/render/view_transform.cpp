#include <cdr/render/view_transform.h>

#include <cmath>

namespace cdr::render {

Lens lensOf(const scene::Camera& camera, double aspect) {
    const double tanY = std::tan(0.5 * camera.fovY);
    return {.tanX = aspect * tanY, .tanY = tanY};
}

shaders::DrawRecord makeDrawRecord(const scene::Instances& instances, std::uint32_t instance,
                                   const scene::Camera& camera, double anchorView) {
    const glm::dvec3 view = camera.toView(instances.position(instance));
    const glm::dmat3 basis(instances.basis[instance]);
    // A row of (view * basis): the axis against each of the basis' columns.
    const auto row = [&](const glm::dvec3& axis, double translation) {
        return glm::vec4(glm::dvec4(axis * basis, translation));
    };
    return {.right = row(camera.right, view.x),
            .up = row(camera.up, view.y),
            .ahead = row(-camera.back, -view.z - anchorView),
            .object = instances.object[instance] + 1,
            .material = instances.material[instance],
            .pad0 = 0,
            .pad1 = 0};
}

shaders::CascadePush makeCascadePush(const depth::ClipTerms& terms, const depth::Cascade& clipRange,
                                     const Lens& lens, const DepthSlice& slice, std::uint32_t cascade) {
    return {.anchorView = static_cast<float>(terms.anchorView),
            .depthScale = static_cast<float>(terms.scale),
            .depthOffset = static_cast<float>(terms.offset),
            .nearAhead = static_cast<float>(clipRange.nearView - terms.anchorView),
            .farAhead = static_cast<float>(clipRange.farView - terms.anchorView),
            .projectionX = static_cast<float>(1.0 / lens.tanX),
            .projectionY = static_cast<float>(-1.0 / lens.tanY),
            .cascade = cascade,
            .minDepth = slice.min,
            .maxDepth = slice.max};
}

glm::vec2 splitDouble(double value) {
    const auto high = static_cast<float>(value);
    return {high, static_cast<float>(value - static_cast<double>(high))};
}

shaders::LightRecord makeLightRecord(const scene::PointLight& light, const scene::Camera& camera) {
    const glm::dvec3 view = camera.toView(light.position);
    const glm::vec2 x = splitDouble(view.x);
    const glm::vec2 y = splitDouble(view.y);
    const glm::vec2 w = splitDouble(-view.z);
    return {.position = {x.x, y.x, w.x, static_cast<float>(light.halfDistance)},
            .positionRest = {x.y, y.y, w.y, 0.0f},
            .color = glm::vec4(light.color, 0.0f)};
}

} // namespace cdr::render
