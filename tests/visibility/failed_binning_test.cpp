#include "../support/allocations.h"

#include <cdr/visibility/bin_cells.h>
#include <scenes/cubes.h>

#include <gtest/gtest.h>

#include <limits>
#include <new>
#include <vector>

namespace {

using namespace cdr;
using namespace cdr::visibility;

/// Bins what a camera sees of a scene.
class FailedBinning : public testing::TestWithParam<std::size_t> {
  protected:
    void see(const scene::Scene& scene, const scene::Camera& camera) {
        m_cells.build(scene, m_workers);
        cullCells(m_cells, camera, scene::frustumOf(camera, 16.0, 9.0), m_workers, m_visible);
    }
    void bin(CellBinner& binner, DrawLists& lists) {
        binner.bin(m_visible, {{0.1, 60.0}, {60.0, 61.0}, {61.0, 1e5}},
                   std::numeric_limits<double>::infinity(), m_workers, lists);
        lists.instance.resize(lists.draws());
    }
    /// Whether it failed, at that allocation.
    bool binFails(CellBinner& binner, long allocation) {
        DrawLists lists;
        test::allocationsLeft = allocation;
        bool fails = false;
        try {
            bin(binner, lists);
        } catch (const std::bad_alloc&) {
            fails = true;
        }
        test::allocationsLeft = -1;
        return fails;
    }

    platform::WorkerPool m_workers{GetParam()};
    InstanceCells m_cells;
    VisibleCells m_visible;
};

/// Few are seen, and many; then a smaller scene, so that what was left would lie beyond it.
TEST_P(FailedBinning, LeavesNothingToLaterFrames) {
    const scene::SceneSetup large = scenes::makeRotation(9, 20'000);
    const scene::SceneSetup small = scenes::makeRotation(3, 5'000);
    std::size_t failures = 0;
    for (const double fovY : {0.2, 2.8}) {
        scene::Camera camera = large.path.at(0);
        camera.fovY = fovY;
        bool hasFailed = true;
        for (long allocation = 0; hasFailed; ++allocation) {
            CellBinner binner;
            see(large.scene, camera);
            hasFailed = binFails(binner, allocation);
            failures += hasFailed ? 1 : 0;
            see(small.scene, small.path.at(0));
            DrawLists lists;
            bin(binner, lists);
            CellBinner fresh;
            DrawLists expected;
            bin(fresh, expected);
            ASSERT_EQ(lists.begins, expected.begins) << allocation;
            ASSERT_EQ(lists.instance, expected.instance) << allocation;
        }
    }
    EXPECT_GT(failures, 20u);
}

INSTANTIATE_TEST_SUITE_P(Threads, FailedBinning, testing::Values(1, 3));

} // namespace
