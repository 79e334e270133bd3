#include "../../support/refusal.h"
#include "../fixture.h"
#include "../snapping.h"
#include "../steps.h"

#include <cdr/base/error.h>
#include <cdr/render/geometry/layers.h>
#include <scenes/coplanar.h>
#include <scenes/sheets.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cdr::render_test {

namespace {

class LayersTest : public RenderTest {
  protected:
    /// Views that show roads, walls, machines and the thin wall, near and far, steep and grazing.
    static constexpr std::uint32_t kViews = 8;

    render::RenderOptions optionsFor(const depth::Technique& technique) {
        return smallOptions(technique, 320, 180);
    }

    /// Over all views, in pictures of optionsFor().
    measure::WrongPixels wrongWith(const render::RenderOptions& options) {
        static const scene::Scene scene = scenes::makeCoplanar().scene;
        static std::vector<measure::TruthImage> truths(kViews);
        SoleRenderer renderer(device(), scene, options);
        measure::WrongPixels all;
        for (std::uint32_t view = 0; view < kViews; ++view) {
            const scene::Camera camera = scenes::coplanarView(7, view);
            if (truths[view].pixels.empty()) {
                truths[view] = truthOf(scene, camera, options.width, options.height);
            }
            all += measure::countWrong(renderer.render(camera).ids(), truths[view]);
        }
        return all;
    }

