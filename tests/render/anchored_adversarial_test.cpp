#include "../support/globe.h"
#include "../support/worst.h"
#include "fixture.h"
#include "snapping.h"

#include <cdr/scene/lod/triangle_clusters.h>
#include <scenes/cubes.h>
#include <scenes/mixed.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace cdr::render_test {

namespace {

using render::Frame;

/// Scenes made to break anchored depth, each against exact float64 rays; the fixture fails on any validation
/// message.
class AdversarialTest : public RenderTest {
  protected:
    struct Outcome {
        measure::WrongPixels wrong;
        double worstDistance =
            0.0; ///< of the frame's view distances, over inner pixels that show the right object
        std::size_t cascades = 0;
    };

    static render::RenderOptions anchored() { return smallOptions(depth::parseTechnique("anchored")); }

    static Outcome outcome(const Frame& frame, const measure::TruthImage& truth) {
        const auto inner = measure::innerMask(truth);
        Outcome result{.wrong = measure::countWrong(frame.ids(), truth), .cascades = frame.cascades.size()};
        for (std::uint32_t y = 0; y < frame.height(); ++y) {
            for (std::uint32_t x = 0; x < frame.width(); ++x) {
                if (inner.at(x, y) != 0 && truth.at(x, y).id != 0 && frame.id(x, y) == truth.at(x, y).id) {
                    result.worstDistance =
                        test::worseOf(result.worstDistance,
                                      std::abs(frame.distanceView(x, y) - truth.at(x, y).distanceView));
                }
            }
        }
        return result;
    }
};

TEST_F(AdversarialTest, ThousandsOfOverlappingIntervals) {
    scene::Scene scene = boxScene();
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    for (int i = 0; i < 6000; ++i) {
        // Each reaches into many others' distances, so that nothing is a gap and no cut is clean.
        const double w = std::pow(10.0, 3.0 + 3.0 * share(random));
        const double side = w * (0.02 + 0.02 * std::abs(share(random)));
        const double x = 1.1 * w * share(random);
        addBox(scene, {x, 0.6 * w * share(random), -w}, glm::mat3(static_cast<float>(side)));
    }
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 2e6};
    const auto truth = truthOf(scene, camera);
    for (const depth::Mapping mapping : {depth::Mapping::anchored, depth::Mapping::anchoredReversed}) {
        for (const char* split : {"fitted", "fitted:1e-7px", "fitted:0.001,max=64"}) {
            const auto technique =
                depth::Technique{mapping, depth::parseSplit(split), depth::DepthFormat::d32f};
            const Outcome result = outcome(draw(scene, camera, smallOptions(technique)), truth);
            EXPECT_GT(result.wrong.pixels, 5'000u);
            EXPECT_EQ(result.wrong.wrong, 0u) << nameOf(technique);
            EXPECT_GE(result.cascades, 2u);
        }
    }
}

TEST_F(AdversarialTest, ObjectsBehindAndAroundTheCamera) {
    if (!drawsToTheHorizon(device())) {
        return leaveOut("floors to the horizon");
    }
    scene::Scene scene = boxScene();
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    for (int i = 0; i < 400; ++i) {
        const double w = std::pow(10.0, 2.0 + 2.0 * share(random));
        addBox(scene, {share(random) * w, share(random) * w, w + 0.6}); // wholly behind
    }
    // From far behind to far ahead, on all four sides.
    for (const glm::dvec3 side :
         {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0)}) {
        glm::mat3 basis(2.0f);
        basis[2] *= 1e5f;
        addBox(scene, 3.0 * side, basis);
    }
    addBox(scene, {0.1, 0.2, -1e3}, glm::mat3(5.0f));
    addBox(scene, {0.1, 0.2, 1e3}, glm::mat3(5.0f));
    const scene::Camera camera{.fovY = 1.5, .nearView = 0.01, .farView = 1e6};
    const auto truth = truthOf(scene, camera);
    for (const depth::Mapping mapping : {depth::Mapping::anchored, depth::Mapping::anchoredReversed}) {
        const auto technique = depth::Technique{mapping, depth::SplitFitted{}, depth::DepthFormat::d32f};
        const measure::WrongPixels wrong =
            measure::countWrong(draw(scene, camera, smallOptions(technique)).ids(), truth);
        EXPECT_GT(wrong.pixels, 50'000u);
        EXPECT_EQ(wrong.wrong, 0u) << nameOf(technique);
    }
}

TEST_F(AdversarialTest, ASinglePointAndASpeckAMillionUnitsAway) {
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, 0.0, -1e6}, glm::mat3(1e-30f));
    const scene::Camera camera{.fovY = 4e-9, .nearView = 0.001, .farView = 2e6};
    const Frame point = draw(scene, camera, anchored());
    ASSERT_EQ(point.cascades.size(), 1u);
    EXPECT_GT(point.cascades[0].farView, point.cascades[0].nearView);
    EXPECT_TRUE(point.cascades[0].contains(1e6));
    // A cube of a millimetre, all there is.
    scene.instances = {};
    addBox(scene, {0.0, 0.0, -1e6}, glm::mat3(1e-3f));
    const Outcome speck = outcome(draw(scene, camera, anchored()), truthOf(scene, camera));
    EXPECT_GT(speck.wrong.pixels, 2'000u);
    EXPECT_EQ(speck.wrong.wrong, 0u);
    EXPECT_LT(speck.worstDistance, 1e-9);
}

