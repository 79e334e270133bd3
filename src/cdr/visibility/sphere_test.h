#pragma once

#include <cdr/scene/frustum.h>

#include <array>
#include <cstddef>

namespace cdr::visibility {

/// Instances tested together: the working set stays in the first-level cache and the loop over it is vectorised.
inline constexpr std::size_t kTestBlock = 512;

/// A camera as the test wants it. Along the picture's own axes the frustum is symmetric, so two side planes each stand for two.
struct SphereTest {
    glm::dvec3 position{0.0};
    glm::dvec3 right{0.0}; ///< scene::Frustum::rightOf()
    glm::dvec3 up{0.0};    ///< scene::Frustum::upOf()
    glm::dvec3 back{0.0};
    double cosX = 1.0;
    double sinX = 0.0;
    double cosY = 1.0;
    double sinY = 0.0;
    double nearView = 0.0;
    double farView = 0.0;

    SphereTest() = default;
    SphereTest(const scene::Camera& camera, const scene::Frustum& frustum);
};

/// The part of instances that the test reads: centres in world space, and radii.
struct Spheres {
    const double* x;
    const double* y;
    const double* z;
    const float* radius;
};

/// What the test says of each sphere.
struct TestedSpheres {
    std::array<double, kTestBlock> distanceView; ///< of the centre
    std::array<double, kTestBlock> margin;       ///< below 0: outside one of the planes
};

/// Sphere against frustum (thesis Listing A.1): the one place that decides whether an instance is seen, and how far.
/// @param count at most kTestBlock.
void testSpheres(const SphereTest& camera, const Spheres& spheres, std::size_t count, TestedSpheres& tested);

} // namespace cdr::visibility
