#include "cameras.h"

#include <cdr/base/suggest.h>
#include <viewer/state/camera/fly_controller.h>
#include <viewer/state/camera/lens_zoom.h>
#include <viewer/state/command_line.h>
#include <viewer/state/shown_picture.h>

#include <algorithm>
#include <memory>
#include <random>
#include <sstream>

namespace cdr::viewer {

namespace {

using namespace viewer_test;

const scene::Camera kOwn = cameraWith(60.0, {0.0, 0.0, 10.0}, glm::dvec3(0.0));

ReproducedView viewWith(const scene::Camera& camera) {
    return {.settings = {}, .side = 0, .camera = camera, .sceneCamera = kOwn, .extent = {640, 360}};
}

/// The value of an option in a line without quotes; empty without the option.
std::string valueOf(const std::string& line, const std::string& option) {
    std::istringstream words(line);
    for (std::string word; words >> word;) {
        if (word.starts_with(option + "=")) {
            return word.substr(option.size() + 1);
        }
    }
    return "";
}

glm::dvec3 pointIn(const std::string& text) {
    glm::dvec3 point;
    std::istringstream parts(text);
    for (int i = 0; i < 3; ++i) {
        std::string part;
        std::getline(parts, part, ',');
        point[i] = base::parseNumber("point", part);
    }
    return point;
}

/// The camera that `cdr render` makes of a line.
scene::Camera cameraIn(const std::string& line) {
    scene::Camera camera = kOwn;
    if (const std::string fov = valueOf(line, "--fov"); !fov.empty()) {
        camera.fovY = scene::radiansOf(base::parseNumber("fov", fov));
    }
    if (const std::string eye = valueOf(line, "--eye"); !eye.empty()) {
        const glm::dvec3 forward = pointIn(valueOf(line, "--direction"));
        const std::string up = valueOf(line, "--up");
        camera = up.empty() ? scene::lookAlong(camera, pointIn(eye), forward)
                            : scene::lookAlong(camera, pointIn(eye), forward, pointIn(up));
    }
    return camera;
}

TEST(RenderCommand, KeepsTheTexturesBudget) {
    ReproducedView view = viewWith(kOwn);
    EXPECT_EQ(renderCommand(view, "a.png").find("--texture-memory"), std::string::npos);
    view.settings.scene = "model.glb";
    view.settings.choice.textureMiB = 64;
    EXPECT_EQ(valueOf(renderCommand(view, "a.png"), "--texture-memory"), "64");
}

TEST(RenderCommand, KeepsTheColorOfFog) {
    ReproducedView view = viewWith(kOwn);
    view.settings.drawing.effects.fog.visibility = 30.0;
    EXPECT_EQ(valueOf(renderCommand(view, "a.png"), "--fog"), "30");
    view.settings.drawing.effects.fog.color = {1.0f, 0.0f, 0.25f};
    EXPECT_EQ(valueOf(renderCommand(view, "a.png"), "--fog"), "30,1,0,0.25");
}

TEST(RenderCommand, KeepsTheRadiusOfPoints) {
    ReproducedView view = viewWith(kOwn);
    EXPECT_EQ(renderCommand(view, "a.png").find("--points"), std::string::npos);
    view.settings.scene = "model.glb";
    view.settings.choice.pointRadius = 0.1;
    EXPECT_EQ(valueOf(renderCommand(view, "a.png"), "--points"), "0.1");
}

TEST(RenderCommand, KeepsWhoBendsMeshes) {
    ReproducedView view = viewWith(kOwn);
    EXPECT_EQ(renderCommand(view, "a.png").find("--deform"), std::string::npos);
    view.settings.deform = scenes::Deform::device;
    EXPECT_EQ(renderCommand(view, "a.png").find("--deform"), std::string::npos) << "nothing bends in afc";
    view.settings.scene = "model.glb";
    EXPECT_EQ(valueOf(renderCommand(view, "a.png"), "--deform"), "device");
}

/// cdr render refuses limits of what is not drawn.
TEST(RenderCommand, LeavesOutLimitsOfWhatIsOff) {
    ReproducedView view = viewWith(kOwn);
    view.settings.drawing.shadows.maxTexels = 512;
    view.settings.drawing.translucency.maxBytes = std::uint64_t{8} << 20u;
    const std::string line = renderCommand(view, "a.png");
    EXPECT_EQ(line.find("--shadow-texels"), std::string::npos) << line;
    EXPECT_EQ(line.find("--translucency-memory"), std::string::npos) << line;
    view.settings.drawing.shadows.method = render::ShadowMethod::anchored;
    view.settings.drawing.translucency.method = render::Translucency::sorted;
    EXPECT_EQ(valueOf(renderCommand(view, "a.png"), "--shadow-texels"), "512");
    EXPECT_EQ(valueOf(renderCommand(view, "a.png"), "--translucency-memory"), "8");
}

TEST(RenderCommand, SaysTheLayersThatWereChosen) {
    ReproducedView view = viewWith(kOwn);
    view.settings.layers = {{"paint", 0.002f}, {"road sign", -1.5f}, {"#3", 0.0f}};
    const std::string line = renderCommand(view, "a.png");
    EXPECT_NE(line.find("--layer=paint=0.002 '--layer=road sign=-1.5' '--layer=#3=0'"), std::string::npos)
        << line;
}

TEST(RenderCommand, LeavesOutWhatIsTheScenesOwn) {
    EXPECT_EQ(renderCommand(viewWith(kOwn)),
              "cdr render rotation --technique=anchored --size=640x360 --output=view.png");
}

TEST(RenderCommand, SaysEverythingThatIsChosen) {
    ReproducedView view = viewWith(kOwn);
    view.settings.scene = "my scene.glb";
    view.settings.technique = depth::Technique{
        depth::Mapping::anchoredReversed, depth::parseSplit("fitted:0.5px,max=3"), depth::DepthFormat::d24};
    view.settings.drawing.targets = render::TargetsChoice::pool(4);
    view.settings.drawing.submission = render::Submission::primaries;
    view.settings.drawing.batching = render::Batching::perObject;
    view.settings.drawing.snapping = render::Snapping::inPlane;
    view.settings.drawing.threads = 2;
    view.settings.seed = 5;
    view.settings.view = ViewKind::ids;
    EXPECT_EQ(
        renderCommand(view, "a b.png"),
        "cdr render 'my scene.glb' --depth=anchored-reversed --split=fitted:0.5px,max=3 --format=d24 "
        "--targets=pool:4 --submission=primaries --batching=per-object --snapping=in-plane --threads=2 --seed=5 "
        "--size=640x360 --aov=id '--output=a b.png'");
    view.settings.second = depth::parseTechnique("logcdr");
    view.side = 1;
    EXPECT_EQ(valueOf(renderCommand(view), "--technique"), "logcdr");
}

TEST(RenderCommand, SaysTheFrameOfASceneThatMovesAndTheCameraThere) {
    ReproducedView view = viewWith(kOwn);
    view.frame = 7;
    view.sceneCamera.position.x = 3.0;
    EXPECT_EQ(valueOf(renderCommand(view), "--frame"), "7");
    EXPECT_EQ(cameraIn(renderCommand(view)).position, kOwn.position);
    EXPECT_NE(valueOf(renderCommand(view), "--eye"), "");
}

/// `cdr render --frame 7` begins with the camera that the scene has there, whose lens may be another than at frame 0.
TEST(RenderCommand, SaysTheLensThatTheScenesOwnHasNotAtThatFrame) {
    auto scene = std::make_shared<scene::OpenedScene>();
    scene->setup.path = {.frames = 10, .at = [](std::uint32_t frame) {
                             scene::Camera camera = kOwn;
                             camera.fovY = scene::radiansOf(60.0 - frame);
                             camera.nearView = frame == 0 ? kOwn.nearView : 2.0 * kOwn.nearView;
                             return camera;
                         }};
    RenderResult result;
    result.scene = scene;
    result.camera = kOwn;
    result.frame = 7;
    result.sides.emplace_back();
    PictureModel picture;
    picture.shown = std::make_shared<const RenderResult>(result);
    const std::string held = commandLinesOf(picture);
    EXPECT_EQ(cameraIn(held).fovY, kOwn.fovY) << held;
    EXPECT_NE(valueOf(held, "--fov"), "") << held;
    EXPECT_NE(valueOf(held, "--near"), "") << held;
    EXPECT_EQ(valueOf(held, "--far"), "") << held;
    result.camera = scene->setup.path.at(7);
    picture.shown = std::make_shared<const RenderResult>(result);
    const std::string followed = commandLinesOf(picture);
    EXPECT_EQ(valueOf(followed, "--fov"), "") << followed;
    EXPECT_EQ(valueOf(followed, "--near"), "") << followed;
}

TEST(RenderCommand, MapsViewsToOutputs) {
    ReproducedView view = viewWith(kOwn);
    const std::pair<ViewKind, const char*> kinds[] = {
        {ViewKind::shaded, ""}, {ViewKind::cascades, "cascade"}, {ViewKind::distance, "distance"},
        {ViewKind::ids, "id"},  {ViewKind::wrong, "wrong"},      {ViewKind::flips, ""}};
    for (const auto& [kind, aov] : kinds) {
        view.settings.view = kind;
        EXPECT_EQ(valueOf(renderCommand(view), "--aov"), aov);
    }
}

TEST(RenderCommand, BringsFlownCamerasBackToTheBit) {
    std::mt19937 random(3);
    const auto uniform = [&] { return static_cast<double>(random()) * 0x1p-31 - 1.0; };
    scene::Camera camera = kOwn;
    double surface = 1e4;
    for (int i = 0; i < 3000; ++i) {
        CameraInput input{.keys = {CameraKey::backward, CameraKey::right}, .seconds = 0.05};
        input.drag = {200.0 * uniform(), 90.0 * uniform()};
        input.lens = 2.0 * uniform();
        input.cursor = {640.0 + 600.0 * uniform(), 360.0 + 300.0 * uniform()};
        camera = zoomLens(fly(camera, input, surface), input);
        surface = std::min(surface * 1.01, 1e9);
        expectSame(cameraIn(renderCommand(viewWith(camera))), camera);
        ASSERT_FALSE(testing::Test::HasFailure()) << i << renderCommand(viewWith(camera));
    }
    EXPECT_GT(glm::length(camera.position), 1e6); // far out, where a target would not do
}

TEST(RenderCommand, BringsRolledCamerasBackToTheBit) {
    for (int i = 1; i < 500; ++i) {
        scene::Camera camera = scene::lookAlong(kOwn, {1e8 / i, -3.0, 1e-7 * i}, {std::sin(i), 0.4, -1.0},
                                                {std::cos(3.0 * i), std::sin(3.0 * i), 0.1});
        camera.fovY = scene::radiansOf(0.1 * i);
        camera = scene::canonical(camera);
        const std::string line = renderCommand(viewWith(camera));
        EXPECT_NE(line.find("--up="), std::string::npos);
        expectSame(cameraIn(line), camera);
        ASSERT_FALSE(testing::Test::HasFailure()) << i << line;
    }
}

TEST(RenderCommand, AFileThatBeginsWithAMinusIsNoOption) {
    ReproducedView view = viewWith(kOwn);
    view.settings.scene = "-o.glb";
    EXPECT_EQ(renderCommand(view).substr(0, 19), "cdr render ./-o.glb");
}

} // namespace

} // namespace cdr::viewer
