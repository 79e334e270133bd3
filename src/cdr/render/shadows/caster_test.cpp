#include <cdr/render/shadows/caster_test.h>

#include <algorithm>

namespace cdr::render {

using visibility::HalfSpace;
using visibility::SkewBox;

CasterTest::CasterTest(const LightView& view, const ReceiverCells& receivers)
    : m_view(view),
      m_receivers(receivers) {
    const glm::dvec2 high = view.low + view.texel * glm::dvec2(view.size.width, view.size.height);
    const auto beside = [&](const glm::dvec3& axis, double sign, double limit) {
        return HalfSpace(sign * (axis - limit * view.wPerUnit * view.ahead), -sign * limit * view.wOffset);
    };
    m_sides = {beside(view.right, 1.0, view.low.x),   beside(view.right, -1.0, high.x),
               beside(view.up, 1.0, view.low.y),      beside(view.up, -1.0, high.y),
               HalfSpace(-view.ahead, view.farAhead), HalfSpace(view.wPerUnit * view.ahead, view.wOffset)};
}

bool CasterTest::holds(const glm::dvec3& centre, double radius) const {
    const glm::dvec3 place = centre - m_view.origin;
    return std::ranges::all_of(m_sides, [&](const HalfSpace& side) { return side.meets(place, radius); }) &&
           m_receivers.meet(m_view.toLight(place), glm::dvec3(radius));
}

bool CasterTest::holds(const visibility::InstanceCells::Box& box) const {
    if (!(box.low.x <= box.high.x)) { // without centres it has no middle
        return false;
    }
    const glm::dvec3 middle = 0.5 * ((box.low - m_view.origin) + (box.high - m_view.origin));
    const glm::dvec3 half = 0.5 * (box.high - box.low);
    return holds({.middle = middle, .halfSides = {half.x, 0.0, 0.0, 0.0, half.y, 0.0, 0.0, 0.0, half.z}},
                 box.radius);
}

bool CasterTest::holds(const SkewBox& box, double around) const {
    const glm::dvec3 across(box.reach(m_view.right), box.reach(m_view.up), box.reach(m_view.ahead));
    return std::ranges::all_of(m_sides, [&](const HalfSpace& side) { return side.meets(box, around); }) &&
           m_receivers.meet(m_view.toLight(box.middle), across + around);
}

} // namespace cdr::render
