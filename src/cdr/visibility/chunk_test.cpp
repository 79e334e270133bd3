#include <cdr/visibility/chunk_test.h>
#include <cdr/visibility/vertex_rounding.h>

#include <algorithm>
#include <cmath>

namespace cdr::visibility {

ChunkTest::ChunkTest(const scene::Camera& camera, const scene::Frustum& frustum,
                     const depth::Cascade& clipRange, double anchorView)
    : m_position(camera.position),
      m_toView(glm::transpose(glm::dmat3(frustum.rightOf(camera), frustum.upOf(camera), -camera.back))),
      m_sides{HalfSpace({frustum.cosX, 0.0, frustum.sinX}, 0.0),
              HalfSpace({-frustum.cosX, 0.0, frustum.sinX}, 0.0),
              HalfSpace({0.0, frustum.cosY, frustum.sinY}, 0.0),
              HalfSpace({0.0, -frustum.cosY, frustum.sinY}, 0.0),
              HalfSpace({0.0, 0.0, 1.0}, -clipRange.nearView),
              HalfSpace({0.0, 0.0, -1.0}, clipRange.farView)},
      m_anchorView(anchorView),
      m_pixel(frustum.footprintSlope) {}

ChunkTest::Placed ChunkTest::placed(const glm::dvec3& position, const glm::mat3& basis, float radius) const {
    const glm::dvec3 fromCamera = position - m_position;
    const auto reach = static_cast<double>(radius);
    return {.centre = m_toView * fromCamera,
            .basis = m_toView * glm::dmat3(basis),
            .radius = reach,
            .rounding = vertexRounding(fromCamera, reach, m_anchorView)};
}

bool ChunkTest::holdsAll(const Placed& instance) const {
    return std::all_of(m_sides.begin(), m_sides.end(), [&](const HalfSpace& side) {
        return side.holds(instance.centre, instance.radius + instance.rounding);
    });
}

bool ChunkTest::mayShow(const Placed& instance, const MeshChunk& chunk) const {
    const SkewBox box = placedBox(instance.centre, instance.basis, chunk.middle, chunk.half);
    const double farthest = std::abs(box.middle.z) + box.reach({0.0, 0.0, 1.0});
    const double around = instance.rounding + m_pixel * farthest;
    return std::ranges::all_of(m_sides, [&](const HalfSpace& side) { return side.meets(box, around); });
}

} // namespace cdr::visibility
