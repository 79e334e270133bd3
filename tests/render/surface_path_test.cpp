#include "../support/picture_comparison.h"
#include "../support/worst.h"
#include "fixture.h"
#include "steps.h"

#include <scenes/cubes.h>
#include <scenes/open_scene.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace cdr::render_test {

namespace {

using render::SurfacePath;
using render::TargetsKind;

render::RenderOptions surfaceOptions(const depth::Technique& technique, SurfacePath surface) {
    render::RenderOptions options = smallOptions(technique);
    options.surface = surface;
    return options;
}

using SurfacePathTest = RenderTest;

/// Whether the pixel and its neighbours show one face of one object. Then no edge decides what the pixel shows,
/// which each device rounds to a grid of its own.
bool isInsideFace(const render::Frame& frame, std::uint32_t x, std::uint32_t y) {
    if (x == 0 || y == 0 || x + 1 == frame.width() || y + 1 == frame.height()) {
        return false;
    }
    const auto showsTheSame = [&](std::uint32_t thereX, std::uint32_t thereY) {
        return frame.id(thereX, thereY) == frame.id(x, y) &&
               glm::dot(frame.normalView(thereX, thereY), frame.normalView(x, y)) > 0.99f;
    };
    return showsTheSame(x - 1, y) && showsTheSame(x + 1, y) && showsTheSame(x, y - 1) &&
           showsTheSame(x, y + 1);
}

/// The largest error of a distance, relative to it, where the frame shows the true object and no edge is near.
double worstDistanceError(const render::Frame& frame, const measure::TruthImage& truth) {
    double worst = 0.0;
    for (std::uint32_t y = 0; y < frame.height(); ++y) {
        for (std::uint32_t x = 0; x < frame.width(); ++x) {
            const measure::TruthPixel& wanted = truth.at(x, y);
            if (wanted.id != 0 && frame.id(x, y) == wanted.id && isInsideFace(frame, x, y)) {
                worst = test::worseOf(worst, std::abs(frame.distanceView(x, y) / wanted.distanceView - 1.0));
            }
        }
    }
    return worst;
}

double shareOfOtherIds(const render::Frame& a, const render::Frame& b) {
    const image::ImageU32 ids = a.ids();
    const image::ImageU32 others = b.ids();
    std::size_t differing = 0;
    for (std::size_t i = 0; i < ids.pixels.size(); ++i) {
        differing += ids.pixels[i] != others.pixels[i] ? 1 : 0;
    }
    return static_cast<double>(differing) / static_cast<double>(ids.pixels.size());
}

TEST_F(SurfacePathTest, VisibilityShowsWhatTheGBufferShows) {
    for (const char* name : {"cubes", "afc", "rotation", "mixed"}) {
        const scene::SceneSetup setup = scenes::openScene(name, 2013).setup;
        if (!readsFacetsOf(setup.scene)) {
            leaveOut("texels for as many facets");
            continue;
        }
        const render::GpuScene gpuScene(device(), setup.scene);
        const measure::TruthImage truth = truthOf(setup.scene, setup.path.at(0));
        for (const auto& [preset, technique] : depth::presets()) {
            SCOPED_TRACE(std::string(name) + " " + std::string(preset));
            render::Renderer visibility(device(), setup.scene, gpuScene,
                                        surfaceOptions(technique, SurfacePath::visibility));
            render::Renderer gbuffer(device(), setup.scene, gpuScene,
                                     surfaceOptions(technique, SurfacePath::gbuffer));
            const render::Frame a = visibility.render(setup.path.at(0));
            const render::Frame b = gbuffer.render(setup.path.at(0));
            const std::size_t wrong = measure::countWrong(b.ids(), truth).wrong;
            // Where depths tie, roundings decide, and those differ; else the same object shows.
            EXPECT_LE(shareOfOtherIds(a, b), wrong > 0 ? 0.01 : 0.0);
            EXPECT_LE(measure::countWrong(a.ids(), truth).wrong, wrong + wrong / 25);
            // A plane equation is no farther from the truth than what is interpolated between corners.
            const double error = worstDistanceError(a, truth);
            EXPECT_LT(error, HUGE_VAL);
            EXPECT_LE(error, 1.05 * worstDistanceError(b, truth));
            EXPECT_EQ(messageCount(), 0u);
        }
    }
}

TEST_F(SurfacePathTest, AllTargetsAndThreadsShowOnePicture) {
    scene::SceneSetup setup = scenes::makeRotation(3, 20'000);
    // Some targets clear to it, others write it. In sRGB it is 25.46, 33.77 and 49.94, which devices round as they like.
    setup.scene.background = {0.010f, 0.016f, 0.032f};
    const render::GpuScene gpuScene(device(), setup.scene);
    bool isFoggy = false;
    for (const auto& [preset, technique] : depth::presets()) {
        isFoggy = !isFoggy;
        std::string first;
        for (const TargetsKind targets :
             {TargetsKind::single, TargetsKind::accumulate, TargetsKind::pool, TargetsKind::layers}) {
            for (const std::size_t threads : {1u, 4u}) {
                render::RenderOptions options = surfaceOptions(technique, SurfacePath::visibility);
                options.targets = targets;
                options.threads = threads;
                if (isFoggy) {
                    options.effects.fog = {.visibility = 200.0, .color = setup.scene.background};
                }
                options.submission =
                    threads == 1 ? render::Submission::secondaries : render::Submission::primaries;
                const std::string hash = hashOf(draw(setup.scene, gpuScene, setup.path.at(33), options));
                first = first.empty() ? hash : first;
                EXPECT_EQ(hash, first) << preset << " " << nameOf(targets) << " " << threads;
            }
        }
    }
}

TEST_F(SurfacePathTest, OnePassIsNoWorse) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    const depth::Technique anchored = depth::parseTechnique("anchored");
    render::RenderOptions options = surfaceOptions(anchored, SurfacePath::visibility);
    options.targets = TargetsKind::onePass;
    EXPECT_EQ(wrongIn(draw(setup.scene, setup.path.at(9), options), setup.scene, setup.path.at(9)).wrong, 0u);
}

TEST_F(SurfacePathTest, FramesInFlightKeepTheirFacets) {
    const scene::SceneSetup setup = scenes::makeRotation(3, 4'000);
    const render::GpuScene gpuScene(device(), setup.scene);
    const depth::Technique standard = depth::parseTechnique("standard");
    render::RenderOptions options = surfaceOptions(standard, SurfacePath::visibility);
    render::Renderer one(device(), setup.scene, gpuScene, options);
    options.framesInFlight = 3;
    render::Renderer three(device(), setup.scene, gpuScene, options);
    for (std::uint32_t frame = 0; frame < 7; ++frame) {
        three.submit(setup.path.at(frame * 40));
        if (frame % 3 == 2) {
            EXPECT_EQ(hashOf(three.render(setup.path.at(frame))), hashOf(one.render(setup.path.at(frame))));
        }
    }
    three.finish();
}

TEST_F(SurfacePathTest, MirroredShinyAndUnlitSurfacesLookTheSame) {
    scene::SceneSetup setup = scenes::makeRotation(5, 6'000);
    scene::Scene& scene = setup.scene;
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.9f, 0.2f, 0.5f)));
    scene.materials[0].metallicRoughness = scene::MetallicRoughness{.metallic = 1.0f, .roughness = 0.3f};
    scene.materials.push_back(
        {.name = "unlit", .baseColorFactor = glm::vec4(0.2f, 0.5f, 0.9f, 1.0f), .unlit = true});
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        scene.instances.mesh[i] = i % 3 == 0 ? 1 : 0;
        scene.instances.material[i] = i % 4 == 0 ? 1 : 0;
        if (i % 5 == 0) {
            scene.instances.basis[i][0] = -scene.instances.basis[i][0];
        }
    }
    const depth::Technique reversed = depth::parseTechnique("reversed");
    const render::Frame a = draw(scene, setup.path.at(90), surfaceOptions(reversed, SurfacePath::visibility));
    const render::Frame b = draw(scene, setup.path.at(90), surfaceOptions(reversed, SurfacePath::gbuffer));
    EXPECT_EQ(a.ids().pixels, b.ids().pixels);
    EXPECT_GT(std::count_if(a.gbuffer.pixels.begin(), a.gbuffer.pixels.end(),
                            [](const render::GBufferPixel& pixel) { return pixel.id() != 0; }),
              1000);
    for (std::size_t i = 0; i < a.gbuffer.pixels.size(); ++i) {
        ASSERT_EQ(a.gbuffer.pixels[i].albedo, b.gbuffer.pixels[i].albedo) << i;
        ASSERT_EQ(a.gbuffer.pixels[i].idAndCascade, b.gbuffer.pixels[i].idAndCascade) << i;
        ASSERT_GT(glm::dot(a.gbuffer.pixels[i].normalView(), b.gbuffer.pixels[i].normalView()),
                  a.gbuffer.pixels[i].id() == 0 ? -1.0f : 0.99999f)
            << i;
    }
    const test::Comparison difference = test::compare(b.color, a.color, {.channel = 2, .pixelShare = 0.001});
    EXPECT_TRUE(difference.passes) << describe(difference);
}

