#pragma once

#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <array>
#include <cstdint>
#include <vector>

namespace cdr::test {

/// The nearest visible surface of one object along a ray.
struct ReferenceHit {
    std::uint32_t id; ///< object index + 1
    long double distanceView;
};

/// A second way to compute the truth, to check the first. It tests every pixel against every triangle in world
/// space, by the plane and the three edge volumes. It uses the 64-bit mantissa of x86's long double. It has no
/// boxes, no tree and no object space.
class ReferenceCaster {
  public:
    ReferenceCaster(const scene::Scene& scene, const scene::Camera& camera, std::uint32_t width,
                    std::uint32_t height);

    /// Per object that the ray meets its nearest visible surface, nearest first.
    std::vector<ReferenceHit> hits(std::uint32_t x, std::uint32_t y) const;

    struct Vector {
        long double x, y, z;
    };

  private:
    struct WorldTriangle {
        std::array<Vector, 3> corners; ///< about the camera
        Vector normal;                 ///< of the front, not of unit length
        std::array<Vector, 3> inward;  ///< within the plane, normal to the edge that starts at each corner
        std::uint32_t id;
        bool doubleSided;

        /// Whether a point of the plane lies inside.
        bool holds(const Vector& point) const;
    };
    scene::Camera m_camera;
    std::uint32_t m_width;
    std::uint32_t m_height;
    std::vector<WorldTriangle> m_triangles;
};

} // namespace cdr::test
