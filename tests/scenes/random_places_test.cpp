#include <scenes/alley.h>
#include <scenes/boulders.h>
#include <scenes/sheets.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace cdr::scenes {
namespace {

glm::dvec3 sumOfPlaces(const scene::SceneSetup& setup) {
    glm::dvec3 sum{};
    for (std::size_t i = 0; i < setup.scene.instances.size(); ++i) {
        sum += setup.scene.instances.position(i);
    }
    return sum;
}

void expectSum(const glm::dvec3& sum, const glm::dvec3& expected) {
    EXPECT_LT(glm::distance(sum, expected), 1e-9 * glm::length(expected))
        << fmt::format("{}, {}, {}", sum.x, sum.y, sum.z);
}

/// Compilers differ in the order in which they evaluate arguments.
TEST(RandomPlaces, AreTheSameWhicheverCompilerBuiltThem) {
    expectSum(sumOfPlaces(makeAlley(2013)), {0.194441027, 116.684459979, -192121.935507202});
    expectSum(sumOfPlaces(makeBoulders(2013, {.boulders = 3, .subdivisions = 1})),
              {-75.014287453, 16.513299259, -139.056581749});
    expectSum(sumOfPlaces(makeSheets(2013)), {146040.543974, -222117.972648, -5296957.331951});
}

} // namespace
} // namespace cdr::scenes
