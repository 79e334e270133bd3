#include <cdr/depth/make_cascades.h>
#include <cdr/scene/world/world.h>
#include <cdr/visibility/bin_cells.h>
#include <cdr/visibility/blended.h>
#include <scenes/cubes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <span>
#include <vector>

namespace {

using namespace cdr;
using namespace cdr::visibility;

constexpr double kNoWideSpan = std::numeric_limits<double>::infinity();

/// What a frame culls and bins with.
struct View {
    scene::Camera camera;
    depth::Cascades ranges;
    double wideSpan = kNoWideSpan;
};

/// Random scenes, cameras and edits, for one seed.
class RandomWorld {
  public:
    explicit RandomWorld(std::uint64_t seed) : m_random(seed) {}

    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }
    /// 0 to count - 1.
    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(m_random);
    }
    /// Over many scales, so that some are neighbours and some are alone, and some at one point.
    glm::dvec3 position() {
        const double size = std::pow(10.0, std::floor(uniform(-1.0, 7.0)));
        return below(20) == 0 ? glm::dvec3(5.0)
                              : size * glm::dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    }
    glm::mat3 basis() { return glm::mat3(static_cast<float>(std::pow(10.0, uniform(-2.0, 3.0)))); }

    scene::Scene scene(std::size_t instances) {
        scene::Scene scene;
        scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
        scene.materials.push_back({.name = "opaque"});
        scene.materials.push_back({.name = "glass", .alphaMode = scene::AlphaMode::blend});
        for (std::uint32_t i = 0; i < instances; ++i) {
            scene::addInstance(scene, 0, below(8) == 0 ? 1 : 0, i, position(), basis());
        }
        return scene;
    }
    scene::Camera camera() {
        scene::Camera camera{.fovY = uniform(0.01, 2.5),
                             .nearView = std::pow(10.0, uniform(-3.0, 1.0)),
                             .farView = std::pow(10.0, uniform(2.0, 8.0))};
        const glm::dvec3 eye = below(2) == 0 ? position() : glm::dvec3(0.0);
        return scene::lookAt(camera, eye, eye + glm::dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
    }
    depth::Cascades cascades(const scene::Camera& camera) {
        return depth::makeCascades(depth::SplitCount{static_cast<unsigned>(1 + below(6))},
                                   {.nearView = camera.nearView, .farView = camera.farView});
    }
    /// Infinity in one case of two.
    double wideSpan() { return below(2) == 0 ? kNoWideSpan : std::pow(10.0, uniform(-2.0, 2.0)); }

    View view() {
        const scene::Camera looking = camera();
        return {.camera = looking, .ranges = cascades(looking), .wideSpan = wideSpan()};
    }

    /// Moves a little or far, removes and adds, and changes materials. Returns what changed.
    std::vector<std::uint32_t> edit(scene::World& world, std::vector<scene::InstanceHandle>& handles,
                                    std::size_t edits) {
        const std::uint64_t before = world.changes().instances.end();
        for (std::size_t i = 0; i < edits; ++i) {
            const std::size_t which = below(handles.size());
            const scene::InstanceHandle handle = handles[which];
            switch (below(5)) {
            case 0:
                world.setTransform(handle, {.position = position(), .basis = basis()});
                break;
            case 1:
                world.removeInstance(handle);
                handles[which] = handles.back();
                handles.pop_back();
                break;
            case 2:
                handles.push_back(
                    world.addInstance({.mesh = world.mesh(0),
                                       .material = world.material(below(2)),
                                       .transform = {.position = position(), .basis = basis()}}));
                break;
            case 3:
                world.setMaterial(handle, world.material(below(2)));
                break;
            default:
                world.setTransform(handle, {.position = world.scene().instances.position(handle.index) + 0.01,
                                            .basis = world.scene().instances.basis[handle.index]});
            }
        }
        const auto changed = world.changes().instances.since(before);
        EXPECT_TRUE(changed.has_value());
        return {changed->begin(), changed->end()};
    }

  private:
    std::mt19937_64 m_random;
};

