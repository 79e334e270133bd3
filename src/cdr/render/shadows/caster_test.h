#pragma once

#include <cdr/render/shadows/light_view.h>
#include <cdr/render/shadows/receiver_cells.h>
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

    /// A parallelepiped, relative to the view's origin.
    struct Box {
        glm::dvec3 middle{0.0};
        glm::dmat3 halfSides{0.0};
    };
    /// Whether something of a sphere in world space may cast one.
    bool holds(const glm::dvec3& centre, double radius) const;
    /// The same of spheres whose centres are in a box.
    bool holds(const visibility::InstanceCells::Box& box) const;
    /// The same of a box and what is around it.
    bool holds(const Box& box, double around) const;

  private:
    /// Inside where dot(normal, place) + offset >= 0, relative to the view's origin. Not of unit length.
    struct Plane {
        glm::dvec3 normal{0.0};
        double offset = 0.0;
        double length = 0.0;
    };
    const LightView& m_view;
    const ReceiverCells& m_receivers;
    std::array<Plane, 6> m_planes;
};

} // namespace cdr::render
