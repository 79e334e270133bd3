#include <cdr/render/shadows/caster_test.h>

#include <algorithm>

namespace cdr::render {

CasterTest::CasterTest(const LightView& view, const ReceiverCells& receivers)
    : m_view(view),
      m_receivers(receivers) {
    const glm::dvec2 high = view.low + view.texel * glm::dvec2(view.size.width, view.size.height);
    const auto add = [&](std::size_t i, const glm::dvec3& axis, double sign, double limit) {
        const glm::dvec3 normal = sign * (axis - limit * view.wPerUnit * view.ahead);
        m_planes[i] = {normal, -sign * limit * view.wOffset, glm::length(normal)};
    };
    add(0, view.right, 1.0, view.low.x);
    add(1, view.right, -1.0, high.x);
    add(2, view.up, 1.0, view.low.y);
    add(3, view.up, -1.0, high.y);
    m_planes[4] = {-view.ahead, view.farAhead, 1.0};
    m_planes[5] = {view.wPerUnit * view.ahead, view.wOffset, view.wPerUnit};
}

bool CasterTest::holds(const glm::dvec3& centre, double radius) const {
    const glm::dvec3 place = centre - m_view.origin;
    return std::all_of(m_planes.begin(), m_planes.end(),
                       [&](const Plane& plane) {
                           return glm::dot(plane.normal, place) + plane.offset >= -radius * plane.length;
                       }) &&
           m_receivers.meet(m_view.toLight(place), glm::dvec3(radius));
}

bool CasterTest::holds(const visibility::InstanceCells::Box& box) const {
    const glm::dvec3 middle = 0.5 * ((box.low - m_view.origin) + (box.high - m_view.origin));
    const glm::dvec3 half = 0.5 * (box.high - box.low);
    return holds({.middle = middle,
                  .halfSides = glm::dmat3(glm::dvec3(half.x, 0.0, 0.0), glm::dvec3(0.0, half.y, 0.0),
                                          glm::dvec3(0.0, 0.0, half.z))},
                 box.radius);
}

bool CasterTest::holds(const Box& box, double around) const {
    const auto reach = [&](const glm::dvec3& way) {
        const glm::dvec3 sides = glm::abs(way * box.halfSides);
        return sides.x + sides.y + sides.z;
    };
    const glm::dvec3 across(reach(m_view.right), reach(m_view.up), reach(m_view.ahead));
    return std::all_of(m_planes.begin(), m_planes.end(),
                       [&](const Plane& plane) {
                           return glm::dot(plane.normal, box.middle) + plane.offset >=
                                  -(reach(plane.normal) + around * plane.length);
                       }) &&
           m_receivers.meet(m_view.toLight(box.middle), across + around);
}

} // namespace cdr::render