/// What the flat pass keeps, without what blends.
VisibleList flatOpaque(const scene::Scene& scene, const scene::Camera& camera,
                       const scene::Frustum& frustum) {
    std::vector<std::uint32_t> opaque;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        if (!isBlended(scene, i)) {
            opaque.push_back(i);
        }
    }
    VisibleList visible;
    cullSpheres(scene.instances, opaque, camera, frustum, visible);
    return visible;
}

std::vector<std::pair<double, double>> sortedPairs(const std::vector<depth::Interval>& intervals) {
    std::vector<std::pair<double, double>> pairs;
    for (const depth::Interval& interval : intervals) {
        pairs.emplace_back(interval.nearView, interval.farView);
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// With so many threads.
class CellsTest : public testing::TestWithParam<std::size_t> {
  protected:
    /// Lists, their order and all view distances, to the bit.
    void expectSame(const View& view, const scene::Scene& scene, const InstanceCells& cells) {
        const auto& [camera, ranges, wideSpan] = view;
        const scene::Frustum frustum = scene::frustumOf(camera, 16.0, 9.0);
        const VisibleList flat = flatOpaque(scene, camera, frustum);
        DrawLists expected;
        binByDistance(flat, ranges, wideSpan, m_workers, expected);

        VisibleCells visible;
        cullCells(cells, camera, frustum, m_workers, visible);
        DrawLists lists;
        m_binner.bin(visible, ranges, wideSpan, m_workers, lists);
        ASSERT_EQ(visible.count(), flat.count);
        ASSERT_EQ(lists.visible, expected.visible);
        ASSERT_EQ(lists.begins, expected.begins);
        lists.instance.resize(lists.draws());
        expected.instance.resize(expected.draws());
        ASSERT_EQ(lists.instance, expected.instance);

        std::vector<depth::Interval> intervals;
        appendIntervals(visible, intervals);
        std::vector<depth::Interval> flatIntervals;
        for (std::size_t i = 0; i < flat.count; ++i) {
            const auto radius = static_cast<double>(flat.radius[i]);
            flatIntervals.push_back({flat.distanceView[i] - radius, flat.distanceView[i] + radius});
        }
        ASSERT_EQ(sortedPairs(intervals), sortedPairs(flatIntervals));
        m_compared.visible += flat.count;
        m_compared.draws += lists.draws();
        for (std::size_t c = 0; c < lists.cascades(); ++c) {
            m_compared.wide += lists.range(c).end - lists.wideBegin(c);
        }
    }

    platform::WorkerPool m_workers{GetParam()};
    CellBinner m_binner;
    /// Adds up what was compared, so that a test can say that it was enough.
    struct {
        std::size_t visible = 0;
        std::size_t draws = 0;
        std::size_t wide = 0;
    } m_compared;
};

TEST_P(CellsTest, GiveTheListsOfTheFlatPass) {
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        RandomWorld random(seed);
        const scene::Scene scene = random.scene(seed == 0 ? 0 : 1 + random.below(seed % 2 == 0 ? 100 : 9000));
        InstanceCells cells;
        cells.build(scene, m_workers);
        for (int camera = 0; camera < 12; ++camera) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << ", camera " << camera);
            ASSERT_NO_FATAL_FAILURE(expectSame(random.view(), scene, cells));
        }
    }
    EXPECT_GT(m_compared.visible, 10'000u);
    EXPECT_GT(m_compared.draws, m_compared.visible);
    EXPECT_GT(m_compared.wide, 100u);
}

