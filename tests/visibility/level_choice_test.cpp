#include "flat_cull.h"

#include <cdr/base/error.h>
#include <cdr/scene/lod/levels.h>
#include <cdr/visibility/level_choice.h>
#include <scenes/boulders.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace {

using namespace cdr::scene;
using namespace cdr::scenes;
using namespace cdr::visibility;
using cdr::base::InputError;
using cdr::depth::Cascades;

constexpr double kNoneWide = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kHeight = 720;

struct Listed {
    VisibleList visible;
    DrawLists lists;
};

Listed listed(const Scene& scene, const Camera& camera, const Cascades& ranges, const Detail& detail,
              std::size_t threads) {
    Listed result;
    cdr::platform::WorkerPool workers(threads);
    const Frustum frustum = frustumOf(camera, kHeight * 16.0 / 9.0, kHeight);
    result.visible = flatCull(scene.instances, camera, frustum);
    binByDistance(result.visible, ranges, kNoneWide, workers, result.lists);
    chooseLevels(scene, camera, ranges, levelRule(detail, frustum), workers, result.lists);
    return result;
}

SceneSetup levelled() {
    SceneSetup setup = makeBoulders(2, {.boulders = 200, .shapes = 2, .subdivisions = 3});
    cdr::platform::WorkerPool workers(2);
    makeLevels(setup.scene, workers);
    return setup;
}

