#pragma once

#include <cdr/render/shadows/light_view.h>
#include <cdr/render/shadows/receiver_cells.h>
#include <cdr/visibility/half_space.h>
#include <cdr/visibility/instance_cells.h>

#include <glm/glm.hpp>

#include <array>

namespace cdr::render {

/// What may cast a shadow on what a view shows: what is in its pyramid, or column, as far as the farthest receiver, and before a
/// surface that reads the map.
class CasterTest {
  public:
    /// Both must outlive it.
    CasterTest(const LightView& view, const ReceiverCells& receivers);

    /// Whether something of a sphere in world space may cast one.
    bool holds(const glm::dvec3& centre, double radius) const;
    /// The same of spheres whose centres are in a box.
    bool holds(const visibility::InstanceCells::Box& box) const;
    /// The same of a box, relative to the view's origin, and what is around it.
    bool holds(const visibility::SkewBox& box, double around) const;

  private:
    const LightView& m_view;
    const ReceiverCells& m_receivers;
    std::array<visibility::HalfSpace, 6> m_sides; ///< relative to the view's origin
};

} // namespace cdr::render
