#include <cdr/depth/view_constants.h>
#include <cdr/render/view_transform.h>

namespace cdr::render {

DrawRecordMaker::DrawRecordMaker(const scene::Camera& camera, double anchorView)
    : m_position(camera.position),
      m_right(camera.right),
      m_up(camera.up),
      m_ahead(-camera.back),
      m_anchorView(anchorView),
      m_rows{} {}

void DrawRecordMaker::turn(const glm::mat3& basis) {
    const glm::dmat3 exact(basis);
    m_rows = {glm::vec3(m_right * exact), glm::vec3(m_up * exact), glm::vec3(m_ahead * exact)};
    m_basis = basis;
}

shaders::DrawRecord DrawRecordMaker::make(const DrawSource& source, const MaterialWords& material) {
    if (source.basis != m_basis) {
        turn(source.basis);
    }
    const glm::dvec3 offset = source.position - m_position;
    const auto along = [&](const glm::dvec3& axis) { return glm::dot(axis, offset); };
    return {.right = glm::vec4(m_rows[0], static_cast<float>(along(m_right))),
            .up = glm::vec4(m_rows[1], static_cast<float>(along(m_up))),
            .ahead = glm::vec4(m_rows[2], static_cast<float>(along(m_ahead) - m_anchorView)),
            .id = source.id,
            .cutoffAndShine = material.cutoffAndShine,
            .baseColorRg = material.baseColorRg,
            .baseColorBa = material.baseColorBa};
}

glm::vec2 splitDouble(double value) {
    const depth::FloatPair pair = depth::floatPair(value);
    return {pair.value, pair.rest};
}

shaders::LightRecord makeLightRecord(const scene::PointLight& light, const scene::Camera& camera) {
    const glm::dvec3 view = camera.toView(light.position);
    const glm::vec2 x = splitDouble(view.x);
    const glm::vec2 y = splitDouble(view.y);
    const glm::vec2 w = splitDouble(-view.z);
    const double perSquare = 1.0 / (light.halfDistance * light.halfDistance);
    return {.position = {x.x, y.x, w.x,
                         std::min(static_cast<float>(perSquare), std::numeric_limits<float>::max())},
            .positionRest = {x.y, y.y, w.y, 0.0f},
            .color = glm::vec4(light.color, 0.0f)};
}

} // namespace cdr::render