TEST_F(AdversarialTest, EverythingAtOneDistance) {
    scene::Scene scene = boxScene();
    scene.meshes[0] = scene::makeBox(glm::vec3(0.5f, 0.5f, 1e-12f));
    for (int i = 0; i < 64; ++i) {
        addBox(scene, {1.5 * (i % 8) - 5.0, 1.5 * std::floor(i / 8) - 5.0, -1e6});
    }
    const scene::Camera camera{.fovY = 1.4e-5, .nearView = 0.001, .farView = 2e6};
    const auto truth = truthOf(scene, camera);
    render::RenderOptions options = anchored();
    for (const depth::DepthFormat format : available(depth::kDepthFormats)) {
        options.technique.format = format;
        const Outcome result = outcome(draw(scene, camera, options), truth);
        EXPECT_GT(result.wrong.pixels, 10'000u);
        EXPECT_EQ(result.wrong.wrong, 0u);
        EXPECT_LT(result.worstDistance, 1e-6);
        EXPECT_EQ(result.cascades, 1u);
    }
    // Near and far planes just around it.
    const scene::Camera hair{.fovY = 1.4e-5, .nearView = 1e6 - 1e-9, .farView = 1e6 + 1e-9};
    EXPECT_EQ(wrongIn(draw(scene, hair, anchored()), scene, hair).wrong, 0u);
}

/// The limit that is left is float64 itself, whose positions are 1.2e-4 apart there.
TEST_F(AdversarialTest, ACameraBillionsOfKilometresFromTheOrigin) {
    std::array<Outcome, 2> sums;
    for (const bool far : {false, true}) {
        scene::SceneSetup setup = scenes::makeAfc(2013);
        const glm::dvec3 shift = far ? glm::dvec3(1e12, -3e11, 2e11) : glm::dvec3(0.0);
        for (std::size_t i = 0; i < setup.scene.instances.size(); ++i) {
            setup.scene.instances.x[i] += shift.x;
            setup.scene.instances.y[i] += shift.y;
            setup.scene.instances.z[i] += shift.z;
        }
        const render::GpuScene gpuScene(device(), setup.scene);
        for (const std::uint32_t number : {0u, 45u, 120u, 200u}) {
            scene::Camera camera = setup.path.at(number);
            camera.position += shift;
            const Outcome result =
                outcome(draw(setup.scene, gpuScene, camera, anchored()), truthOf(setup.scene, camera));
            sums[far].wrong += result.wrong;
            sums[far].worstDistance = std::max(sums[far].worstDistance, result.worstDistance);
        }
    }
    const auto& [near, far] = sums;
    EXPECT_GT(far.wrong.pixels, 80'000u);
    EXPECT_EQ(near.wrong.wrong, 0u);
    EXPECT_EQ(far.wrong.wrong, 0u);
    // Slanted faces move by what a rasteriser snaps, near and far alike.
    EXPECT_NEAR(far.worstDistance, near.worstDistance, 2.5e-4);
}

/// A globe of pieces is searched for pixels that show the sky through its seams.
TEST_F(AdversarialTest, APlanetOfPiecesHasNoCracks) {
    scene::Scene scene = test::makeGlobe();
    ASSERT_GT(scene.meshes.size(), 1000u);
    const render::GpuScene gpuScene(device(), scene);
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    const double radius = test::GlobeOptions{}.radius;
    measure::WrongPixels wrong;
    for (const double altitude : {300.0, 20e3, 420e3, 2e7}) {
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 up = glm::normalize(glm::dvec3(share(random), share(random), share(random)));
            const glm::dvec3 eye = (radius + altitude) * up;
            // Down at the ground and off to the horizon.
            const glm::dvec3 aside = glm::normalize(glm::cross(up, glm::dvec3(0.3, 0.5, 0.8)));
            const double horizon = std::sqrt(2.0 * radius * altitude);
            const glm::dvec3 target = radius * up + (i == 0 ? 0.0 : 0.9 * std::min(horizon, radius)) * aside;
            const scene::Camera camera =
                scene::lookAt({.fovY = i == 2 ? 0.05 : 1.0, .nearView = 0.1, .farView = 1e8}, eye, target);
            wrong += wrongIn(draw(scene, gpuScene, camera, anchored()), scene, camera);
        }
    }
    EXPECT_GT(wrong.pixels, 500'000u);
    EXPECT_EQ(wrong.wrong, 0u);
}

/// Points of a mesh where its pieces meet: ends and middles of edges between triangles of different clusters.
std::vector<glm::dvec3> seamPoints(const scene::SourceMesh& mesh, double pieceRadius) {
    using Key = std::array<double, 3>;
    const auto clusters = scene::clusterTriangles(mesh, pieceRadius, scene::kMaxPieces);
    std::map<std::pair<Key, Key>, std::size_t> clusterOf;
    std::vector<glm::dvec3> points;
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        for (const std::uint32_t triangle : clusters[c].triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec3 p = mesh.positions[mesh.indices[3 * triangle + i]];
                const glm::dvec3 q = mesh.positions[mesh.indices[3 * triangle + (i + 1) % 3]];
                const Key from{p.x, p.y, p.z};
                const Key to{q.x, q.y, q.z};
                const std::pair<Key, Key> edge = std::minmax(from, to);
                const auto [found, isNew] = clusterOf.try_emplace(edge, c);
                if (!isNew && found->second != c) {
                    points.push_back(p);
                    points.push_back(0.5 * (p + q));
                }
            }
        }
    }
    return points;
}

