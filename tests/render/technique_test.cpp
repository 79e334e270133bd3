#include "fixture.h"
#include "snapping.h"

#include <scenes/cubes.h>

#include <map>

namespace cdr::render_test {

namespace {

using render::Frame;

class TechniqueTest : public RenderTest {};

/// The thesis' order on its own scene: the reason this project exists.
TEST_F(TechniqueTest, AfcWrongPixelsComeInTheThesisOrder) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    const render::GpuScene gpuScene(device(), setup.scene);
    std::map<std::string, measure::WrongPixels> wrong;
    for (const std::uint32_t number : {0u, 120u, 240u}) {
        const scene::Camera camera = setup.path.at(number);
        const auto truth = truthOf(setup.scene, camera, 1280, 720);
        for (const auto& [name, technique] : depth::presets()) {
            wrong[nameOf(technique)] += measure::countWrong(
                draw(setup.scene, gpuScene, camera, {.technique = technique}).ids(), truth);
        }
    }
    EXPECT_GT(wrong["standard"].fraction(), 0.20);
    EXPECT_GT(wrong["cdr"].fraction(), 0.10);
    EXPECT_LT(wrong["cdr"].fraction(), std::min(0.30, wrong["standard"].fraction().value()));
    EXPECT_GT(wrong["log"].fraction(), 0.008);
    EXPECT_LT(wrong["log"].fraction(), 0.03);
    EXPECT_LT(wrong["logcdr"].fraction(), 0.01);
    EXPECT_LT(wrong["reversed"].fraction(), 0.001);
    EXPECT_LT(wrong["logcdr"].fraction(), wrong["log"].fraction());
    EXPECT_LT(wrong["reversed"].fraction(), wrong["logcdr"].fraction());
}

TEST_F(TechniqueTest, CubesFailUnderStandardAlone) {
    const scene::SceneSetup setup = scenes::makeCubes(2013);
    const scene::Camera camera = setup.path.at(0);
    const auto truth = truthOf(setup.scene, camera);
    for (const auto& [name, technique] : depth::presets()) {
        const auto wrong =
            measure::countWrong(draw(setup.scene, camera, smallOptions(technique)).ids(), truth);
        if (nameOf(technique) == "standard") {
            EXPECT_GT(wrong.overlapFraction(), 0.6);
        } else {
            EXPECT_LT(wrong.fraction(), 0.01) << nameOf(technique);
        }
    }
}

/// Before the first frame, in the words of the split's text.
TEST_F(TechniqueTest, ARendererRefusesASplitOutOfRange) {
    for (const depth::Split& split :
         {depth::Split(depth::SplitCount{0}), depth::Split(depth::SplitRatio{1.0}),
          depth::Split(depth::SplitFitted{.target = 0.0})}) {
        EXPECT_EQ(refusalOf(boxScene(), thumbnailOptions({depth::Mapping::anchored, split})),
                  depth::tryParseSplit(nameOf(split)).refusal().message);
    }
}

/// Every mapping, split and format draws an easy scene right, in one pass too; this is what finds a wrong sign or a swapped
/// plane.
TEST_F(TechniqueTest, EveryMappingSplitAndFormatDrawsAnEasySceneRight) {
    scene::SceneSetup setup = scenes::makeRotation(5, 20'000);
    scene::Camera camera = setup.path.at(0);
    camera.nearView = 1.0;
    camera.farView = 500.0;
    const render::GpuScene gpuScene(device(), setup.scene);
    const auto truth = truthOf(setup.scene, camera);
    const auto expectRight = [&](const depth::Technique& technique, render::TargetsKind targets) {
        render::RenderOptions options = smallOptions(technique);
        options.targets = targets;
        const auto wrong = measure::countWrong(draw(setup.scene, gpuScene, camera, options).ids(), truth);
        EXPECT_GT(wrong.pixels, 3000u);
        // 16 bits over a ratio of 500 do fail here and there.
        const double allowed = technique.format == depth::DepthFormat::d16 ? 0.01 : 0.0;
        EXPECT_LE(wrong.fraction(), allowed)
            << nameOf(technique) << " " << nameOf(technique.format) << " " << nameOf(targets);
    };
    for (const depth::Mapping mapping : depth::kMappings) {
        for (const char* split : {"none", "count:7", "count:40", "at:50,120"}) {
            for (const depth::DepthFormat format : available(depth::kDepthFormats)) {
                const depth::Technique technique{mapping, depth::parseSplit(split), format};
                expectRight(technique, render::TargetsKind::single);
                if (format != depth::DepthFormat::d16) { // too few for slices
                    expectRight(technique, render::TargetsKind::onePass);
                }
            }
        }
    }
}

/// If the logarithm were set at the floor's corners alone, it would be wrong everywhere.
TEST_F(TechniqueTest, LogDepthIsRightOnTrianglesThatCrossTheNearPlane) {
    if (!drawsToTheHorizon(device())) {
        return leaveOut("floors to the horizon");
    }
    const scene::Scene scene = boxesOnAFloor(20000.0f);
    scene::Camera camera{.fovY = 1.0, .nearView = 0.01, .farView = 1e6};
    for (const char* name : {"log", "logcdr"}) {
        const auto wrong =
            wrongIn(draw(scene, camera, smallOptions(depth::parseTechnique(name))), scene, camera);
        EXPECT_GT(wrong.pixels, 30'000u);
        EXPECT_EQ(wrong.wrong, 0u) << name;
    }
}

/// Objects that straddle every boundary, close up: no crack may show the background through them.
TEST_F(TechniqueTest, CascadesLeaveNoCracks) {
    scene::Scene scene = boxScene();
    const glm::mat3 wall(4000.0f, 0.0f, 0.0f, 0.0f, 4000.0f, 0.0f, 1500.0f, 700.0f, 1.0f);
    addBox(scene, glm::dvec3(0.0, 0.0, -1200.0), wall);
    const glm::mat3 slope(3000.0f, 0.0f, 0.0f, 0.0f, 0.5f, 0.0f, 0.0f, 300.0f, 5000.0f);
    addBox(scene, glm::dvec3(0.0, -100.0, -2400.0), slope);
    const scene::Camera camera{.fovY = 1.0, .nearView = 0.1, .farView = 1e5};
    const auto truth = truthOf(scene, camera);
    for (const depth::Mapping mapping : depth::kMappings) {
        for (const char* split : {"count:5", "count:16", "ratio:3"}) {
            const auto technique =
                depth::Technique{mapping, depth::parseSplit(split), depth::DepthFormat::d32f};
            const auto wrong = measure::countWrong(draw(scene, camera, smallOptions(technique)).ids(), truth);
            EXPECT_GT(wrong.pixels, 40'000u);
            EXPECT_EQ(wrong.wrong, 0u) << nameOf(technique);
        }
    }
}

} // namespace

} // namespace cdr::render_test
