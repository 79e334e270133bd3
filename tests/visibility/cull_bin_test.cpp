#include "flat_cull.h"

#include <cdr/depth/split.h>
#include <cdr/visibility/bin.h>
#include <cdr/visibility/cull.h>
#include <scenes/cubes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

using namespace cdr::scene;
using namespace cdr::scenes;
using namespace cdr::visibility;
using cdr::depth::Cascades;
using cdr::platform::WorkerPool;

constexpr double kAspect = 16.0 / 9.0;
constexpr double kNoWide = std::numeric_limits<double>::infinity();

/// Thesis Listing A.1, written out plane by plane and independent of the code under test.
bool isVisible(const Camera& camera, const glm::dvec3& centre, double radius) {
    const double tanY = std::tan(0.5 * camera.fovY);
    const double tanX = kAspect * tanY;
    const glm::dvec3 ahead = -camera.back;
    const glm::dvec3 normals[6] = {ahead,
                                   -ahead,
                                   glm::normalize(ahead * tanX - camera.right),
                                   glm::normalize(ahead * tanX + camera.right),
                                   glm::normalize(ahead * tanY - camera.up),
                                   glm::normalize(ahead * tanY + camera.up)};
    const double offsets[6] = {-camera.nearView, camera.farView, 0.0, 0.0, 0.0, 0.0};
    for (int i = 0; i < 6; ++i) {
        if (glm::dot(normals[i], centre - camera.position) + offsets[i] < -radius) {
            return false;
        }
    }
    return true;
}

class BinTest : public testing::TestWithParam<std::size_t> {};

TEST(Cull, KeepsWhatThePlanesKeep) {
    const SceneSetup setup = makeRotation(3, 40'000);
    for (const std::uint32_t frame : {0u, 45u, 100u, 300u}) {
        const Camera camera = setup.path.at(frame);
        const VisibleList visible = flatCull(setup.scene.instances, camera, frustumOf(camera, kAspect, 1.0));
        std::size_t next = 0;
        for (std::size_t i = 0; i < setup.scene.instances.size(); ++i) {
            const glm::dvec3 centre = setup.scene.instances.position(i);
            const bool kept = next < visible.count && visible.instance[next] == i;
            EXPECT_EQ(kept, isVisible(camera, centre, static_cast<double>(setup.scene.instances.radius[i])))
                << i;
            if (kept) {
                EXPECT_NEAR(visible.distanceView[next], camera.viewDistance(centre), 1e-9);
                ++next;
            }
        }
        EXPECT_EQ(next, visible.count);
        EXPECT_GT(visible.count, 1000u);
        EXPECT_LT(visible.count, 20'000u);
    }
}

TEST_P(BinTest, BinsEachInstanceIntoEveryCascadeItMeets) {
    const SceneSetup setup = makeRotation(4, 30'000);
    WorkerPool workers(GetParam());
    const Camera camera = setup.path.at(10);
    const VisibleList visible = flatCull(setup.scene.instances, camera, frustumOf(camera, kAspect, 1.0));
    const Cascades ranges{{0.1, 50.0}, {49.0, 120.0}, {120.0, 150.0}, {200.0, 1e5}};
    DrawLists lists;
    binByDistance(visible, ranges, kNoWide, workers, lists);
    ASSERT_EQ(lists.cascades(), ranges.size());
    std::size_t draws = 0;
    std::vector<bool> seen(setup.scene.instances.size());
    for (std::size_t c = 0; c < ranges.size(); ++c) {
        std::vector<std::uint32_t> expected;
        for (std::size_t i = 0; i < visible.count; ++i) {
            const double radius = static_cast<double>(visible.radius[i]);
            if (visible.distanceView[i] - radius <= ranges[c].farView &&
                visible.distanceView[i] + radius >= ranges[c].nearView) {
                expected.push_back(visible.instance[i]);
                seen[visible.instance[i]] = true;
            }
        }
        const auto range = lists.range(c);
        EXPECT_EQ(
            std::vector<std::uint32_t>(lists.instance.begin() + static_cast<std::ptrdiff_t>(range.begin),
                                       lists.instance.begin() + static_cast<std::ptrdiff_t>(range.end)),
            expected);
        EXPECT_EQ(lists.wideBegin(c), range.end);
        draws += expected.size();
    }
    EXPECT_EQ(lists.draws(), draws);
    EXPECT_EQ(lists.visible, static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true)));
    EXPECT_GT(lists.duplication(), 1.0);
}

INSTANTIATE_TEST_SUITE_P(Threads, BinTest, testing::Values(1, 2, 3, 8));

TEST(Bin, ListsWideInstancesLast) {
    VisibleList visible{.instance = {10, 11, 12, 13},
                        .distanceView = {5.0, 100.0, 0.5, 7.0},
                        .radius = {1, 1, 1, 0},
                        .count = 4};
    WorkerPool workers(1);
    DrawLists lists;
    binByDistance(visible, {{0.1, 1000.0}}, 0.1, workers, lists);
    EXPECT_EQ(lists.wideBegin(0), 2u);
    lists.instance.resize(lists.draws());
    EXPECT_EQ(lists.instance, (std::vector<std::uint32_t>{11, 13, 10, 12}));
}

/// Ranges are closed: what ends where the next begins is drawn in both.
TEST(Bin, PutsWhatTouchesABoundaryIntoBoth) {
    const VisibleList visible{.instance = {0, 1}, .distanceView = {10.0, 8.0}, .radius = {1, 1}, .count = 2};
    WorkerPool workers(1);
    DrawLists lists;
    binByDistance(visible, {{1.0, 9.0}, {9.0, 20.0}}, kNoWide, workers, lists);
    EXPECT_EQ(lists.range(0).size(), 2u);
    EXPECT_EQ(lists.range(1).size(), 2u);
}

TEST(Bin, AnEmptySceneGivesEmptyCascades) {
    WorkerPool workers(2);
    DrawLists lists;
    const VisibleList visible = flatCull(Instances{}, Camera{}, frustumOf(Camera{}, kAspect, 1.0));
    binByDistance(visible, {{0.1, 1.0}, {1.0, 2.0}}, kNoWide, workers, lists);
    EXPECT_EQ(lists.cascades(), 2u);
    EXPECT_EQ(lists.draws(), 0u);
    EXPECT_EQ(lists.duplication(), 1.0);
}

} // namespace