/// The lens is so narrow that a pixel is 2 cm to 1.3 m wide on the ground. A seam that is open there shows the
/// sky.
TEST_F(AdversarialTest, NoSkyShowsThroughTheSeamsOfAPlanet) {
    const test::GlobeOptions options;
    const scene::Scene scene = test::makeGlobe(options);
    const std::vector<glm::dvec3> seams =
        seamPoints(test::globeMesh(options.radius, options.cells), options.pieceRadius);
    ASSERT_GT(seams.size(), 10'000u);
    const auto renderOptions = smallOptions(depth::parseTechnique("anchored"), 192, 108);
    SoleRenderer renderer(device(), scene, renderOptions);
    std::mt19937_64 random(14);
    std::size_t sky = 0;
    for (int i = 0; i < 150; ++i) {
        const glm::dvec3 target = seams[random() % seams.size()];
        const glm::dvec3 eye = target * (1.0 + 420e3 / options.radius) + glm::dvec3(2e5, 1e5, 0.0);
        const double pixel = 0.02 * std::pow(4.0, i % 4); // 2 cm to 1.3 m
        const scene::Camera lens{
            .fovY = 108.0 * pixel / glm::distance(eye, target), .nearView = 0.1, .farView = 1e8};
        const image::ImageU32 ids = renderer.render(scene::lookAt(lens, eye, target)).ids();
        sky += static_cast<std::size_t>(std::count(ids.pixels.begin(), ids.pixels.end(), 0u));
    }
    EXPECT_EQ(sky, 0u);
}

/// Where each technique gives up: wrong pixels per distance, separations of 1e-6 of it and of 1e-7.
TEST_F(AdversarialTest, OfMixedDistancesOnlyAnchoredGetsAllRight) {
    constexpr std::size_t kColumns = scenes::kMixedDistances.size();
    using Counts = std::array<std::size_t, kColumns>;
    const scene::SceneSetup setup = scenes::makeMixed();
    const scene::Camera camera = setup.path.at(0);
    const render::GpuScene gpuScene(device(), setup.scene);
    const auto truth = truthOf(setup.scene, camera);
    const auto inner = measure::innerMask(truth);
    const auto excused = swappable(truth, snapReach(device()));
    std::map<std::string, std::array<Counts, 2>> wrong; // by technique and separation
    std::map<std::string, std::array<Counts, 2>>
        beyond; // the same without what the device's snapping explains
    for (const depth::NamedTechnique& preset : depth::presets()) {
        const image::ImageU32 ids = draw(setup.scene, gpuScene, camera, smallOptions(preset.technique)).ids();
        std::array<Counts, 2> pixels{};
        wrong[preset.name] = {};
        beyond[preset.name] = {};
        for (std::size_t i = 0; i < ids.pixels.size(); ++i) {
            if (inner.pixels[i] != 0) {
                const std::size_t cell = (truth.pixels[i].id - 1) / 2 / scenes::kMixedPairsPerCell;
                ++pixels[cell % 2][cell / 2];
                const bool isWrong = ids.pixels[i] != truth.pixels[i].id;
                const bool isExcused = ids.pixels[i] == truth.pixels[i].secondId && excused.pixels[i] != 0;
                wrong[preset.name][cell % 2][cell / 2] += isWrong ? 1 : 0;
                beyond[preset.name][cell % 2][cell / 2] += isWrong && !isExcused ? 1 : 0;
            }
        }
        EXPECT_GT(*std::min_element(pixels[0].begin(), pixels[0].end()), 2000u);
        EXPECT_GT(*std::min_element(pixels[1].begin(), pixels[1].end()), 2000u);
    }
    const Counts none{};
    EXPECT_EQ(beyond["anchored"][0], none);
    EXPECT_EQ(beyond["anchored"][1], none);
    // 1e-6 of the distance is what float32 distances still tell apart, with luck in the cascades.
    EXPECT_EQ(beyond["reversed"][0], none);
    EXPECT_EQ(beyond["logcdr"][0], none);
    EXPECT_GT(wrong["cdr"][0][3], 500u);
    for (std::size_t column = 0; column < kColumns; ++column) {
        EXPECT_GT(wrong["standard"][0][column], column > 0 ? 500u : 0u) << column;
        EXPECT_TRUE(wrong["log"][0][column] > 100 || column < 2) << column;
        for (const char* name : {"standard", "cdr", "log", "logcdr"}) {
            EXPECT_GT(wrong[name][1][column], 300u) << name << " " << column;
        }
        // Snapped, a column of nine pairs may come out right by chance.
        EXPECT_TRUE(wrong["reversed"][1][column] > 0 || snapReach(device()) > 0.0) << column;
    }
}

} // namespace

} // namespace cdr::render_test