/// As in the G-buffer, which has a byte for it; of lit and unlit ones.
TEST_F(SurfacePathTest, BaseColorsAbove1AreCutOffOnEachAndInTheTruth) {
    scene::Scene scene = boxScene();
    scene.ambient = glm::vec3(0.1f);
    scene.lights[0].halfDistance = 5.0;
    scene.materials[0].baseColorFactor = glm::vec4(2.0f, 1.0f, 0.25f, 1.0f);
    addBox(scene, {0.0, 0.0, 0.0}, glm::mat3(8.0f));
    const scene::Camera camera = scene::lookAt({.fovY = 0.5}, {3.0, 4.0, 12.0}, glm::dvec3(0.0));
    for (const bool unlit : {false, true}) {
        scene.materials[0].unlit = unlit;
        const measure::LayeredTruth truth = layersOf(scene, camera, 64, 36);
        for (const SurfacePath surface : render::kSurfacePaths) {
            render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"), 64, 36);
            options.surface = surface;
            EXPECT_LE(largestStepTo(truth, {}, draw(scene, camera, options).color), 2)
                << nameOf(surface) << (unlit ? ", unlit" : "");
        }
    }
}

TEST_F(SurfacePathTest, SaysWhyVisibilityCannotBe) {
    scene::SceneSetup setup = scenes::makeRotation(3, 100);
    const render::RenderOptions plain =
        surfaceOptions(depth::parseTechnique("standard"), SurfacePath::visibility);
    EXPECT_EQ(refusalOf(setup.scene, plain), "none");
    render::RenderOptions options = plain;
    options.submission = render::Submission::gpuDriven;
    EXPECT_NE(refusalOf(setup.scene, options).find("gpu-driven"), std::string::npos);
    options = plain;
    options.batching = render::Batching::perObject;
    EXPECT_NE(refusalOf(setup.scene, options).find("batching"), std::string::npos);
    options = plain;
    options.effects.occlusion.radius = 1.0;
    EXPECT_NE(refusalOf(setup.scene, options).find("occlusion"), std::string::npos);
    EXPECT_NE(refusalOf(scenes::openScene("boulders", 2013).setup.scene, plain).find("plane faces"),
              std::string::npos);
    setup.scene.materials[0].doubleSided = true;
    EXPECT_NE(refusalOf(setup.scene, plain).find("double-sided"), std::string::npos);
    setup.scene.materials[0].alphaMode = scene::AlphaMode::blend;
    EXPECT_NE(refusalOf(setup.scene, plain).find("blended"), std::string::npos);
}

} // namespace

} // namespace cdr::render_test
