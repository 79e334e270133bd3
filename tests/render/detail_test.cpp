#include "../support/all_cases.h"
#include "../support/globe.h"
#include "fixture.h"
#include "snapping.h"

#include <cdr/measure/compare/cracks.h>
#include <cdr/scene/lod/clusters.h>
#include <cdr/scene/lod/levels.h>
#include <scenes/boulders.h>
#include <scenes/terrain.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace cdr::render_test {

namespace {

using visibility::Detail;
using visibility::DetailMode;

constexpr Detail kByObject{.mode = DetailMode::perObject, .pixels = 0.5};
constexpr Detail kByCascade{.mode = DetailMode::perCascade, .pixels = 0.5};

void addLevels(scene::Scene& scene) {
    platform::WorkerPool workers(2);
    scene::makeLevels(scene, workers);
}

scene::SceneSetup smallBoulders() {
    scene::SceneSetup setup = scenes::makeBoulders(2013, {.boulders = 80, .shapes = 3, .subdivisions = 4});
    addLevels(setup.scene);
    return setup;
}

render::RenderOptions optionsOf(const char* split, const Detail& detail) {
    return {.width = 320,
            .height = 180,
            .technique = depth::Technique{depth::Mapping::standard, depth::parseSplit(split),
                                          depth::DepthFormat::d32f},
            .detail = detail};
}

measure::SeenImage seenIn(const render::Frame& frame) {
    measure::SeenImage seen(frame.width(), frame.height());
    for (std::uint32_t y = 0; y < seen.height; ++y) {
        for (std::uint32_t x = 0; x < seen.width; ++x) {
            seen.at(x, y) = {.id = frame.id(x, y), .distanceView = frame.distanceView(x, y)};
        }
    }
    return seen;
}

class DetailRenderTest : public RenderTest {
  protected:
    /// Cracks that details open over cameras and splits.
    std::size_t hunt(const scene::Scene& scene, const std::vector<scene::Camera>& cameras,
                     const std::vector<Detail>& details) {
        const render::GpuScene gpuScene(device(), scene);
        std::size_t cracks = 0;
        for (const char* split : {"count:3", "count:6", "ratio:3"}) {
            render::Renderer whole(device(), scene, gpuScene, optionsOf(split, {}));
            std::vector<render::Frame> wanted;
            for (const scene::Camera& camera : cameras) {
                wanted.push_back(whole.render(camera));
            }
            for (const Detail& detail : details) {
                const auto reach = measure::kCrackReach + static_cast<std::uint32_t>(detail.pixels);
                render::Renderer coarse(device(), scene, gpuScene, optionsOf(split, detail));
                std::size_t coarser = 0;
                for (std::size_t i = 0; i < cameras.size(); ++i) {
                    const render::Frame shown = coarse.render(cameras[i]);
                    coarser += hashOf(shown) != hashOf(wanted[i]) ? 1 : 0;
                    cracks += measure::findCracks(seenIn(shown), seenIn(wanted[i]), reach).size();
                }
                // Where SwiftShader loses a floor, both are empty.
                EXPECT_GT(coarser, cameras.size() / 2) << split << " " << detail.pixels;
            }
        }
        return cracks;
    }
};

/// One boulder across many cascades, from all around.
scene::Scene largeBoulder() {
    scene::Scene scene = boxScene();
    scene.meshes = {scenes::makeBoulder(5, 5)};
    addBox(scene, glm::dvec3(0.0), glm::mat3(10.0f));
    return scene;
}

const scene::Scene& levelledBoulder() {
    static const scene::Scene scene = [] {
        scene::Scene made = largeBoulder();
        addLevels(made);
        return made;
    }();
    return scene;
}

/// From how many places cracks are looked for where there are none.
std::uint32_t placesOfHunt() {
    return test::takesAllCases() ? 8 : 4;
}

std::vector<scene::Camera> camerasAround(std::uint32_t count) {
    std::vector<scene::Camera> cameras;
    const scene::Camera lens{.fovY = 1.0, .nearView = 0.5, .farView = 1000.0};
    for (std::uint32_t i = 0; i < count; ++i) {
        const double turn = 0.7 * i;
        cameras.push_back(scene::lookAt(
            lens, (14.0 + 2.0 * i) * glm::dvec3(std::sin(turn), 0.4 * std::cos(2.0 * turn), std::cos(turn)),
            glm::dvec3(0.0)));
    }
    return cameras;
}

std::vector<scene::Camera> camerasAlong(const scene::CameraPath& path, std::uint32_t count) {
    std::vector<scene::Camera> cameras;
    for (std::uint32_t i = 0; i < count; ++i) {
        cameras.push_back(path.at(i * path.frames / count));
    }
    return cameras;
}

/// Of all ways to draw those that meet in pairs, or all with CDR_ALL_CASES.
TEST_F(DetailRenderTest, IsOneImageHoweverDrawn) {
    const scene::SceneSetup setup = smallBoulders();
    const scene::Camera camera = setup.path.at(100);
    const render::GpuScene gpuScene(device(), setup.scene);
    std::set<std::string> images;
    for (const Detail& detail : {kByObject, kByCascade}) {
        std::string wanted;
        std::size_t draws = 0;
        const auto expectSame = [&](const render::RenderOptions& options) {
            const render::Frame frame = draw(setup.scene, gpuScene, camera, options);
            wanted = wanted.empty() ? hashOf(frame) : wanted;
            draws = draws == 0 ? frame.stats.draws : draws;
            EXPECT_EQ(hashOf(frame), wanted)
                << nameOf(detail) << " " << nameOf(options.targets) << " " << nameOf(options.submission)
                << " " << nameOf(options.batching) << " " << options.threads;
            EXPECT_EQ(frame.stats.draws, draws);
        };
        render::RenderOptions options = quarterOf(optionsOf("count:5", detail));
        std::size_t turn = 0;
        for (const render::Submission submission : submissions()) {
            ++turn; // the other number of threads with the same targets
            for (const render::TargetsKind targets :
                 {render::TargetsKind::single, render::TargetsKind::accumulate, render::TargetsKind::pool,
                  render::TargetsKind::layers}) {
                for (const std::size_t threads : test::sampleOf(std::vector<std::size_t>{1, 3}, turn++)) {
                    options.submission = submission;
                    options.targets = targets;
                    options.threads = threads;
                    expectSame(options);
                }
            }
        }
        options.submission = render::Submission::secondaries;
        for (const render::Batching batching : render::kBatchings) {
            options.batching = batching;
            expectSame(options);
        }
        images.insert(wanted);
    }
    EXPECT_EQ(images.size(), 2u); // who decides does matter
}

/// With one kind of detail each, or both with CDR_ALL_CASES.
TEST_F(DetailRenderTest, TheGpuDrivenPathChoosesAlikeWithEveryTechnique) {
    if (!canDrawGpuDriven()) {
        return;
    }
    scene::SceneSetup setup = smallBoulders();
    // Neighbours that have nothing to choose stay one run among those that do.
    setup.scene.meshes[1].levels.clear();
    const render::GpuScene gpuScene(device(), setup.scene);
    std::size_t turn = 0;
    for (const auto& [name, technique] : depth::presets()) {
        for (const Detail& detail : test::sampleOf(std::vector{kByObject, kByCascade}, turn++)) {
            render::RenderOptions options = quarterOf(optionsOf("none", detail));
            options.technique = technique;
            render::Renderer host(device(), setup.scene, gpuScene, options);
            options.submission = render::Submission::gpuDriven;
            render::Renderer onDevice(device(), setup.scene, gpuScene, options);
            for (const std::uint32_t frame : {0u, 150u}) {
                const scene::Camera camera = setup.path.at(frame);
                EXPECT_EQ(hashOf(onDevice.render(camera)), hashOf(host.render(camera)))
                    << nameOf(technique) << " " << nameOf(detail);
            }
        }
    }
}

TEST_F(DetailRenderTest, LevelsNobodyAsksForChangeNoBit) {
    const scene::SceneSetup plain =
        scenes::makeBoulders(2013, {.boulders = 40, .shapes = 2, .subdivisions = 3});
    scene::Scene levelled = plain.scene;
    addLevels(levelled);
    const scene::Camera camera = plain.path.at(7);
    const render::RenderOptions options = optionsOf("count:4", {});
    EXPECT_EQ(hashOf(draw(levelled, camera, options)), hashOf(draw(plain.scene, camera, options)));
    EXPECT_EQ(hashOf(draw(plain.scene, camera, optionsOf("count:4", kByObject))),
              hashOf(draw(plain.scene, camera, options)));
}

TEST_F(DetailRenderTest, OneLevelPerObjectOpensNoCrack) {
    const scene::SceneSetup setup = smallBoulders();
    EXPECT_EQ(hunt(setup.scene, camerasAlong(setup.path, placesOfHunt()), {kByObject}), 0u);
    EXPECT_EQ(hunt(levelledBoulder(), camerasAround(placesOfHunt()),
                   {{.mode = DetailMode::perObject, .pixels = 2.0},
                    {.mode = DetailMode::perObject, .pixels = 4.0}}),
              0u);
}

/// The thesis' variant does crack where an object crosses a boundary. So the search does find cracks.
TEST_F(DetailRenderTest, OneLevelPerCascadeCracks) {
    EXPECT_GT(hunt(levelledBoulder(), camerasAround(8), {{.mode = DetailMode::perCascade, .pixels = 2.0}}),
              0u);
}

/// Pieces of one mesh share borders and are drawn at levels of their own.
TEST_F(DetailRenderTest, NeighbouringPiecesOfOtherLevelsMeet) {
    constexpr double kRadius = 1000.0;
    scene::Scene globe = test::makeGlobe({.radius = kRadius, .cells = 64, .pieceRadius = 150.0});
    addLevels(globe);
    std::vector<scene::Camera> cameras;
    for (int i = 0; i < 16; ++i) {
        const double around = 0.37 * i;
        const glm::dvec3 up =
            glm::normalize(glm::dvec3(std::sin(around), 0.3 * std::cos(3.0 * around), std::cos(around)));
        const glm::dvec3 along = glm::normalize(glm::cross(up, glm::dvec3(0.2, 1.0, 0.1)));
        const glm::dvec3 eye = (kRadius + 60.0 + 20.0 * i) * up;
        const scene::Camera lens{.fovY = 1.0, .nearView = 5.0, .farView = 3000.0};
        cameras.push_back(scene::lookAt(lens, eye, eye - 0.5 * up * kRadius + along * kRadius));
    }
    EXPECT_EQ(hunt(globe, cameras, {kByObject}), 0u);
}

TEST_F(DetailRenderTest, AnUnusableErrorIsRefused) {
    const scene::Scene scene = boxScene();
    for (const double pixels : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
        EXPECT_NE(refusalOf(scene, optionsOf("none", {.mode = DetailMode::perObject, .pixels = pixels})),
                  "none");
    }
}

/// Hills of 131,072 triangles with clusters.
const scene::SceneSetup& clusteredHills() {
    static const scene::SceneSetup setup = [] {
        scene::SceneSetup made = scenes::makeTerrain(2013, 256);
        platform::WorkerPool workers(2);
        scene::makeClusters(made.scene, workers);
        return made;
    }();
    return setup;
}

/// Of all ways to draw those that meet in pairs, or all with CDR_ALL_CASES.
TEST_F(DetailRenderTest, ClustersAreOneImageHoweverDrawn) {
    const scene::SceneSetup& setup = clusteredHills();
    const render::GpuScene gpuScene(device(), setup.scene);
    const Detail detail{.mode = DetailMode::perCluster, .pixels = 1.0};
    const std::vector<render::Submission> onHost{render::Submission::secondaries,
                                                 render::Submission::primaries};
    std::string wanted;
    std::size_t row = 0;
    for (const render::TargetsKind targets : {render::TargetsKind::single, render::TargetsKind::accumulate,
                                              render::TargetsKind::pool, render::TargetsKind::layers}) {
        std::size_t turn = row++;
        for (const std::size_t threads : {1u, 3u, 16u}) {
            for (const render::Submission submission : test::sampleOf(onHost, turn)) {
                for (const bool occlusionCulling : test::sampleOf(std::vector{false, true}, turn / 2)) {
                    render::RenderOptions options = quarterOf(optionsOf("count:5", detail));
                    options.submission = submission;
                    options.targets = targets;
                    options.threads = threads;
                    options.occlusionCulling = occlusionCulling;
                    render::Renderer renderer(device(), setup.scene, gpuScene, options);
                    renderer.render(setup.path.at(49));
                    const std::string image = hashOf(renderer.render(setup.path.at(50)));
                    wanted = wanted.empty() ? image : wanted;
                    EXPECT_EQ(image, wanted) << nameOf(options.targets) << " " << nameOf(submission) << " "
                                             << threads << " " << occlusionCulling;
                }
            }
            ++turn;
        }
    }
}

/// By how much the distance changes from a pixel to the next along x, and along y.
double slopeAt(const render::Frame& frame, std::uint32_t x, std::uint32_t y) {
    const double here = frame.distanceView(x, y);
    const auto step = [&](std::uint32_t column, std::uint32_t row) {
        return frame.id(column, row) == 0 ? 0.0 : std::abs(frame.distanceView(column, row) - here);
    };
    return std::max(step(std::max(x, 1u) - 1, y), step(std::min(x + 2, frame.width()) - 1, y)) +
           std::max(step(x, std::max(y, 1u) - 1), step(x, std::min(y + 2, frame.height()) - 1));
}

/// With no error allowed the clusters are the mesh, in another order: without cascades to the bit. Across cascades the whole
/// mesh is wide and cut per fragment, and most clusters are clipped, which rounds distances in another way. Where the device
/// rounds corners to sub-pixels, it rounds those that clipping makes too.
TEST_F(DetailRenderTest, TheFinestClustersAreThePictureInFull) {
    const scene::SceneSetup& setup = clusteredHills();
    const render::GpuScene gpuScene(device(), setup.scene);
    const double moved = 2.0 * snapReach(device());
    for (const char* split : {"none", "count:5", "ratio:3"}) {
        render::Renderer whole(device(), setup.scene, gpuScene, optionsOf(split, {}));
        render::Renderer clusters(device(), setup.scene, gpuScene,
                                  optionsOf(split, {.mode = DetailMode::perCluster, .pixels = 1e-9}));
        for (const std::uint32_t frame : {0u, 100u, 200u}) {
            const scene::Camera camera = setup.path.at(frame);
            const render::Frame wanted = whole.render(camera);
            const render::Frame shown = clusters.render(camera);
            EXPECT_TRUE(std::string(split) != "none" || hashOf(shown) == hashOf(wanted)) << frame;
            const auto pixels = shown.width() * shown.height();
            std::size_t others = 0;
            for (std::uint32_t i = 0; i < pixels; ++i) {
                const std::uint32_t x = i % shown.width();
                const std::uint32_t y = i / shown.width();
                const double apart = shown.distanceView(x, y) - wanted.distanceView(x, y);
                const bool isSame =
                    shown.id(x, y) == wanted.id(x, y) &&
                    (wanted.id(x, y) == 0 ||
                     std::abs(apart) <= 1e-5 * wanted.distanceView(x, y) + moved * slopeAt(wanted, x, y));
                others += isSame ? 0 : 1;
            }
            EXPECT_EQ(others, 0u) << split << " " << frame;
        }
    }
}

TEST_F(DetailRenderTest, ClustersOpenNoCracks) {
    const scene::SceneSetup& setup = clusteredHills();
    EXPECT_EQ(hunt(setup.scene, camerasAlong(setup.path, placesOfHunt()),
                   {{.mode = DetailMode::perCluster, .pixels = 4.0},
                    {.mode = DetailMode::perCluster, .pixels = 12.0}}),
              0u);
    scene::Scene boulder = largeBoulder();
    platform::WorkerPool workers(2);
    scene::makeClusters(boulder, workers);
    EXPECT_EQ(hunt(boulder, camerasAround(placesOfHunt()), {{.mode = DetailMode::perCluster, .pixels = 1.0}}),
              0u);
}

TEST_F(DetailRenderTest, ClustersAreRefusedGpuDriven) {
    const scene::SceneSetup& setup = clusteredHills();
    render::RenderOptions options = optionsOf("none", {.mode = DetailMode::perCluster});
    options.submission = render::Submission::gpuDriven;
    EXPECT_NE(refusalOf(setup.scene, options), "none");
}

} // namespace

} // namespace cdr::render_test
