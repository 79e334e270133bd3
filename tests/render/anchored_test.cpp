#include "fixture.h"
#include "snapping.h"

#include <scenes/cubes.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace cdr::render_test {

namespace {

using render::Frame;

class AnchoredTest : public RenderTest {
  protected:
    static depth::Technique technique(depth::Mapping mapping, const char* split = "fitted",
                                      depth::DepthFormat format = depth::DepthFormat::d32f) {
        return depth::Technique{mapping, depth::parseSplit(split), format};
    }
};

/// The scene of the thesis that no float32 view distance gets right, and the same with something near.
TEST_F(AnchoredTest, AfcHasNoWrongPixelsEvenWithSomethingBesideTheCamera) {
    for (const scene::SceneSetup& setup : {scenes::makeAfc(2013), scenes::makeAfcNear(2013)}) {
        std::map<std::uint32_t, measure::TruthImage> truths; // by frame
        for (const std::uint32_t number : {0u, 1u, 120u}) {
            truths[number] = truthOf(setup.scene, setup.path.at(number), 1280, 720);
        }
        const render::GpuScene gpuScene(device(), setup.scene);
        for (const auto format : available({depth::DepthFormat::d32f, depth::DepthFormat::d24})) {
            auto anchored = depth::parseTechnique("anchored");
            anchored.format = format;
            render::Renderer renderer(device(), setup.scene, gpuScene, {.technique = anchored});
            measure::WrongPixels wrong;
            for (const auto& [number, truth] : truths) {
                const Frame frame = renderer.render(setup.path.at(number));
                wrong += measure::countWrong(frame.ids(), truth);
                if (setup.scene.name == "afc-near") {
                    EXPECT_EQ(frame.id(frame.width() - 1, 0), 1001u + number);
                    EXPECT_EQ(frame.cascades.size(), 2u);
                }
            }
            EXPECT_GT(wrong.pixels, 500'000u);
            EXPECT_LE(wrong.fraction(), 5e-6) << setup.scene.name << " " << nameOf(format);
        }
    }
}

TEST_F(AnchoredTest, FittedSplitsDrawRightUnderEveryMapping) {
    scene::SceneSetup setup = scenes::makeRotation(5, 64'000);
    const scene::Camera camera = setup.path.at(0);
    const render::GpuScene gpuScene(device(), setup.scene);
    const auto truth = truthOf(setup.scene, camera);
    for (const depth::Mapping mapping : depth::kMappings) {
        for (const char* split : {"fitted", "fitted:1e-5px", "fitted:0.5px", "fitted:0.001", "minimax:5"}) {
            const auto options = smallOptions(technique(mapping, split));
            const auto wrong = measure::countWrong(draw(setup.scene, gpuScene, camera, options).ids(), truth);
            EXPECT_GT(wrong.pixels, 5000u);
            EXPECT_EQ(wrong.wrong, 0u) << nameOf(options.technique);
        }
    }
}

/// Reversed alone gives 16 bits to everything from 10^6 to infinity; fitted, they serve the field.
TEST_F(AnchoredTest, AFittedReversedRangeEndsAtItsFarPlane) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    const scene::Camera camera = setup.path.at(0);
    const auto reversed = technique(depth::Mapping::reversed, "fitted", depth::DepthFormat::d16);
    const Frame frame = draw(setup.scene, camera, {.technique = reversed});
    EXPECT_LT(wrongIn(frame, setup.scene, camera).fraction(), 0.005);
}

/// Boxes from 0.01 to 10^8 units away, each a fifth of its distance wide. Inside each is a smaller box, whose
/// faces lie `share` of the distance below those of the outer one.
scene::Scene scatteredScene(double share) {
    scene::Scene scene = boxScene();
    int place = -2;
    for (const double w : {0.01, 1.0, 1e3, 1e6, 1e8}) {
        const glm::dvec3 centre(0.3 * place++ * w, 0.0, -w);
        addBox(scene, centre, glm::mat3(static_cast<float>(0.2 * w)));
        // Drawn last, so that a tie is wrong.
        addBox(scene, centre, glm::mat3(static_cast<float>((0.2 - 2.0 * share) * w)));
    }
    return scene;
}

/// Gaps between cascades, surfaces that begin and end exactly where they do, and what else fails there.
TEST_F(AnchoredTest, ObjectsScatteredOverTenDecadesAreRightUnderAnchoredAlone) {
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.001, .farView = 1e9};
    for (const double share : {1e-6, 1e-7}) {
        const scene::Scene scene = scatteredScene(share);
        const auto truth = truthOf(scene, camera);
        for (const depth::NamedTechnique& preset : depth::presets()) {
            const Frame frame = draw(scene, camera, smallOptions(preset.technique));
            const auto wrong = measure::countWrong(frame.ids(), truth);
            EXPECT_GT(wrong.pixels, 10'000u);
            if (preset.name == "anchored") {
                EXPECT_EQ(wrongBeyond(frame.ids(), truth, snapReach(device())), 0u) << share;
                EXPECT_EQ(frame.cascades.size(), 5u);
            } else if (share < 1e-6) {
                EXPECT_GT(wrong.wrong, 0u) << preset.name;
            }
        }
    }
}

TEST_F(AnchoredTest, OneObjectAroundTheCameraAndToTheHorizonHasNoCracks) {
    if (!drawsToTheHorizon(device())) {
        return leaveOut("floors to the horizon");
    }
    const scene::Scene scene = boxesOnAFloor(2e5f);
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.01, .farView = 1e6};
    const auto truth = truthOf(scene, camera);
    for (const depth::Mapping mapping : depth::kMappings) {
        const auto wrong =
            measure::countWrong(draw(scene, camera, smallOptions(technique(mapping))).ids(), truth);
        EXPECT_GT(wrong.pixels, 30'000u);
        EXPECT_EQ(wrong.wrong, 0u) << nameOf(mapping);
    }
}

TEST_F(AnchoredTest, ThinCascadesLeaveNoSeamInAFloorToTheHorizon) {
    if (!drawsToTheHorizon(device())) {
        return leaveOut("floors to the horizon");
    }
    scene::Scene scene = boxScene();
    addBox(scene, {0.0, -2.5, 0.0}, glm::mat3(2e5f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 2e5f));
    std::vector<std::pair<scene::Camera, measure::TruthImage>> views;
    for (int i = 0; i < 4; ++i) {
        const scene::Camera camera = scene::lookAt({.fovY = 1.0, .nearView = 0.5, .farView = 1e5},
                                                   glm::dvec3(0.0), {0.3, -0.05 - 0.02 * i, -1.0});
        views.emplace_back(camera, truthOf(scene, camera));
    }
    // Pixels that the floor leaves to the sky, under 64 cascades in all views.
    const auto seams = [&](render::RenderOptions options) {
        options.technique.split = depth::parseSplit("count:64");
        SoleRenderer renderer(device(), scene, options);
        std::uint64_t wrong = 0;
        for (const auto& [camera, truth] : views) {
            wrong += measure::countWrong(renderer.render(camera).ids(), truth).wrong;
        }
        return wrong;
    };
    for (const depth::Mapping mapping : depth::kMappings) {
        EXPECT_EQ(seams(smallOptions(technique(mapping))), 0u) << nameOf(mapping);
    }
    for (const render::TargetsKind targets : render::kTargetsKinds) {
        render::RenderOptions options = smallOptions(technique(depth::Mapping::anchored));
        options.targets = targets;
        EXPECT_EQ(seams(options), 0u) << nameOf(targets);
        options.surface = render::SurfacePath::visibility;
        EXPECT_EQ(seams(options), 0u) << nameOf(targets) << ", visibility";
    }
}

/// The face of a box whose centre lies thousands of cascades behind it, so float32 rounds differently in each.
TEST_F(AnchoredTest, ThinCascadesLeaveNoSeamInTheFaceOfALargeBox) {
    constexpr double kSize = 1.2e6;
    scene::Scene scene = boxScene();
    const glm::dvec3 facing = glm::normalize(glm::dvec3(-1e-5, 3e-5, 1.0));
    const glm::dvec3 across = glm::normalize(glm::cross(facing, glm::dvec3(0.3, 1.0, 0.0)));
    addBox(scene, {0.0, 0.0, -1'000'105.0 - 0.5 * kSize},
           glm::mat3(kSize * glm::dmat3(across, glm::cross(facing, across), facing)));
    std::vector<std::pair<scene::Camera, measure::TruthImage>> views;
    for (int i = 0; i < 4; ++i) {
        const scene::Camera camera{
            .position = {0.0, 0.0, 0.0137 * i}, .fovY = 0.5, .nearView = 1e6, .farView = 1'000'200.0};
        views.emplace_back(camera, truthOf(scene, camera));
        EXPECT_EQ(views.back().second.at(240, 135).id, 1u);
    }
    // Pixels that the face leaves to the sky, in all views.
    const auto seams = [&](render::RenderOptions options) {
        options.technique.split = depth::parseSplit("at:1000100.03125");
        SoleRenderer renderer(device(), scene, options);
        std::uint64_t wrong = 0;
        for (const auto& [camera, truth] : views) {
            const Frame frame = renderer.render(camera);
            EXPECT_EQ(frame.cascades.size(), 2u);
            wrong += measure::countWrong(frame.ids(), truth).wrong;
        }
        return wrong;
    };
    for (const depth::Mapping mapping : depth::kMappings) {
        EXPECT_EQ(seams(smallOptions(technique(mapping))), 0u) << nameOf(mapping);
    }
    const auto anchored = smallOptions(technique(depth::Mapping::anchored));
    for (const render::Submission submission : submissions()) {
        render::RenderOptions options = anchored;
        options.submission = submission;
        EXPECT_EQ(seams(options), 0u) << nameOf(submission);
    }
    for (const render::TargetsKind targets : render::kTargetsKinds) {
        for (const auto surface : {render::SurfacePath::gbuffer, render::SurfacePath::visibility}) {
            render::RenderOptions options = anchored;
            options.targets = targets;
            options.surface = surface;
            EXPECT_EQ(seams(options), 0u) << nameOf(targets) << " " << nameOf(surface);
        }
    }
}

TEST_F(AnchoredTest, ACameraThatSeesNothingOrFarFromTheOriginStillDraws) {
    scene::Scene scene = boxScene();
    const glm::dvec3 far(1e12, -3e11, 2e11);
    addBox(scene, far + glm::dvec3(0.0, 0.0, -10.0));
    const auto options = smallOptions(depth::parseTechnique("anchored"));
    const scene::Camera away{.position = far, .back = {0.0, 0.0, -1.0}, .fovY = 0.2};
    EXPECT_EQ(draw(scene, away, options).cascades.size(), 1u);
    const scene::Camera camera{.position = far, .fovY = 0.2};
    const Frame frame = draw(scene, camera, options);
    EXPECT_EQ(wrongIn(frame, scene, camera).wrong, 0u);
    // Positions at 10^12 are multiples of 1.2e-4.
    EXPECT_NEAR(frame.distanceView(240, 135), 9.5, 3e-4);
}

TEST_F(AnchoredTest, PickingACubeAMillionUnitsAwayIsExactToATenthOfAMillimetre) {
    scene::Scene scene = boxScene();
    const glm::dvec3 centre(3.0, -7.0, 11.0);
    addBox(scene, centre);
    const glm::dvec3 eye = centre + 1e6 * glm::normalize(glm::dvec3(0.5, 0.6, 0.7));
    const scene::Camera camera =
        scene::lookAt({.fovY = 2e-6, .nearView = 0.001, .farView = 2e6}, eye, centre);
    const double pixel = 2e-6 * 1e6 / 270;
    const double snapped = std::numbers::sqrt2 * snapReach(device()) * pixel;
    for (const auto format : available({depth::DepthFormat::d32f, depth::DepthFormat::d24})) {
        auto anchored = depth::parseTechnique("anchored");
        anchored.format = format;
        const Frame frame = draw(scene, camera, smallOptions(anchored));
        double nearestToCorner = 1.0;
        std::size_t picked = 0;
        for (std::uint32_t y = 0; y < frame.height(); ++y) {
            for (std::uint32_t x = 0; x < frame.width(); ++x) {
                const auto pick = frame.pick(x, y);
                ASSERT_EQ(pick.has_value(), frame.id(x, y) != 0);
                if (!pick) {
                    continue;
                }
                ++picked;
                EXPECT_EQ(pick->object, 0u);
                const glm::dvec3 local = pick->position - centre;
                // Where the ray through the pixel's centre meets the plane of the face the normal names.
                int axis = 0;
                for (int i = 1; i < 3; ++i) {
                    axis = pick->normal[i] > pick->normal[axis] ? i : axis;
                }
                EXPECT_NEAR(pick->normal[axis], 1.0, 1e-3);
                const glm::dvec3 ray = pick->position - eye;
                const glm::dvec3 expected = eye + ray * ((centre[axis] + 0.5 - eye[axis]) / ray[axis]);
                // A face moved by what the device snaps, a diagonal at most.
                const double facing = camera.back[axis];
                const double tolerance = 1e-4 + snapped * std::sqrt(1.0 - facing * facing) / facing;
                ASSERT_LT(glm::distance(pick->position, expected), tolerance) << x << " " << y;
                EXPECT_NEAR(pick->distanceView, camera.viewDistance(expected), tolerance);
                nearestToCorner = std::min(nearestToCorner, glm::distance(local, glm::dvec3(0.5)));
            }
        }
        EXPECT_GT(picked, 10'000u);
        // The corner that points at the camera is seen from as near as a pixel's centre gets.
        EXPECT_LT(nearestToCorner, pixel);
    }
}

} // namespace

} // namespace cdr::render_test