const Cascades kRanges{{0.5, 20.0}, {20.0, 200.0}, {200.0, 1000.0}, {1000.0, 10'000.0}};

/// Largest error on screen of what is drawn at a view distance, in pixels at the middle of the picture.
double pixelsOf(const Scene& scene, const Camera& camera, std::uint32_t instance, std::size_t level,
                double distanceView) {
    const Mesh& mesh = scene.meshes[scene.instances.mesh[instance]];
    const double scale =
        static_cast<double>(scene.instances.radius[instance]) / static_cast<double>(mesh.boundingRadius);
    const double error = level == 0 ? 0.0 : static_cast<double>(mesh.levels[level - 1].error) * scale;
    return error / distanceView * 0.5 * kHeight / std::tan(0.5 * camera.fovY);
}

class DetailTest : public testing::TestWithParam<std::size_t> {};

TEST_P(DetailTest, AnObjectHasTheCoarsestLevelThatMayBe) {
    const SceneSetup setup = levelled();
    const Scene& scene = setup.scene;
    const Camera camera = setup.path.at(30);
    const Detail detail{.mode = DetailMode::perObject, .pixels = 0.7};
    const Listed made = listed(scene, camera, kRanges, detail, GetParam());
    std::set<std::size_t> seen;
    ASSERT_GT(made.lists.draws(), 100u);
    for (std::size_t draw = 0; draw < made.lists.draws(); ++draw) {
        const std::uint32_t instance = made.lists.instance[draw];
        const std::size_t level = made.lists.level[draw];
        const double w = camera.viewDistance(scene.instances.position(instance));
        const double nearest =
            std::max(w - static_cast<double>(scene.instances.radius[instance]), camera.nearView);
        seen.insert(level);
        EXPECT_LE(pixelsOf(scene, camera, instance, level, nearest), 0.7 * (1.0 + 1e-9));
        if (level < scene.meshes[scene.instances.mesh[instance]].levels.size()) {
            EXPECT_GT(pixelsOf(scene, camera, instance, level + 1, nearest), 0.7 * (1.0 - 1e-9));
        }
    }
    EXPECT_GE(seen.size(), 4u);
}

TEST_P(DetailTest, AnObjectHasOneLevelInEveryCascade) {
    const SceneSetup setup = levelled();
    const Cascades thin{{0.5, 12.0}, {12.0, 14.0}, {14.0, 16.0}, {16.0, 100.0}, {100.0, 1e4}};
    const Listed made =
        listed(setup.scene, setup.path.at(0), thin, {.mode = DetailMode::perObject}, GetParam());
    std::vector<int> levels(setup.scene.instances.size(), -1);
    std::size_t again = 0;
    for (std::size_t draw = 0; draw < made.lists.draws(); ++draw) {
        int& level = levels[made.lists.instance[draw]];
        again += level >= 0 ? 1 : 0;
        EXPECT_TRUE(level < 0 || level == made.lists.level[draw]);
        level = made.lists.level[draw];
    }
    EXPECT_GE(again, 3u); // otherwise nothing straddles and this proves nothing
}

TEST_P(DetailTest, ACascadeDecidesByItsNearEnd) {
    const SceneSetup setup = levelled();
    const Camera camera = setup.path.at(0);
    const Listed made =
        listed(setup.scene, camera, kRanges, {.mode = DetailMode::perCascade, .pixels = 1.0}, GetParam());
    std::size_t coarse = 0;
    for (std::size_t cascade = 0; cascade < kRanges.size(); ++cascade) {
        for (std::size_t draw = made.lists.range(cascade).begin; draw < made.lists.range(cascade).end;
             ++draw) {
            const std::uint32_t instance = made.lists.instance[draw];
            const std::size_t level = made.lists.level[draw];
            const double nearView = kRanges[cascade].nearView;
            coarse += level > 0 ? 1 : 0;
            EXPECT_LE(pixelsOf(setup.scene, camera, instance, level, nearView), 1.0 + 1e-9);
            if (level < setup.scene.meshes[setup.scene.instances.mesh[instance]].levels.size()) {
                EXPECT_GT(pixelsOf(setup.scene, camera, instance, level + 1, nearView), 1.0 - 1e-9);
            }
        }
    }
    EXPECT_GT(coarse, 50u);
}

INSTANTIATE_TEST_SUITE_P(Threads, DetailTest, testing::Values(1, 3));

TEST(Detail, NoneLeavesNoLevelsBehind) {
    const SceneSetup setup = levelled();
    const Camera camera = setup.path.at(0);
    Listed made = listed(setup.scene, camera, kRanges, {.mode = DetailMode::perObject}, 1);
    const std::uint64_t saved = trianglesDrawn(setup.scene, made.lists);
    cdr::platform::WorkerPool workers(1);
    chooseLevels(setup.scene, camera, kRanges, {}, workers, made.lists);
    EXPECT_TRUE(made.lists.level.empty());
    EXPECT_EQ(trianglesDrawn(setup.scene, made.lists), made.lists.draws() * 20 * 64);
    EXPECT_LT(saved, made.lists.draws() * 20 * 16);
}

TEST(Detail, NamesAreReadBack) {
    EXPECT_EQ(parseDetail("none").mode, DetailMode::none);
    EXPECT_EQ(parseDetail("object").mode, DetailMode::perObject);
    EXPECT_EQ(parseDetail("object").pixels, 0.5);
    EXPECT_EQ(parseDetail("cascade:2.5").mode, DetailMode::perCascade);
    EXPECT_EQ(parseDetail("cluster:1").mode, DetailMode::perCluster);
    EXPECT_EQ(parseDetail("cascade:2.5").pixels, 2.5);
    EXPECT_EQ(nameOf(parseDetail("cascade:2.5")), "cascade:2.5");
    EXPECT_EQ(nameOf(parseDetail("none")), "none");
    for (const char* text : {"", "objects", "none:1", "object:", "object:0", "object:-1", "object:nan",
                             "object:inf", "cascade:1x", "object:1:2"}) {
        EXPECT_THROW(parseDetail(text), InputError) << text;
    }
}

TEST(Boulders, AreManyApartAndInView) {
    const SceneSetup setup = makeBoulders(2013);
    const Instances& instances = setup.scene.instances;
    ASSERT_EQ(instances.size(), 200u);
    const Camera camera = setup.path.at(0);
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const double w = camera.viewDistance(instances.position(i));
        EXPECT_GE(w, 8.0 - 1e-9);
        EXPECT_LE(w, 4000.0 + 1e-9);
        for (std::size_t j = 0; j < i; ++j) {
            EXPECT_GT(glm::distance(instances.position(i), instances.position(j)),
                      static_cast<double>(instances.radius[i] + instances.radius[j]));
        }
    }
    for (const Mesh& mesh : setup.scene.meshes) {
        EXPECT_EQ(mesh.indices.size() / 3, 20'480u);
        for (const Vertex& vertex : mesh.vertices) {
            EXPECT_LE(glm::length(vertex.position), mesh.boundingRadius);
            EXPECT_NEAR(glm::length(vertex.normal), 1.0f, 1e-5f);
        }
    }
    EXPECT_THROW(makeBoulders(1, {.boulders = 1001}), InputError);
    EXPECT_THROW(makeBoulders(1, {.shapes = 0}), InputError);
    EXPECT_THROW(makeBoulder(1, 9), InputError);
}

} // namespace
