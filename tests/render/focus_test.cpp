#include "../support/picture_comparison.h"
#include "fixture.h"

#include <cdr/base/error.h>
#include <cdr/render/focus.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

namespace cdr::render_test {

namespace {

using render::Focus;
using render::FocusLens;
using render::Frame;
using render::RenderOptions;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A grey floor from before the camera to 80 units away and boxes along it, over black. Lit by ambient light
/// alone, so that all of the floor is of one brightness.
scene::Scene floorScene() {
    scene::Scene scene = boxScene();
    scene.lights.clear();
    scene.ambient = glm::vec3(0.5f);
    addBox(scene, glm::dvec3(0.0, -2.0, -39.0),
           glm::mat3(200.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 82.0f));
    return scene;
}

/// The same with rows of dark boxes.
scene::Scene alleyScene() {
    scene::Scene scene = floorScene();
    scene.materials.push_back({.name = "dark", .baseColorFactor = glm::vec4(0.1f, 0.2f, 0.3f, 1.0f)});
    for (std::uint32_t i = 0; i < 40; ++i) {
        const double side = i % 2 == 0 ? -1.5 : 1.5;
        scene::addInstance(scene, 0, 1, 1 + i, glm::dvec3(side, -0.9, -3.0 - 1.7 * i), glm::mat3(1.0f));
    }
    return scene;
}

const scene::Camera kFocusCamera = scene::lookAt({.fovY = 0.9, .nearView = 0.5, .farView = 1000.0},
                                                 glm::dvec3(0.0, 1.0, 2.0), glm::dvec3(0.0, -1.2, -10.0));

/// Sharp at 10, up to some 9 pixels at infinity in small pictures.
constexpr Focus kFocus{.distance = 10.0, .aperture = 0.3};
constexpr Focus kBlended{.distance = 10.0, .aperture = 0.3, .blend = true};

RenderOptions focused(const Focus& focus, const char* split = "at:5,7.5,15,30",
                      depth::Mapping mapping = depth::Mapping::reversed) {
    RenderOptions options =
        smallOptions(depth::Technique{mapping, depth::parseSplit(split), depth::DepthFormat::d32f});
    options.targets = render::TargetsKind::layers;
    options.focus = focus;
    return options;
}

FocusLens lensOfPicture(const Frame& frame, const Focus& focus) {
    return {focus, scene::frustumOf(frame.camera, frame.width(), frame.height()).tanY, frame.height()};
}

/// Sum of squared second differences along rows, over pixels that a predicate picks.
template <typename Predicate>
double roughness(const Frame& frame, const Predicate& counts) {
    double sum = 0.0;
    for (std::uint32_t y = 0; y < frame.height(); ++y) {
        for (std::uint32_t x = 1; x + 1 < frame.width(); ++x) {
            if (counts(x, y)) {
                const int bend = 2 * int{frame.color.at(x, y)[0]} - int{frame.color.at(x - 1, y)[0]} -
                                 int{frame.color.at(x + 1, y)[0]};
                sum += static_cast<double>(bend) * bend;
            }
        }
    }
    return sum;
}

bool isFrom(const Frame& frame, std::uint32_t cascade, std::uint32_t x, std::uint32_t y) {
    return frame.id(x, y) != 0 && frame.cascade(x, y) == cascade;
}

float aheadAt(const Frame& frame, std::uint32_t x, std::uint32_t y) {
    return frame.gbuffer.at(x, y).ahead;
}

class FocusTest : public RenderTest {};

TEST_F(FocusTest, ALensWithNextToNoApertureShowsTheOrdinaryPicture) {
    const scene::Scene scene = alleyScene();
    for (const depth::Mapping mapping : {depth::Mapping::standard, depth::Mapping::reversed,
                                         depth::Mapping::log, depth::Mapping::anchored}) {
        RenderOptions options = focused({.distance = 10.0, .aperture = 1e-9}, "at:5,7.5,15,30", mapping);
        const Frame sharp = draw(scene, kFocusCamera, options);
        options.focus.blend = true;
        const Frame blended = draw(scene, kFocusCamera, options);
        options.focus = {};
        const Frame ordinary = draw(scene, kFocusCamera, options);
        EXPECT_EQ(program::sha256Of(sharp.gbuffer.pixels), program::sha256Of(ordinary.gbuffer.pixels))
            << nameOf(mapping);
        for (const Frame* frame : {&sharp, &blended}) {
            const test::Comparison difference =
                test::compare(ordinary.color, frame->color, {.channel = 1, .pixelShare = 0.0});
            EXPECT_TRUE(difference.passes) << nameOf(mapping) << ": " << describe(difference);
        }
        EXPECT_EQ(blended.ids().pixels, ordinary.ids().pixels) << nameOf(mapping);
    }
}

TEST_F(FocusTest, WhatIsOutOfFocusIsDrawnSmallerAndLooksSmoother) {
    const scene::Scene scene = alleyScene();
    const Frame blurred = draw(scene, kFocusCamera, focused(kFocus));
    const Frame sharp = draw(scene, kFocusCamera, focused({}));
    const FocusLens lens = lensOfPicture(blurred, kFocus);
    std::set<std::uint32_t> scales;
    for (std::uint32_t cascade = 0; cascade < blurred.cascades.size(); ++cascade) {
        const std::uint32_t scale = lens.scaleOf(blurred.cascades[cascade]);
        scales.insert(scale);
        // Pixels above each other that lie in one pixel of the layer.
        const std::uint32_t rows = (blurred.height() + scale - 1) / scale;
        const auto rowOf = [&](std::uint32_t y) { return (2 * y + 1) * rows / (2 * blurred.height()); };
        std::size_t pairs = 0;
        std::size_t alike = 0;
        std::size_t alikeInFull = 0;
        for (std::uint32_t y = 0; y + 1 < blurred.height(); ++y) {
            for (std::uint32_t x = 0; rowOf(y) == rowOf(y + 1) && x < blurred.width(); ++x) {
                if (isFrom(blurred, cascade, x, y) && isFrom(blurred, cascade, x, y + 1)) {
                    ++pairs;
                    alike += aheadAt(blurred, x, y) == aheadAt(blurred, x, y + 1) ? 1 : 0;
                    alikeInFull += aheadAt(sharp, x, y) == aheadAt(sharp, x, y + 1) ? 1 : 0;
                }
            }
        }
        EXPECT_EQ(alike, pairs) << cascade;
        EXPECT_LE(10 * alikeInFull, pairs) << cascade;
        EXPECT_EQ(pairs > 500, scale > 1) << cascade;
        const auto isOfCascade = [&](std::uint32_t x, std::uint32_t y) {
            return isFrom(sharp, cascade, x, y);
        };
        const double rough = roughness(sharp, isOfCascade);
        if (scale >= 2) {
            EXPECT_LT(roughness(blurred, isOfCascade), 0.5 * rough) << cascade;
        } else {
            EXPECT_GT(roughness(blurred, isOfCascade), 0.6 * rough) << cascade;
        }
    }
    EXPECT_EQ(scales, (std::set<std::uint32_t>{1, 2, 4, 8}));
}

/// Floor pixels, off its far edge, that are darker than the floor is.
std::size_t darkened(const Frame& frame) {
    constexpr int kFloor = 188; // sRGB of 0.5
    constexpr double kFarEdge = 35.0;
    std::size_t count = 0;
    for (std::uint32_t y = 0; y < frame.height(); ++y) {
        for (std::uint32_t x = 0; x < frame.width(); ++x) {
            const bool isFloor = frame.id(x, y) != 0 && frame.distanceView(x, y) < kFarEdge;
            count += isFloor && frame.color.at(x, y)[0] < kFloor - 2 ? 1 : 0;
        }
    }
    return count;
}

TEST_F(FocusTest, BlendingHidesTheSeamsWhereCascadesMeet) {
    const scene::Scene scene = floorScene();
    EXPECT_EQ(darkened(draw(scene, kFocusCamera, focused({}))), 0u);
    for (const depth::Mapping mapping : {depth::Mapping::standard, depth::Mapping::reversed,
                                         depth::Mapping::log, depth::Mapping::anchored}) {
        const Frame cut = draw(scene, kFocusCamera, focused(kFocus, "at:5,7.5,15,30", mapping));
        const Frame blended = draw(scene, kFocusCamera, focused(kBlended, "at:5,7.5,15,30", mapping));
        EXPECT_GT(darkened(cut), cut.width()) << nameOf(mapping); // a line or more across the picture
        EXPECT_EQ(darkened(blended), 0u) << nameOf(mapping);
    }
}

/// How far two pictures are apart over the surfaces that a third shows within a range of distances.
int apart(const Frame& a, const Frame& b, const Frame& surfaces, const depth::Cascade& range) {
    int sum = 0;
    for (std::uint32_t y = 0; y < a.height(); ++y) {
        for (std::uint32_t x = 0; x < a.width(); ++x) {
            sum += range.contains(surfaces.distanceView(x, y))
                       ? std::abs(int{a.color.at(x, y)[0]} - int{b.color.at(x, y)[0]})
                       : 0;
        }
    }
    return sum;
}

TEST_F(FocusTest, ACascadeFadesIntoTheNext) {
    const scene::Scene scene = alleyScene();
    const Frame sharp = draw(scene, kFocusCamera, focused(kFocus, "none"));
    const Frame blurred = draw(scene, kFocusCamera, focused(kFocus, "at:13.2")); // 2 pixels from there on
    const Frame blended =
        draw(scene, kFocusCamera, focused(kBlended, "at:15")); // both draw from 12, fading from 13.5
    const depth::Cascade before{12.2, 13.4};
    const depth::Cascade end{14.7, 14.99};
    EXPECT_GT(apart(sharp, blurred, sharp, end), 500);
    EXPECT_LT(4 * apart(blended, blurred, sharp, end), apart(blended, sharp, sharp, end));
    EXPECT_LT(apart(blended, sharp, sharp, before), 100);
}

TEST_F(FocusTest, IsOneImageHoweverSubmitted) {
    const scene::Scene scene = alleyScene();
    const render::GpuScene gpuScene(device(), scene);
    std::set<std::string> images;
    for (const Focus& focus : {kFocus, kBlended}) {
        std::set<std::string> ofFocus;
        for (const render::Submission submission : submissions()) {
            for (const std::size_t threads : {1u, 3u}) {
                // The last cascade is empty, which only the CPU knows.
                RenderOptions options = focused(focus, "at:5,7.5,15,30,300");
                options.submission = submission;
                options.threads = threads;
                ofFocus.insert(hashOf(draw(scene, gpuScene, kFocusCamera, options)));
            }
        }
        EXPECT_EQ(ofFocus.size(), 1u);
        images.merge(ofFocus);
    }
    EXPECT_EQ(images.size(), 2u);
}

TEST_F(FocusTest, LayersMayChangeTheirSizeWhileFramesAreInFlight) {
    const scene::Scene scene = alleyScene();
    RenderOptions options = focused(kBlended, "count:4");
    options.framesInFlight = 3;
    SoleRenderer renderer(device(), scene, options);
    scene::Camera camera = kFocusCamera;
    for (const double nearView : {0.5, 2.0, 4.0, 9.0, 0.2, 0.5}) {
        camera.nearView = nearView;
        renderer.submit(camera);
    }
    EXPECT_EQ(hashOf(renderer.render(camera)), hashOf(draw(scene, camera, focused(kBlended, "count:4"))));
}

TEST_F(FocusTest, TranslucentSurfacesAreLaidOverIt) {
    scene::Scene scene = alleyScene();
    const Frame before = draw(scene, kFocusCamera, focused(kFocus));
    scene.materials.push_back({.name = "glass",
                               .baseColorFactor = glm::vec4(1.0f, 0.0f, 0.0f, 0.5f),
                               .unlit = true,
                               .alphaMode = scene::AlphaMode::blend});
    const auto glass = static_cast<std::uint32_t>(scene.materials.size() - 1);
    scene::addInstance(scene, 0, glass, 100, glm::dvec3(0.0, -1.0, -8.0), glm::mat3(1.0f));
    const Frame after = draw(scene, kFocusCamera, focused(kFocus));
    EXPECT_EQ(before.ids().pixels, after.ids().pixels);
    std::size_t reddened = 0;
    for (std::size_t i = 0; i < after.color.pixels.size(); ++i) {
        reddened += after.color.pixels[i][0] > before.color.pixels[i][0] + 10 &&
                            after.color.pixels[i][1] + 10 < before.color.pixels[i][1]
                        ? 1
                        : 0;
    }
    EXPECT_GT(reddened, 200u);
}

TEST_F(FocusTest, RefusesWhatCannotBe) {
    const scene::Scene scene = boxScene();
    for (const render::TargetsKind targets : render::kTargetsKinds) {
        RenderOptions options = focused(kFocus);
        options.targets = targets;
        if (targets != render::TargetsKind::layers) {
            EXPECT_THROW(draw(scene, kFocusCamera, options), base::InputError) << nameOf(targets);
        }
    }
    RenderOptions occluded = focused(kFocus);
    occluded.effects.occlusion.radius = 1.0;
    EXPECT_THROW(draw(scene, kFocusCamera, occluded), base::InputError);
    for (const double wrong : {-1.0, kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(draw(scene, kFocusCamera, focused({.distance = wrong, .aperture = 1.0})),
                     base::InputError);
        EXPECT_THROW(draw(scene, kFocusCamera, focused({.distance = 1.0, .aperture = wrong})),
                     base::InputError);
    }
}

} // namespace

} // namespace cdr::render_test
