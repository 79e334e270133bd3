#include <cdr/measure/certify/screen_triangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::test {
namespace {

using measure::ScreenTriangle;

// Eleven bits more than what is tested.
using Exact = glm::vec<3, long double>;
using ExactMatrix = glm::mat<3, 3, long double>;

constexpr std::uint32_t kPictureSide = 64;
constexpr float kTurn = 0.70710678f;
constexpr double kViewDistance = 10.0;

/// A camera at the origin that is turned by 45 degrees, and an instance that float32 turns as much. So what places its corners
/// are sums of terms that may be far larger than the sums.
struct TurnedView {
    measure::DrawnFrame frame;
    scene::Instances instances;
    measure::MeshOutline outline;

    explicit TurnedView(const glm::dvec3& position) {
        frame.ids = image::ImageU32(kPictureSide, kPictureSide);
        const double turn = std::sqrt(0.5);
        frame.camera.right = {turn, 0.0, -turn};
        frame.camera.back = {-turn, 0.0, -turn};
        instances.x = {position.x};
        instances.y = {position.y};
        instances.z = {position.z};
        instances.basis = {glm::mat3(glm::vec3(kTurn, 0.0f, -kTurn), glm::vec3(0.0f, 1.0f, 0.0f),
                                     glm::vec3(kTurn, 0.0f, kTurn))};
    }

    /// Where the view axis is at the distance, along an axis of the object: a whole number.
    double objectPlace(int axis) const {
        const glm::dvec3 column(instances.basis[0][axis]);
        const glm::dvec3 away = -kViewDistance * frame.camera.back - instances.position(0);
        return std::round(glm::dot(away, column) / glm::dot(column, column));
    }

    void setTriangle(const std::array<glm::dvec3, 3>& corners) {
        constexpr std::uint32_t kNone = measure::MeshOutline::kNoNeighbour;
        outline.positions.assign(corners.begin(), corners.end());
        outline.faces = {{.corners = {0, 1, 2}, .neighbours = {kNone, kNone, kNone}}};
        for (const glm::dvec3& corner : corners) {
            outline.reach = glm::max(outline.reach, glm::abs(corner));
        }
    }

    ScreenTriangle placed() const {
        const auto bound = measure::DeviceBound::ofFloat64(frame);
        measure::InstanceTriangles triangles(frame.camera, kPictureSide, kPictureSide, bound, bound);
        return triangles.of(instances, 0, outline, {}, measure::Sidedness::both).at(0);
    }

    Exact exactPlace(std::size_t corner) const {
        return Exact(instances.position(0)) +
               ExactMatrix(glm::dmat3(instances.basis[0])) * Exact(outline.positions[corner]);
    }

    /// Of the triangle's plane, along the ray of a pixel.
    double exactDistance(std::uint32_t x, std::uint32_t y) const {
        const measure::PixelSlopes slopes = measure::pixelSlopes(frame.camera, kPictureSide, kPictureSide);
        const Exact ray = -Exact(frame.camera.back) +
                          Exact(frame.camera.right) * static_cast<long double>(slopes.x[x]) +
                          Exact(frame.camera.up) * static_cast<long double>(slopes.y[y]);
        const Exact a = exactPlace(0);
        const Exact normal = glm::cross(exactPlace(1) - a, exactPlace(2) - a);
        return static_cast<double>(glm::dot(normal, a) / glm::dot(normal, ray));
    }

    glm::dvec2 exactPixel(std::size_t corner) const {
        const Exact place = exactPlace(corner);
        const long double ahead = -glm::dot(Exact(frame.camera.back), place);
        const long double scale = 0.5L * kPictureSide / std::tan(0.5L * frame.camera.fovY) / ahead;
        const long double middle = 0.5L * (kPictureSide - 1);
        return {static_cast<double>(middle + scale * glm::dot(Exact(frame.camera.right), place)),
                static_cast<double>(middle - scale * glm::dot(Exact(frame.camera.up), place))};
    }
};

/// A face of a finely cut wall that lies across the view, whose middle is far to the side.
TEST(ScreenTriangle, ItsDistanceIsWithinItsBoundHoweverFarAnObjectsMiddleIsToTheSide) {
    for (const double aside : {1e4, 1e5, 1e6, 1e7}) {
        for (int i = 0; i < 200; ++i) {
            TurnedView view({-0.7071 * aside - 0.123 * i, 0.3, 0.7071 * aside + 14.1421356 + 0.077 * i});
            const double x = view.objectPlace(0);
            view.setTriangle(
                {glm::dvec3(x - 8.0, -8.0, 0.0), glm::dvec3(x + 8.0, -8.0, 0.0), glm::dvec3(x, 8.0, 0.0)});
            const ScreenTriangle placed = view.placed();
            ASSERT_FALSE(placed.isThin);
            const std::uint32_t column = kPictureSide / 2 - 1;
            const std::uint32_t row = kPictureSide / 2;
            const double w = 1.0 / (placed.inverse[0] + placed.inverse[1] * column + placed.inverse[2] * row);
            const double slope = w * w * (std::abs(placed.inverse[1]) + std::abs(placed.inverse[2]));
            const double bound = measure::DeviceBound::surfaceView(placed.bound, w, slope);
            ASSERT_LE(std::abs(w - view.exactDistance(column, row)), bound) << aside << " " << i;
            ASSERT_LT(bound, 1e-11 + 1e-14 * aside) << "and no wider than it need be";
        }
    }
}

/// A narrow beam along the view whose middle is far ahead, and whose face is near.
TEST(ScreenTriangle, ItsCornersAreWithinTheirBoundHoweverFarAnObjectsMiddleIsAhead) {
    for (const double ahead : {1e6, 1e7}) {
        for (int i = 0; i < 200; ++i) {
            const double x = 0.7071 * ahead + 0.123 * i;
            TurnedView view({x, 0.0, x + 1e-3 * (i % 7)});
            const double z = view.objectPlace(2);
            view.setTriangle(
                {glm::dvec3(-1e-3, -1e-3, z), glm::dvec3(1e-3, -1e-3, z), glm::dvec3(0.0, 1e-3, z)});
            const ScreenTriangle placed = view.placed();
            for (std::size_t corner = 0; corner < 3; ++corner) {
                // The order may have been turned.
                double nearest = 1.0;
                for (const glm::dvec2& pixel : placed.corners) {
                    const glm::dvec2 off = glm::abs(pixel - view.exactPixel(corner));
                    nearest = std::min(nearest, std::max(off.x, off.y));
                }
                ASSERT_LE(nearest, placed.bound.pixels) << ahead << " " << i;
                ASSERT_LT(placed.bound.pixels, 1e-12 * ahead) << "and no wider than it need be";
            }
        }
    }
}

} // namespace
} // namespace cdr::test
