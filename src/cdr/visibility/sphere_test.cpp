#include <cdr/platform/vector_clones.h>
#include <cdr/visibility/sphere_test.h>

#include <algorithm>
#include <cmath>

namespace cdr::visibility {

namespace {

/// The hot loop: straight-line arithmetic over arrays, no branch, so compilers vectorise it. They do so only
/// where they know that writing the result changes neither the test nor the pointers, hence the copies.
CDR_VECTOR_CLONES
void testAll(const SphereTest test, const Spheres spheres, std::size_t count, TestedSpheres& tested) {
    const auto [x, y, z, radius] = spheres;
    for (std::size_t i = 0; i < count; ++i) {
        const double dx = x[i] - test.position.x;
        const double dy = y[i] - test.position.y;
        const double dz = z[i] - test.position.z;
        const double vx = dx * test.right.x + dy * test.right.y + dz * test.right.z;
        const double vy = dx * test.up.x + dy * test.up.y + dz * test.up.z;
        const double w = -(dx * test.back.x + dy * test.back.y + dz * test.back.z);
        const double sideX = w * test.sinX - std::abs(vx) * test.cosX;
        const double sideY = w * test.sinY - std::abs(vy) * test.cosY;
        const double depth = std::min(w - test.nearView, test.farView - w);
        tested.distanceView[i] = w;
        tested.margin[i] = std::min(std::min(sideX, sideY), depth) + static_cast<double>(radius[i]);
    }
}

} // namespace

SphereTest::SphereTest(const scene::Camera& camera, const scene::Frustum& frustum)
    : position(camera.position),
      right(frustum.rightOf(camera)),
      up(frustum.upOf(camera)),
      back(camera.back),
      cosX(frustum.cosX),
      sinX(frustum.sinX),
      cosY(frustum.cosY),
      sinY(frustum.sinY),
      nearView(camera.nearView),
      farView(camera.farView) {}

void testSpheres(const SphereTest& camera, const Spheres& spheres, std::size_t count, TestedSpheres& tested) {
    testAll(camera, spheres, count, tested);
}

} // namespace cdr::visibility
