#include <cdr/visibility/chunk_test.h>

#include <algorithm>
#include <cmath>

namespace cdr::visibility {

namespace {

/// The device rounds vertices to float32: by this share of the distance and of the mesh's size at most.
constexpr double kVertexShare = 0x1p-20;

} // namespace

ChunkTest::ChunkTest(const scene::Camera& camera, const scene::Frustum& frustum,
                     const depth::Cascade& clipRange)
    : m_position(camera.position),
      m_toView(glm::transpose(glm::dmat3(frustum.rightOf(camera), frustum.upOf(camera), -camera.back))),
      m_pixel(frustum.footprintSlope) {
    const auto plane = [](const glm::dvec3& normal, double offset) {
        return Plane{normal, offset, glm::length(normal)};
    };
    m_planes = {plane({frustum.cosX, 0.0, frustum.sinX}, 0.0), plane({-frustum.cosX, 0.0, frustum.sinX}, 0.0),
                plane({0.0, frustum.cosY, frustum.sinY}, 0.0), plane({0.0, -frustum.cosY, frustum.sinY}, 0.0),
                plane({0.0, 0.0, 1.0}, -clipRange.nearView),   plane({0.0, 0.0, -1.0}, clipRange.farView)};
}

ChunkTest::Placed ChunkTest::placed(const glm::dvec3& position, const glm::mat3& basis, float radius) const {
    const glm::dvec3 fromCamera = position - m_position;
    const auto reach = static_cast<double>(radius);
    const double distance = glm::length(fromCamera) + reach;
    return {.centre = m_toView * fromCamera,
            .basis = m_toView * glm::dmat3(basis),
            .radius = reach,
            .rounding = kVertexShare * distance};
}

bool ChunkTest::holdsAll(const Placed& instance) const {
    const double reach =
        instance.radius + instance.rounding; // a vertex inside is drawn, wherever it is snapped to
    return std::all_of(m_planes.begin(), m_planes.end(), [&](const Plane& plane) {
        return glm::dot(plane.normal, instance.centre) + plane.offset >= reach * plane.length;
    });
}

bool ChunkTest::mayShow(const Placed& instance, const MeshChunk& chunk) const {
    const glm::dvec3 middle = instance.centre + instance.basis * glm::dvec3(chunk.middle);
    const glm::dvec3 half(chunk.half);
    const auto reach = [&](const glm::dvec3& way) { return glm::dot(glm::abs(way * instance.basis), half); };
    const double farthest = std::abs(middle.z) + reach({0.0, 0.0, 1.0});
    const double rounding = instance.rounding + m_pixel * farthest;
    return std::none_of(m_planes.begin(), m_planes.end(), [&](const Plane& plane) {
        return glm::dot(plane.normal, middle) + plane.offset <
               -(reach(plane.normal) + rounding * plane.length);
    });
}

} // namespace cdr::visibility
