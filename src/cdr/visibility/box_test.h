#pragma once

#include <cdr/visibility/instance_cells.h>

#include <array>

namespace cdr::visibility {

/// Whether testSpheres() keeps all, some or none of the spheres of a box.
enum class BoxSide : std::uint8_t { outside, across, inside };

/// A range that holds every view distance which testSpheres() gives for centres in a box.
struct ViewRange {
    double low = 0.0;
    double high = 0.0;
};

/// Boxes against what testSpheres() does with the spheres in them. What it says holds for every rounding of that.
class BoxTest {
  public:
    explicit BoxTest(const SphereTest& test);

    BoxSide sideOf(const InstanceCells::Box& box) const;
    ViewRange rangeOf(const InstanceCells::Box& box) const;

  private:
    /// A plane of the frustum through the camera: inside where dot(normal, centre - camera) + offset >= 0.
    struct Plane {
        glm::dvec3 normal{0.0};
        double offset = 0.0;
    };
    SphereTest m_test;
    std::array<Plane, 6> m_planes;
};

} // namespace cdr::visibility
