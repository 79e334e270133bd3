#include <cdr/measure/truth/truth_air.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cdr::measure {

namespace {

constexpr double kRadius = 6.4e6;
constexpr double kHeight = 8e3;
constexpr double kScattering = 1e-5;

/// A sphere about the origin with air of one part, whose light the Sun sends from straight above the ground at (0, kRadius, 0).
scene::Scene plainAir() {
    scene::Scene scene;
    scene.background = glm::vec3(1.0f);
    scene.air =
        scene::Air{.radius = kRadius,
                   .sunlight = glm::vec3(0.0f),
                   .molecules = {.scattering = glm::vec3(static_cast<float>(kScattering)), .height = kHeight},
                   .haze = {}};
    return scene;
}

double passedAlong(const scene::Scene& scene, const glm::dvec3& eye, const glm::dvec3& direction) {
    return backgroundAlong(scene, eye, direction).g;
}

TEST(TruthAir, TakesWhatAColumnTakes) {
    const scene::Scene scene = plainAir();
    const double whole = std::exp(-kScattering * kHeight);
    EXPECT_NEAR(passedAlong(scene, {0.0, kRadius, 0.0}, {0.0, 1.0, 0.0}), whole, 1e-4);
    EXPECT_NEAR(passedAlong(scene, {0.0, 2.0 * kRadius, 0.0}, {0.0, -3.0, 0.0}), whole, 1e-4)
        << "to the ground";
    const double half = std::exp(-kScattering * kHeight * 0.5);
    const double halfUp = kHeight * std::log(2.0);
    EXPECT_NEAR(passedAlong(scene, {0.0, kRadius + halfUp, 0.0}, {0.0, 1.0, 0.0}), half, 1e-4);
    EXPECT_NEAR(throughAir(scene, {0.0, kRadius, 0.0}, {0.0, halfUp, 0.0}, glm::dvec3(1.0)).g, half, 1e-4);
}

/// Chapman's function of a level way is the root of half pi times the radius over the height, to a thousandth of it.
TEST(TruthAir, TakesWhatALevelWayTakes) {
    const scene::Scene scene = plainAir();
    const double lowest = 3e4;
    const double oneSide = kHeight * std::exp(-lowest / kHeight) *
                           std::sqrt(0.5 * std::numbers::pi * (kRadius + lowest) / kHeight);
    const double passed = std::exp(-2.0 * kScattering * oneSide);
    EXPECT_NEAR(passedAlong(scene, {-4e6, kRadius + lowest, 0.0}, {1.0, 0.0, 0.0}), passed, 1e-3);
    EXPECT_NEAR(passedAlong(scene, {0.0, kRadius + lowest, 0.0}, {1.0, 0.0, 0.0}), std::sqrt(passed), 1e-3);
    EXPECT_EQ(passedAlong(scene, {-4e6, kRadius + 2e5, 0.0}, {1.0, 0.0, 0.0}), 1.0) << "above the air";
}

/// Thin air adds what it takes, in the direction of the Sun more than across; behind the planet it adds nothing.
TEST(TruthAir, AddsSunlight) {
    scene::Scene scene = plainAir();
    scene.background = glm::vec3(0.0f);
    scene.air->sunlight = glm::vec3(1.0f);
    scene.air->molecules.scattering *= 1e-3f;
    const double taken = 1e-3 * kScattering * kHeight;
    EXPECT_NEAR(passedAlong(scene, {0.0, kRadius, 0.0}, {0.0, 1.0, 0.0}), 0.375 * taken, 1e-3 * taken);
    scene.air->toSun = {1.0, 0.0, 0.0};
    EXPECT_NEAR(passedAlong(scene, {0.0, kRadius, 0.0}, {0.0, 1.0, 0.0}), 0.1875 * taken, 5e-3 * taken);
    scene.air->toSun = {0.0, -1.0, 0.0};
    EXPECT_EQ(passedAlong(scene, {0.0, kRadius, 0.0}, {0.0, 1.0, 0.0}), 0.0);
}

TEST(TruthAir, AFlatPlanetIsASphereOnceStretched) {
    scene::Scene scene = plainAir();
    scene.air->flattening = 0.1;
    scene.air->axis = {0.0, 1.0, 0.0};
    // At the pole heights are stretched, and so the air there is thinner by as much.
    EXPECT_NEAR(passedAlong(scene, {0.0, 0.9 * kRadius, 0.0}, {0.0, 1.0, 0.0}),
                std::exp(-kScattering * kHeight * 0.9), 1e-4);
    EXPECT_NEAR(passedAlong(scene, {kRadius, 0.0, 0.0}, {1.0, 0.0, 0.0}), std::exp(-kScattering * kHeight),
                1e-4);
}

TEST(TruthAir, IsNothingWhereThereIsNone) {
    scene::Scene scene;
    scene.background = glm::vec3(0.25f);
    EXPECT_EQ(throughAir(scene, glm::dvec3(0.0), {1.0, 0.0, 0.0}, glm::dvec3(0.5)), glm::dvec3(0.5));
    EXPECT_EQ(passedAlong(scene, glm::dvec3(0.0), {1.0, 0.0, 0.0}), 0.25);
}

} // namespace

} // namespace cdr::measure
