#include <cdr/base/error.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/camera_path.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace cdr::scene {

namespace {

void expectSameView(const Camera& a, const Camera& b) {
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.right, b.right);
    EXPECT_EQ(a.up, b.up);
    EXPECT_EQ(a.back, b.back);
    EXPECT_EQ(a.fovY, b.fovY);
}

/// Cameras near the origin and up to 10^12 away, in all directions.
class Cameras {
  public:
    glm::dvec3 point(double scale) {
        const double x = uniform();
        const double y = uniform();
        const double z = uniform();
        return scale * glm::dvec3(x, y, z);
    }
    double uniform() { return 2.0 * (static_cast<double>(m_random() >> 11) * 0x1p-53) - 1.0; }
    double scale() { return std::pow(10.0, 6.0 + 6.0 * uniform()); }

  private:
    std::mt19937_64 m_random{7};
};

TEST(LookAlong, GivesLookAtCamerasBackToTheBit) {
    Cameras cameras;
    for (int i = 0; i < 20'000; ++i) {
        const double scale = cameras.scale();
        const glm::dvec3 eye = cameras.point(scale);
        const Camera camera = lookAt({}, eye, eye + cameras.point(scale));
        expectSameView(lookAlong(camera, camera.position, -camera.back), camera);
        ASSERT_TRUE(isLevel(camera));
    }
}

TEST(LookAt, TakesPointsThatAreVeryCloseOrFarApart) {
    for (const double distance : {1e-320, 1e-170, 1.0, 1e170, 1e300}) {
        const Camera camera = lookAt({}, glm::dvec3(0.0), {0.0, 0.0, distance});
        EXPECT_EQ(camera.back, glm::dvec3(0.0, 0.0, -1.0)) << distance;
    }
    EXPECT_THROW(lookAt({}, glm::dvec3(1.0), glm::dvec3(1.0)), base::InputError);
    EXPECT_THROW(lookAt({}, glm::dvec3(1.0), glm::dvec3(1.0, NAN, 1.0)), base::InputError);
}

TEST(LookAlong, KeepsTheDirectionWhereATargetLosesIt) {
    const Camera camera = lookAt({}, glm::dvec3(0.0), glm::dvec3(0.3, -0.2, -1.0));
    const glm::dvec3 eye(1e8, 2e8, -3e8);
    const Camera along = lookAlong(camera, eye, -camera.back);
    EXPECT_EQ(along.back, camera.back);
    const Camera at = lookAt(camera, eye, eye - camera.back); // what --target would do
    EXPECT_GT(glm::distance(at.back, camera.back), 1e-9);
}

TEST(LookAlong, TakesVectorsOfAnyLength) {
    const Camera unit = lookAlong({}, {1.0, 2.0, 3.0}, glm::normalize(glm::dvec3(1.0, -2.0, 0.5)));
    for (const double length : {1e-300, 1e-9, 3.0, 1e9, 1e300}) {
        const Camera camera = lookAlong({}, {1.0, 2.0, 3.0}, length * glm::dvec3(1.0, -2.0, 0.5));
        EXPECT_NEAR(glm::distance(camera.back, unit.back), 0.0, 1e-15) << length;
        EXPECT_NEAR(glm::length(camera.back), 1.0, 1e-15) << length;
    }
}

TEST(LookAlong, RollsToWhatIsUp) {
    const Camera camera = lookAlong({}, glm::dvec3(0.0), {0.0, 0.0, -1.0}, {1.0, 0.0, 0.4});
    EXPECT_NEAR(glm::distance(camera.up, glm::dvec3(1.0, 0.0, 0.0)), 0.0, 1e-15);
    EXPECT_NEAR(glm::distance(camera.right, glm::dvec3(0.0, -1.0, 0.0)), 0.0, 1e-15);
    EXPECT_FALSE(isLevel(camera));
}

TEST(LookAlong, StaysOrthonormalWhereUpIsAllButTheView) {
    for (double sine = 1.0; sine > 3e-9; sine *= 0.7) {
        const Camera camera =
            lookAlong({}, glm::dvec3(0.0), {0.48, 0.6, 0.64}, glm::dvec3(0.48, 0.6, 0.64 + sine));
        EXPECT_NEAR(glm::dot(camera.up, camera.back), 0.0, 1e-15) << sine;
        EXPECT_NEAR(glm::dot(camera.right, camera.back), 0.0, 1e-15) << sine;
        EXPECT_NEAR(glm::length(camera.right), 1.0, 1e-15) << sine;
        expectSameView(canonical(camera), camera);
    }
}

TEST(LookAlong, RefusesWhatHasNoDirection) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(lookAlong({}, glm::dvec3(0.0), glm::dvec3(0.0)), base::InputError);
    EXPECT_THROW(lookAlong({}, glm::dvec3(0.0), {0.0, infinity, 0.0}), base::InputError);
    EXPECT_THROW(lookAlong({}, {std::nan(""), 0.0, 0.0}, {0.0, 1.0, 0.0}), base::InputError);
    EXPECT_THROW(lookAlong({}, glm::dvec3(0.0), {0.0, 0.0, -1.0}, {0.0, 0.0, 2.0}), base::InputError);
    EXPECT_THROW(lookAlong({}, glm::dvec3(0.0), {0.0, 0.0, -1.0}, glm::dvec3(0.0)), base::InputError);
}

