#include <cdr/depth/view_constants.h>
#include <cdr/render/view_transform.h>

#include <algorithm>
#include <cmath>

namespace cdr::render {

namespace {

/// Of a difference of cosines; KHR_lights_punctual bounds how sharp a cone is.
constexpr double kMinFall = 1e-3;

/// Scene units, about 10^18; the squares of three such coordinates fit a float32.
constexpr double kFarthestLight = 0x1p60;

float perSquare(double distance) {
    return std::min(static_cast<float>(1.0 / (distance * distance)), std::numeric_limits<float>::max());
}

/// LightRecord::beam.
glm::vec4 beamOf(const scene::LightCone& cone, const scene::Camera& camera) {
    const double scale = 1.0 / std::max(std::cos(cone.inner) - std::cos(cone.outer), kMinFall);
    const auto along = [&](const glm::dvec3& axis) { return glm::dot(axis, cone.direction) * scale; };
    return {along(camera.right), along(camera.up), along(camera.back), -std::cos(cone.outer) * scale};
}

} // namespace

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
            .cutoffAndMetallicRoughness = material.cutoffAndMetallicRoughness,
            .baseColorRg = material.baseColorRg,
            .baseColorBa = material.baseColorBa};
}

glm::dvec3 directionInView(const scene::Camera& camera, const glm::dvec3& world) {
    return {glm::dot(camera.right, world), glm::dot(camera.up, world), glm::dot(camera.back, world)};
}

glm::vec2 splitDouble(double value) {
    const depth::FloatPair pair = depth::floatPair(value);
    return {pair.value, pair.rest};
}

scene::PointLight broughtNear(const scene::PointLight& light, const scene::Camera& camera) {
    const glm::dvec3 way = light.position - camera.position;
    const double farthest = std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
    if (farthest <= kFarthestLight) {
        return light;
    }
    const double share = kFarthestLight / farthest;
    scene::PointLight near = light;
    near.position = camera.position + share * way;
    near.halfDistance *= share;
    if (near.range) {
        *near.range *= share;
    }
    return near;
}

shaders::LightRecord makeLightRecord(const scene::PointLight& anywhere, const scene::Camera& camera) {
    const scene::PointLight light = broughtNear(anywhere, camera);
    const glm::dvec3 view = camera.toView(light.position);
    const glm::vec2 x = splitDouble(view.x);
    const glm::vec2 y = splitDouble(view.y);
    const glm::vec2 w = splitDouble(-view.z);
    return {.position = {x.x, y.x, w.x, perSquare(light.halfDistance)},
            .positionRest = {x.y, y.y, w.y, light.range ? perSquare(*light.range) : 0.0f},
            .color = glm::vec4(light.color, scene::isShaped(light) ? 1.0f : 0.0f),
            .beam = light.cone ? beamOf(*light.cone, camera) : glm::vec4(0.0f, 0.0f, 0.0f, 1.0f)};
}

} // namespace cdr::render