/// One walk for several cameras gives each the list that it gets alone, its order included.
TEST_P(CellsTest, CamerasThatCullTogetherSeeWhatEachSeesAlone) {
    std::size_t parts = 0;
    std::size_t unlikeFirst = 0;
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        RandomWorld random(seed);
        const scene::Scene scene = random.scene(1 + random.below(9000));
        InstanceCells cells;
        cells.build(scene, m_workers);
        std::vector<SphereTest> tests;
        std::vector<VisibleCells> together(seed % 2 == 0 ? 2 : 1 + random.below(kMaxTogether));
        std::vector<VisibleCells*> lists;
        for (VisibleCells& list : together) {
            const scene::Camera camera = random.camera();
            tests.emplace_back(camera, scene::frustumOf(camera, 16.0, 9.0));
            lists.push_back(&list);
        }
        cullCells(cells, tests, m_workers, lists);
        for (std::size_t camera = 0; camera < tests.size(); ++camera) {
            VisibleCells alone;
            std::vector<VisibleCells*> one{&alone};
            cullCells(cells, std::span(&tests[camera], 1), m_workers, one);
            ASSERT_EQ(together[camera].parts.size(), alone.parts.size());
            for (std::size_t i = 0; i < alone.parts.size(); ++i) {
                ASSERT_EQ(together[camera].parts[i].cell, alone.parts[i].cell);
                ASSERT_EQ(together[camera].parts[i].slots, alone.parts[i].slots);
            }
            parts += alone.parts.size();
            unlikeFirst += alone.count() != together.front().count() ? 1 : 0;
        }
    }
    EXPECT_GT(parts, 1000u);
    EXPECT_GT(unlikeFirst, 20u);
}

TEST_P(CellsTest, FollowEdits) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        RandomWorld random(seed);
        scene::World world(random.scene(500 + random.below(3000)));
        std::vector<scene::InstanceHandle> handles;
        for (std::size_t i = 0; i < world.scene().instances.size(); ++i) {
            handles.push_back(world.instance(i));
        }
        InstanceCells cells;
        cells.build(world.scene(), m_workers);
        for (int step = 0; step < 40; ++step) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << ", step " << step);
            const std::vector<std::uint32_t> changed = random.edit(world, handles, 1 + random.below(400));
            cells.update(world.scene(), changed, m_workers);
            ASSERT_NO_FATAL_FAILURE(expectSame(random.view(), world.scene(), cells));
            if (step % 10 == 9) { // from a scene with free places
                InstanceCells anew;
                anew.build(world.scene(), m_workers);
                ASSERT_NO_FATAL_FAILURE(expectSame(random.view(), world.scene(), anew));
            }
        }
    }
    EXPECT_GT(m_compared.visible, 10'000u);
}