    /// Of all inner pixels. Where the device rounds vertices, slivers cover pixels that no ray meets them in.
    double mostWrong() { return snapReach(device()) > 0.0 ? 1e-3 : 0.0; }
};

scene::Material inLayer(float layer) {
    return {.name = "layer", .layer = layer};
}

TEST(LayerPlaces, AreRankedByOffsetFromThoseWithoutOne) {
    const std::vector<scene::Material> materials{inLayer(0.0f),  inLayer(2.0f), inLayer(0.5f),
                                                 inLayer(-1.0f), inLayer(2.0f), inLayer(-3.0f)};
    std::vector<float> ranks;
    for (const render::LayerPlace& place : render::layerPlaces(materials)) {
        ranks.push_back(place.rank);
    }
    EXPECT_EQ(ranks, (std::vector<float>{0.0f, 2.0f, 1.0f, -1.0f, 2.0f, -2.0f}));
}

TEST(LayerPlaces, NeedNoMaterialWithoutALayer) {
    const std::vector<scene::Material> materials{inLayer(2.0f), inLayer(-1.0f)};
    EXPECT_EQ(render::layerPlaces(materials)[0], (render::LayerPlace{2.0f, 1.0f}));
    EXPECT_EQ(render::layerPlaces(materials)[1], (render::LayerPlace{-1.0f, -1.0f}));
}

TEST_F(LayersTest, EveryTechniqueShowsTheUpperOfFacesAtOnePlace) {
    for (const depth::NamedTechnique& named : depth::presets()) {
        for (const render::TargetsKind targets :
             {render::TargetsKind::single, render::TargetsKind::onePass}) {
            render::RenderOptions options = optionsFor(named.technique);
            options.targets = targets;
            const measure::WrongPixels wrong = wrongWith(options);
            EXPECT_GT(wrong.pixels, 100'000u);
            EXPECT_LE(wrong.fraction(), mostWrong()) << named.name << " " << nameOf(targets);
        }
    }
}

/// Else the test above would show nothing.
TEST_F(LayersTest, WithoutAnOffsetFacesAtOnePlaceFight) {
    render::RenderOptions options = optionsFor(depth::parseTechnique("anchored"));
    options.layers.method = render::LayerMethod::polygonOffset;
    EXPECT_GT(wrongWith(options).fraction(), 0.05);
    options.layers.constantFactor = 16.0f;
    options.layers.slopeFactor = 0.25f;
    EXPECT_LT(wrongWith(options).fraction(), 0.05);
}

TEST_F(LayersTest, HaveFiniteFactors) {
    render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    for (const render::LayerMethod method :
         {render::LayerMethod::sceneUnits, render::LayerMethod::polygonOffset}) {
        options.layers = {.method = method, .slopeFactor = -1.5f, .constantFactor = 16.0f};
        EXPECT_EQ(refusalOf(boxScene(), options), "none");
        options.layers.slopeFactor = std::numeric_limits<float>::infinity();
        EXPECT_EQ(refusalOf(boxScene(), options),
                  "the slope and constant factor of layers must be finite, not inf and 16");
        options.layers = {.method = method, .constantFactor = std::numeric_limits<float>::quiet_NaN()};
        EXPECT_EQ(refusalOf(boxScene(), options),
                  "the slope and constant factor of layers must be finite, not 0 and nan");
    }
}

TEST_F(LayersTest, HoldWhereVerticesAreRoundedToSubPixels) {
    for (const std::uint32_t bits : {4u, 8u}) {
        render::RenderOptions options = optionsFor(depth::parseTechnique("anchored"));
        options.snapBits = bits;
        // Slivers that rounding moves over a pixel's centre.
        EXPECT_LT(wrongWith(options).fraction(), 1e-4 + mostWrong()) << bits;
    }
}

/// Walls that are seen at 20 degrees, each with a blended decal in its plane.
scene::Scene blendedDecals() {
    scene::Scene scene = boxScene();
    scene.meshes.push_back(scenes::makeSquare(1.5f));
    scene.meshes.push_back(scenes::makeSquare(0.75f));
    scene.materials.push_back({.name = "decal",
                               .baseColorFactor = glm::vec4(0.5f),
                               .alphaMode = scene::AlphaMode::blend,
                               .layer = 1e-3f});
    for (std::uint32_t i = 0; i < 10; ++i) {
        const glm::dvec3 place(-5.03 + 2.51 * (i % 5), i < 5 ? -2.02 : 1.97, -8.0);
        const auto angle = static_cast<float>(std::atan2(-place.x, -place.z) + 1.22);
        const float along = std::cos(angle);
        const float across = std::sin(angle);
        const glm::mat3 turned(along, 0.0f, -across, 0.0f, 1.0f, 0.0f, across, 0.0f, along);
        scene::addInstance(scene, 1, 0, 2 * i, place, turned);
        scene::addInstance(scene, 2, 1, 2 * i + 1, place, turned);
    }
    return scene;
}

/// What the walls are moved by, decals are moved by more.
TEST_F(LayersTest, HoldOfBlendedSurfacesWhereVerticesAreRoundedToSubPixels) {
    const scene::Scene scene = blendedDecals();
    const scene::Camera camera;
    render::RenderOptions options = optionsFor(depth::parseTechnique("anchored"));
    options.translucency.countsFragments = true;
    const measure::LayeredTruth truth = layersOf(scene, camera, options.width, options.height);
    const auto isInner = [&](std::uint32_t x, std::uint32_t y) {
        bool isAllDecal = true;
        for (std::uint32_t i = 0; i < 9; ++i) {
            isAllDecal = isAllDecal && truth.at(x - 1 + i % 3, y - 1 + i / 3).fragments == 1;
        }
        return isAllDecal;
    };
    for (const std::uint32_t bits : {1u, 2u, 4u}) {
        options.snapBits = bits;
        const render::Frame frame = draw(scene, camera, options);
        std::size_t inner = 0;
        std::size_t hidden = 0;
        for (std::uint32_t y = 1; y + 1 < options.height; ++y) {
            for (std::uint32_t x = 1; x + 1 < options.width; ++x) {
                inner += isInner(x, y) ? 1 : 0;
                hidden += isInner(x, y) && frame.fragmentCounts.at(x, y) != 1 ? 1 : 0;
            }
        }
        EXPECT_GT(inner, 500u);
        EXPECT_EQ(hidden, 0u) << bits;
    }
}

TEST_F(LayersTest, GiveOnePictureHoweverTheFrameIsDrawn) {
    const scene::SceneSetup setup = scenes::makeCoplanar();
    for (const depth::NamedTechnique& named : depth::presets()) {
        expectOnePicture(setup.scene, setup.path.at(6), thumbnailOptions(named.technique));
    }
}

/// The pipelines of occluders have no depth bias.
TEST_F(LayersTest, PolygonOffsetIsNotSetForOccluders) {
    const scene::SceneSetup setup = scenes::makeCoplanar();
    render::RenderOptions options = thumbnailOptions(depth::parseTechnique("anchored"));
    options.layers = {
        .method = render::LayerMethod::polygonOffset, .slopeFactor = 0.25f, .constantFactor = 16.0f};
    for (const render::Submission submission : submissions()) {
        options.submission = submission;
        options.occlusionCulling = false;
        const std::string wanted = hashOf(draw(setup.scene, setup.path.at(6), options));
        options.occlusionCulling = true;
        EXPECT_EQ(hashOf(draw(setup.scene, setup.path.at(6), options)), wanted) << nameOf(submission);
    }
}

/// Only what is seen changes, not how far away it is.
TEST_F(LayersTest, KeepTheDistanceOfASurface) {
    scene::Scene scene = boxScene();
    scene.materials[0].layer = 0.25f;
    addBox(scene, {0.0, 0.0, -10.0});
    const render::Frame frame = draw(scene, scene::Camera{}, optionsFor(depth::parseTechnique("anchored")));
    EXPECT_NEAR(frame.distanceView(160, 90), 9.5, 1e-5);
}

/// A square in front of a wall, and a layer by which the wall is moved before it, or not quite.
TEST_F(LayersTest, MoveByTheirOffsetInSceneUnits) {
    for (const char* technique : {"standard", "reversed", "log", "anchored"}) {
        for (const double distance : {2.0, 300.0}) {
            for (const float layer : {0.7f, 1.3f}) {
                scene::Scene scene = boxScene();
                scene.meshes.push_back(scenes::makeSquare(1.0f));
                scene.materials.push_back(inLayer(layer));
                scene::addInstance(scene, 1, 0, 0, {0.0, 0.0, -distance}, glm::mat3(1.0f));
                scene::addInstance(scene, 1, 1, 1, {0.0, 0.0, -distance - 1.0}, glm::mat3(1.0f));
                scene::Camera camera;
                camera.farView = 1000.0;
                const render::Frame frame = draw(scene, camera, optionsFor(depth::parseTechnique(technique)));
                EXPECT_EQ(frame.id(160, 90), layer > 1.0f ? 2u : 1u) << technique << distance << layer;
            }
        }
    }
}

/// What a layer moves out of a cascade at its near end, the next one draws.
TEST_F(LayersTest, KeepTheirOrderAcrossTheEndOfACascade) {
    for (const char* technique : {"standard/at:10", "log/at:10", "anchored/at:10"}) {
        scene::Scene scene = boxScene();
        scene.meshes.push_back(scenes::makeSquare(1.0f));
        scene.meshes.push_back(scenes::makeSquare(0.1f));
        for (const float layer : {0.3f, 0.2f, -0.2f, 0.4f}) {
            scene.materials.push_back(inLayer(layer));
        }
        const auto add = [&](std::uint32_t mesh, std::uint32_t material, double x, double distance) {
            const auto object = static_cast<std::uint32_t>(scene.instances.size());
            scene::addInstance(scene, mesh, material, object, {x, 0.0, -distance}, glm::mat3(1.0f));
        };
        add(1, 1, -2.0, 10.1); // upper, drawn first
        add(1, 2, -2.0, 10.1);
        add(1, 0, 0.0, 9.9);
        add(1, 3, 0.0, 9.9);   // lower, drawn last
        add(2, 4, 2.0, 10.25); // smaller than its offset
        add(1, 3, 4.5, 9.9);   // lower, alone
        scene::Camera camera;
        camera.farView = 1000.0;
        const render::Frame frame = draw(scene, camera, optionsFor(depth::parseTechnique(technique)));
        ASSERT_EQ(frame.cascades.size(), 2u);
        EXPECT_EQ(frame.id(127, 90), 1u) << technique;
        EXPECT_EQ(frame.id(160, 90), 3u) << technique;
        EXPECT_EQ(frame.id(192, 90), 5u) << technique;
        EXPECT_EQ(frame.id(235, 90), 6u) << technique;
    }
}

/// A nearer cascade wins, so it may not keep a layered surface from which it cuts what is in front.
TEST_F(LayersTest, HideNothingInFrontOfThemBeyondTheEndOfAThinCascade) {
    scene::Scene scene = boxScene();
    scene.meshes.push_back(scenes::makeSquare(5.0f));
    scene.meshes.push_back(scenes::makeSquare(2.0f));
    scene.materials.push_back(inLayer(0.01f));
    scene::addInstance(scene, 1, 1, 0, {0.0, 0.0, -1'000'002.5}, glm::mat3(1.0f));
    scene::addInstance(scene, 2, 0, 1, {0.0, 0.0, -1'000'001.5}, glm::mat3(1.0f));
    const scene::Camera camera{.fovY = 2e-5, .nearView = 999'000.0, .farView = 1'001'000.0};
    for (const char* technique : {"anchored/at:1000000", "anchored-reversed/at:1000000"}) {
        const render::Frame frame = draw(scene, camera, optionsFor(depth::parseTechnique(technique)));
        ASSERT_EQ(frame.cascades.size(), 2u);
        EXPECT_EQ(frame.id(160, 90), 2u) << technique;
        EXPECT_EQ(frame.id(160, 120), 1u) << technique;
    }
}

/// Though they are moved beyond the end of every cascade that lists them.
TEST_F(LayersTest, AreSeenWhereTheyAreMovedOutOfTheirCascade) {
    for (const char* technique :
         {"anchored", "standard/none", "log/none", "standard/at:10.1", "anchored/at:10.1"}) {
        scene::Scene scene = boxScene();
        scene.meshes.push_back(scenes::makeSquare(0.05f));
        scene.materials.push_back(inLayer(-2.0f));
        scene::addInstance(scene, 1, 1, 0, {0.0, 0.0, -10.0}, glm::mat3(1.0f));
        scene::Camera camera{.fovY = 0.01};
        camera.farView = std::string(technique).ends_with("none") ? 11.0 : 1000.0;
        const render::Frame frame = draw(scene, camera, optionsFor(depth::parseTechnique(technique)));
        EXPECT_EQ(frame.id(160, 90), 1u) << technique;
    }
}

/// Far beyond their own distance, where a logarithm is no polynomial.
TEST_F(LayersTest, ThatAreMovedFarAwayAreStillNearer) {
    for (const char* technique : {"standard/none", "log/none", "log-fragment/none", "anchored/none"}) {
        scene::Scene scene = boxScene();
        scene.meshes.push_back(scenes::makeSquare(20.0f));
        scene.materials.push_back(inLayer(-3.0f));
        scene::addInstance(scene, 1, 1, 0, {0.0, 0.0, -1.0}, glm::mat3(1.0f));
        scene::addInstance(scene, 1, 0, 1, {0.0, 0.0, -10.0}, glm::mat3(1.0f));
        scene::Camera camera;
        camera.farView = 1e4;
        const render::Frame frame = draw(scene, camera, optionsFor(depth::parseTechnique(technique)));
        EXPECT_EQ(frame.id(160, 90), 1u) << technique;
    }
}

TEST_F(LayersTest, OrderBlendedSurfacesToo) {
    scene::Scene scene = boxScene();
    scene.meshes.push_back(scenes::makeSquare(1.0f));
    scene.materials[0].unlit = true;
    const auto addSheet = [&](const glm::vec4& color, float layer, double distance) {
        scene.materials.push_back({.name = "sheet",
                                   .baseColorFactor = color,
                                   .unlit = true,
                                   .alphaMode = scene::AlphaMode::blend,
                                   .layer = layer});
        const auto material = static_cast<std::uint32_t>(scene.materials.size() - 1);
        scene::addInstance(scene, 1, material, static_cast<std::uint32_t>(scene.instances.size()),
                           {0.0, 0.0, -distance}, glm::mat3(1.0f));
    };
    addBox(scene, {0.0, 0.0, -5.5});                // its front is at 5
    addSheet({1.0f, 0.0f, 0.0f, 0.5f}, 0.2f, 5.1);  // within the box by less than its layer
    addSheet({0.0f, 0.0f, 1.0f, 0.5f}, 0.1f, 5.05); // nearer, and lower
    addSheet({0.0f, 1.0f, 0.0f, 0.5f}, 0.2f, 5.3);  // within the box by more
    const render::RenderOptions options = withSorting(optionsFor(depth::parseTechnique("anchored")));
    const scene::Camera camera;
    const render::Frame frame = draw(scene, camera, options);
    const measure::LayeredTruth truth = layersOf(scene, camera, options.width, options.height);
    EXPECT_EQ(truth.at(160, 90).fragments, 2u);
    const image::Rgba8 wanted = measure::pictureOf(truth).at(160, 90);
    const image::Rgba8 shown = frame.color.at(160, 90);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(int{shown[channel]}, int{wanted[channel]}, 1) << channel;
    }
}

TEST_F(LayersTest, NeedAGBuffer) {
    const scene::SceneSetup setup = scenes::makeCoplanar();
    render::RenderOptions options = optionsFor(depth::parseTechnique("anchored"));
    options.surface = render::SurfacePath::visibility;
    const std::string refusal =
        test::inputErrorOf([&] { draw(setup.scene, setup.path.at(0), options); }, "none");
    EXPECT_NE(refusal.find("a layer"), std::string::npos) << refusal;
}

TEST_F(LayersTest, MustBeFinite) {
    for (const float layer :
         {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        scene::Scene scene = boxScene();
        scene.materials[0].layer = layer;
        EXPECT_THROW(render::GpuScene(device(), scene), base::InputError);
    }
}

} // namespace

} // namespace cdr::render_test