TEST(Canonical, IsIdempotentOrthonormalAndNear) {
    Cameras cameras;
    for (int i = 0; i < 20'000; ++i) {
        const Camera level = lookAt({}, glm::dvec3(0.0), cameras.point(1.0));
        Camera rolled = level;
        const double roll = 3.0 * cameras.uniform();
        rolled.right = std::cos(roll) * level.right + std::sin(roll) * level.up;
        rolled.up = std::cos(roll) * level.up - std::sin(roll) * level.right;
        rolled.fovY = std::pow(10.0, -2.5 + 2.5 * cameras.uniform());
        const Camera once = canonical(rolled);
        expectSameView(canonical(once), once);
        EXPECT_EQ(radiansOf(degreesOf(once.fovY)), once.fovY);
        EXPECT_NEAR(glm::distance(once.up, rolled.up), 0.0, 1e-15);
        EXPECT_NEAR(glm::distance(once.right, rolled.right), 0.0, 1e-15);
        EXPECT_NEAR(glm::dot(once.up, once.right), 0.0, 1e-15);
        EXPECT_NEAR(once.fovY / rolled.fovY, 1.0, 1e-15);
        ASSERT_FALSE(testing::Test::HasFailure()) << i;
    }
}

TEST(Canonical, LeavesLevelCamerasAlone) {
    Camera camera = lookAt({}, {1e7, 3.0, -2.0}, {0.0, 1.0, 5.0});
    camera.fovY = radiansOf(0.002);
    expectSameView(canonical(camera), camera);
}

TEST(Camera, IsRefusedWithAxesThatAreNotFinite) {
    EXPECT_NO_THROW(requireUsable(Camera{}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (glm::dvec3 Camera::*axis : {&Camera::right, &Camera::up, &Camera::back}) {
        Camera camera;
        (camera.*axis).y = nan;
        EXPECT_THROW(requireUsable(camera), base::InputError);
    }
}

/// Zero axes draw nothing, and longer ones another size. Those of an engine that computes in float32 are good enough.
TEST(Camera, IsRefusedWithALensTooNarrowForFloats) {
    Camera camera;
    camera.fovY = radiansOf(1e-28);
    EXPECT_NO_THROW(requireUsable(camera));
    for (const double degrees : {9e-29, 1e-36, 1e-300, 4.9e-324}) {
        camera.fovY = degrees / 57.0;
        EXPECT_THROW(requireUsable(camera), base::InputError) << degrees;
    }
}

TEST(Camera, IsRefusedWithAxesThatAreNotUnitOnes) {
    for (glm::dvec3 Camera::*axis : {&Camera::right, &Camera::up, &Camera::back}) {
        for (const double length : {0.0, 0.999, 1.001, 2.0}) {
            Camera camera;
            camera.*axis *= length;
            EXPECT_THROW(requireUsable(camera), base::InputError) << length;
        }
        Camera rounded = lookAlong({}, {}, {0.3, -0.2, -0.7}, {0.1, 0.9, 0.2});
        rounded.*axis = glm::dvec3(glm::vec3(rounded.*axis));
        EXPECT_NO_THROW(requireUsable(rounded));
    }
}

TEST(Camera, TakesTheEdgesOfALens) {
    const Camera camera = withLens({}, {.left = -1.25, .right = 0.75, .down = -0.5, .up = 1.0});
    EXPECT_DOUBLE_EQ(std::tan(0.5 * camera.fovY), 0.75);
    EXPECT_EQ(camera.lensShift, glm::dvec2(-0.25, 0.25));
    EXPECT_NO_THROW(requireUsable(camera));
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const LensEdges& edges : {LensEdges{.left = 1.0, .right = 1.0}, LensEdges{.left = 2.0},
                                   LensEdges{.down = 1.5}, LensEdges{.up = infinity}, LensEdges{.left = nan},
                                   LensEdges{.left = 9999.0, .right = 10001.0, .down = -1.0, .up = 1.0}}) {
        EXPECT_THROW(withLens({}, edges), base::InputError) << edges.left << " " << edges.up;
    }
}

TEST(Camera, IsRefusedWithALensThatIsShiftedTooFar) {
    Camera camera{.fovY = 1e-6};
    const double most = kMaxLensShift * std::tan(0.5e-6);
    for (const double shift : {0.0, most, -most}) {
        camera.lensShift = {shift, -shift};
        EXPECT_NO_THROW(requireUsable(camera)) << shift;
    }
    for (const double shift : {1.01 * most, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        camera.lensShift = {shift, 0.0};
        EXPECT_THROW(requireUsable(camera), base::InputError) << shift;
        camera.lensShift = {0.0, shift};
        EXPECT_THROW(requireUsable(camera), base::InputError) << shift;
    }
}

TEST(CameraPath, NeedsAFrame) {
    EXPECT_THROW(orbitPath({}, {}, 1.0, 0), base::InputError);
    EXPECT_THROW(turnPath({}, {}, 0), base::InputError);
    EXPECT_EQ(turnPath({}, {}, 1).at(7).back, turnPath({}, {}, 1).at(0).back);
}

TEST(Degrees, ComeBack) {
    Cameras cameras;
    for (int i = 0; i < 100'000; ++i) {
        const double degrees = std::pow(10.0, -0.5 + 2.5 * cameras.uniform());
        const double radians = radiansOf(degrees);
        ASSERT_EQ(radiansOf(degreesOf(radians)), radians) << degrees;
    }
    EXPECT_EQ(degreesOf(radiansOf(60.0)), 60.0);
}

} // namespace

} // namespace cdr::scene