/// Enough for many jobs, for boxes whose cells all land alike, and for lists sorted by every digit.
TEST_P(CellsTest, GiveTheListsOfALargeField) {
    const scene::SceneSetup setup = scenes::makeRotation(9, 150'000);
    InstanceCells cells;
    cells.build(setup.scene, m_workers);
    for (const double fovY : {0.3, 0.6, 1.0, 2.8}) {
        for (const std::uint32_t frame : {0u, 40u, 200u}) {
            View view{.camera = setup.path.at(frame), .ranges = {}};
            view.camera.fovY = fovY;
            view.ranges = frame == 0 ? depth::Cascades{{0.1, 60.0}, {60.0, 61.0}, {61.0, 150.0}, {150.0, 1e5}}
                                     : depth::Cascades{{0.1, 100.0}, {100.0, 1e5}};
            SCOPED_TRACE(testing::Message() << "field of view " << fovY << ", frame " << frame);
            ASSERT_NO_FATAL_FAILURE(expectSame(view, setup.scene, cells));
        }
    }
    EXPECT_GT(m_compared.visible, 100'000u);
}

TEST_P(CellsTest, GrowFromNothing) {
    RandomWorld random(3);
    scene::World world(random.scene(0));
    InstanceCells cells;
    cells.build(world.scene(), m_workers);
    for (int step = 0; step < 60; ++step) {
        std::vector<std::uint32_t> changed;
        for (std::size_t i = 0; i < 100; ++i) {
            changed.push_back(
                world
                    .addInstance({.mesh = world.mesh(0),
                                  .material = world.material(0),
                                  .transform = {.position = random.position(), .basis = random.basis()}})
                    .index);
        }
        cells.update(world.scene(), changed, m_workers);
        ASSERT_NO_FATAL_FAILURE(expectSame(random.view(), world.scene(), cells));
    }
    EXPECT_GT(m_compared.visible, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Threads, CellsTest, testing::Values(1, 2, 5));

/// Every instance is held once, and every box encloses what it holds.
TEST(Cells, HoldEachOpaqueInstanceOnce) {
    platform::WorkerPool workers(2);
    RandomWorld random(5);
    const scene::Scene scene = random.scene(70'000); // more than one worker's share is sorted
    InstanceCells cells;
    cells.build(scene, workers);
    std::vector<int> times(scene.instances.size());
    for (std::size_t cell = 0; cell < cells.cells(); ++cell) {
        for (std::size_t slot = 0; slot < InstanceCells::kCellSlots; ++slot) {
            if ((cells.held(cell) >> slot & 1) == 0) {
                continue;
            }
            const std::uint32_t instance = cells.instancesOf(cell)[slot];
            ++times[instance];
            std::size_t node = cell;
            for (const std::vector<InstanceCells::Box>& level : cells.levels()) {
                const InstanceCells::Box& box = level[node];
                const glm::dvec3 at = scene.instances.position(instance);
                EXPECT_TRUE(glm::all(glm::lessThanEqual(box.low, at)) &&
                            glm::all(glm::lessThanEqual(at, box.high)));
                EXPECT_GE(box.radius, static_cast<double>(scene.instances.radius[instance]));
                node /= InstanceCells::kFan;
            }
        }
    }
    for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_EQ(times[i], isBlended(scene, i) ? 0 : 1) << i;
    }
    EXPECT_EQ(cells.levels().size(), 3u);
    EXPECT_LE(cells.levels().back().size(), InstanceCells::kFan);
}

TEST(Cells, AreTheSameForEveryNumberOfWorkers) {
    const scene::Scene scene = scenes::makeRotation(1, 100'000).scene;
    platform::WorkerPool one(1);
    platform::WorkerPool many(6);
    InstanceCells a;
    InstanceCells b;
    a.build(scene, one);
    b.build(scene, many);
    ASSERT_EQ(a.cells(), b.cells());
    for (std::size_t cell = 0; cell < a.cells(); ++cell) {
        ASSERT_EQ(a.held(cell), b.held(cell));
        ASSERT_TRUE(std::equal(a.instancesOf(cell), a.instancesOf(cell) + InstanceCells::kCellSlots,
                               b.instancesOf(cell)));
    }
}

/// The tree is for this: if a part of a field is in view, only cells at the frustum's sides are examined.
TEST(Cells, AreLookedIntoWhereTheFrustumsSidesPass) {
    const scene::SceneSetup setup = scenes::makeRotation(1, 100'000);
    scene::Camera camera = setup.path.at(0);
    camera.fovY = 0.3;
    platform::WorkerPool workers(1);
    InstanceCells cells;
    cells.build(setup.scene, workers);
    VisibleCells visible;
    cullCells(cells, camera, scene::frustumOf(camera, 16.0, 9.0), workers, visible);
    EXPECT_GT(visible.count(), 500u);
    EXPECT_LT(visible.parts.size(), cells.cells() / 8);
}

/// Moves within a cell keep it. A scene whose instances have moved far is sorted again, so the tree stays useful.
TEST(Cells, AreBuiltAnewWhereMuchHasLeftThem) {
    scene::SceneSetup setup = scenes::makeRotation(1, 20'000);
    platform::WorkerPool workers(1);
    InstanceCells cells;
    cells.build(setup.scene, workers);
    const std::size_t built = cells.cells();
    std::vector<std::uint32_t> all(setup.scene.instances.size());
    std::iota(all.begin(), all.end(), 0u);
    const auto moveAll = [&](const auto& way) {
        for (double& x : setup.scene.instances.x) {
            x = way(x);
        }
        cells.update(setup.scene, all, workers);
    };
    moveAll([](double x) { return x + 0.1; });
    EXPECT_EQ(cells.cells(), built);
    moveAll([](double x) { return -x; });
    EXPECT_EQ(cells.cells(), built) << "nothing may change afterwards";
    moveAll([](double x) { return -x; });
    EXPECT_GT(cells.cells(), built) << "sorting each time takes longer";
    bool wasBuiltAnew = false;
    for (int i = 0; i < 100; ++i) {
        moveAll([](double x) { return -x; });
        wasBuiltAnew = wasBuiltAnew || cells.cells() == built;
    }
    EXPECT_TRUE(wasBuiltAnew);
}

} // namespace
