#include <cdr/render/view_transform.h>

#include <cmath>

namespace cdr::render {

Lens lensOf(const scene::Camera& camera, double aspect) {
    const double tanY = std::tan(0.5 * camera.fovY);
    return {.tanX = aspect * tanY, .tanY = tanY};
}

shaders::DrawRecord makeDrawRecord(const DrawSource& source, const MaterialWords& material,
                                   const scene::Camera& camera, double anchorView) {
    const glm::dvec3 view = camera.toView(source.position);
    const glm::dmat3 basis(source.basis);
    // A row of (view * basis): the axis against each of the basis' columns.
    const auto row = [&](const glm::dvec3& axis, double translation) {
        return glm::vec4(glm::dvec4(axis * basis, translation));
    };
    return {.right = row(camera.right, view.x),
            .up = row(camera.up, view.y),
            .ahead = row(-camera.back, -view.z - anchorView),
            .id = source.id,
            .alphaCutoff = material.alphaCutoff,
            .baseColorRg = material.baseColorRg,
            .baseColorBa = material.baseColorBa};
}

shaders::CascadePush makeCascadePush(const depth::ClipTerms& terms, const depth::Cascade& clipRange,
                                     const Lens& lens, std::uint32_t cascade) {
    return {.anchorView = static_cast<float>(terms.anchorView),
            .depthScale = static_cast<float>(terms.scale),
            .depthOffset = static_cast<float>(terms.offset),
            .nearAhead = static_cast<float>(clipRange.nearView - terms.anchorView),
            .farAhead = static_cast<float>(clipRange.farView - terms.anchorView),
            .projectionX = static_cast<float>(1.0 / lens.tanX),
            .projectionY = static_cast<float>(-1.0 / lens.tanY),
            .cascade = cascade};
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
