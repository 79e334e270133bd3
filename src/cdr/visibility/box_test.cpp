#include <cdr/visibility/box_test.h>

#include <cmath>

namespace cdr::visibility {

namespace {

/// Far more than the roundings of a sphere's test amount to, as a share of the numbers that go into it.
constexpr double kRounding = 0x1p-46;

double sumOf(const glm::dvec3& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// A box as the camera sees it. Differences of positions round monotonously, so they enclose those of the spheres.
struct SeenBox {
    glm::dvec3 middle;
    glm::dvec3 half;
    double size; ///< of the largest number that goes into a test

    SeenBox(const InstanceCells::Box& box, const glm::dvec3& camera) {
        const glm::dvec3 low = box.low - camera;
        const glm::dvec3 high = box.high - camera;
        middle = 0.5 * (low + high);
        half = 0.5 * (high - low);
        size = sumOf(low) + sumOf(high) + box.radius;
    }
    double reachAlong(const glm::dvec3& axis) const { return glm::dot(glm::abs(axis), half); }
};

} // namespace

BoxTest::BoxTest(const SphereTest& test)
    : m_test(test),
      m_planes{{{-test.back * test.sinX - test.right * test.cosX, 0.0},
                {-test.back * test.sinX + test.right * test.cosX, 0.0},
                {-test.back * test.sinY - test.up * test.cosY, 0.0},
                {-test.back * test.sinY + test.up * test.cosY, 0.0},
                {-test.back, -test.nearView},
                {test.back, test.farView}}} {}

BoxSide BoxTest::sideOf(const InstanceCells::Box& box) const {
    const SeenBox seen(box, m_test.position);
    BoxSide side = BoxSide::inside;
    // Every comparison with what is not a number is false, which says across.
    for (const Plane& plane : m_planes) {
        const double middle = glm::dot(plane.normal, seen.middle) + plane.offset;
        const double reach = seen.reachAlong(plane.normal);
        const double rounding = kRounding * (seen.size + std::abs(plane.offset));
        if (middle + reach + box.radius < -rounding) {
            return BoxSide::outside;
        }
        if (!(middle - reach > rounding)) {
            side = BoxSide::across;
        }
    }
    return side;
}

ViewRange BoxTest::rangeOf(const InstanceCells::Box& box) const {
    const SeenBox seen(box, m_test.position);
    const double middle = -glm::dot(m_test.back, seen.middle);
    const double reach = seen.reachAlong(m_test.back) + kRounding * seen.size;
    return {middle - reach, middle + reach};
}

} // namespace cdr::visibility
