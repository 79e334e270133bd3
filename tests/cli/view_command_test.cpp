#include "program.h"

#include <cdr/render/renderer.h>
#include <cdr/scene/camera_recording.h>
#include <scenes/cubes.h>
#include <scenes/mixed.h>
#include <scenes/moving_scene.h>
#include <scenes/open_scene.h>
#include <scenes/traffic.h>
#include <viewer/state/camera/fly_controller.h>
#include <viewer/state/camera/heading.h>
#include <viewer/state/camera/lens_zoom.h>
#include <viewer/state/command_line.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <output/aov.h>

#include <algorithm>
#include <filesystem>
#include <set>

// GCC 12 takes an optional string that is empty for uninitialised.
#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ == 12
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace cdr::cli_test {

namespace {

using nlohmann::json;

constexpr viewer::PictureExtent kExtent{320, 180};

/// A scene on a device of this program's own, and what the viewer would show of it.
class ViewCommand : public FolderTest {
  protected:
    render::Frame show(const scene::Scene& scene, const viewer::ReproducedView& view) {
        const render::GpuScene onDevice(m_device, scene);
        render::Renderer renderer(m_device, scene, onDevice,
                                  viewer::renderOptions(view.settings, view.side, view.extent));
        return renderer.render(view.camera);
    }

    /// Runs the command line that the viewer copies, as a shell reads it.
    json pictureOf(const viewer::ReproducedView& view) const {
        const std::string line = viewer::renderCommand(view);
        EXPECT_EQ(line.find("cdr "), 0u);
        const ProgramResult result = succeed(line.substr(4) + " --json r.json");
        EXPECT_TRUE(std::filesystem::remove(at("view.png")));
        return result.status == 0 ? jsonIn("r.json")["results"][0] : json();
    }

  private:
    gpu::Instance m_instance{{.validate = false, .extensions = {}}};
    gpu::Device m_device{m_instance, ""};
};

scene::Camera flown(scene::Camera camera, double surfaceView) {
    const viewer::CameraInput input{.keys = {viewer::CameraKey::right, viewer::CameraKey::backward},
                                    .drag = {-7.0, 5.0},
                                    .cursor = {200.0, 60.0},
                                    .scroll = -2.0,
                                    .seconds = 0.1,
                                    .extent = kExtent};
    return viewer::zoomLens(viewer::fly(camera, input, surfaceView), input);
}

/// To the bit, with a lens of a fifty-thousandth of a degree per pixel, a million units away.
TEST_F(ViewCommand, DrawsTheViewersPictureToTheBit) {
    for (const char* technique : {"anchored", "reversed", "logcdr"}) {
        const scene::SceneSetup setup = scenes::makeAfc(scenes::kDefaultSeed);
        viewer::ReproducedView view{.settings = {.scene = "afc"},
                                    .side = 0,
                                    .camera = flown(setup.path.at(0), 1e6),
                                    .sceneCamera = setup.path.at(0),
                                    .extent = kExtent};
        view.settings.technique = depth::parseTechnique(technique);
        const render::Frame frame = show(setup.scene, view);
        const auto lit = std::count_if(frame.color.pixels.begin(), frame.color.pixels.end(),
                                       [](const image::Rgba8& p) { return p[0] > 60; });
        EXPECT_GT(lit, 1000) << technique;
        EXPECT_EQ(pictureOf(view)["hash"], output::hashOf(frame, output::Aov::color, nullptr)) << technique;
        // Moved by a ten-millionth of a degree, it is another picture: the bits do matter.
        view.camera =
            viewer::lookingAlong(view.camera, viewer::turned(viewer::headingOf(view.camera), 2e-9, 0.0));
        EXPECT_NE(pictureOf(view)["hash"], output::hashOf(frame, output::Aov::color, nullptr));
    }
}

TEST_F(ViewCommand, DrawsTheFrameOfASceneThatMoves) {
    const scene::SceneSetup setup = scenes::makeTraffic(scenes::kDefaultSeed);
    scenes::MovingScene moving(setup.scene, setup.motion);
    platform::WorkerPool workers(1);
    moving.show(5, workers);
    viewer::ReproducedView view{.settings = {.scene = "traffic"},
                                .side = 0,
                                .camera = scene::canonical(setup.path.at(5)),
                                .sceneCamera = setup.path.at(5),
                                .extent = kExtent,
                                .frame = 5};
    const render::Frame frame = show(moving.world().scene(), view); // of a scene built from scratch
    const std::string hash = output::hashOf(frame, output::Aov::color, nullptr);
    EXPECT_EQ(pictureOf(view)["hash"], hash);
    view.frame = 6;
    EXPECT_NE(pictureOf(view)["hash"], hash);
}

TEST_F(ViewCommand, DrawsARolledViewOfTheRightSideOfASplitScreen) {
    const scene::SceneSetup setup = scenes::makeMixed();
    const scene::Camera own = setup.path.at(0);
    viewer::ReproducedView view{
        .settings = {.scene = "mixed"},
        .side = 1,
        .camera = scene::canonical(scene::lookAlong(own, own.position, -own.back, glm::dvec3(0.3, 1.0, 0.1))),
        .sceneCamera = own,
        .extent = kExtent};
    view.settings.second = depth::parseTechnique("cdr");
    view.settings.second->format = depth::DepthFormat::d16;
    view.settings.drawing.targets = render::TargetsKind::layers;
    view.settings.drawing.threads = 2;
    view.settings.view = viewer::ViewKind::ids;
    const render::Frame frame = show(setup.scene, view);
    const json result = pictureOf(view);
    EXPECT_EQ(result["hash"], output::hashOf(frame, output::Aov::id, nullptr));
    EXPECT_EQ(result["targets"], "layers");
}

TEST_F(ViewCommand, RendersARecordedPath) {
    const scene::SceneSetup setup = scenes::makeAfc(scenes::kDefaultSeed);
    scene::CameraRecording recording{.scene = "afc", .cameras = {}};
    for (std::uint32_t i = 0; i < 3; ++i) {
        scene::record(recording, 0.5 * i, setup.path.at(20 * i));
    }
    scene::writeRecording(at("p.json"), recording);
    const std::string render = "render afc --technique reversed --size 320x180 ";
    // As recorded, each camera is a frame of the scene's own path.
    succeed(render + "--path p.json --json a.json");
    const json frames = jsonIn("a.json")["results"];
    ASSERT_EQ(frames.size(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i) {
        succeed(render + "--json b.json --frame " + std::to_string(20 * i));
        EXPECT_EQ(frames[i]["hash"], jsonIn("b.json")["results"][0]["hash"]);
    }
    // And spread over more frames, the ends stay.
    succeed(render + "--path p.json --frames 5 -o f%02d.png --json c.json");
    const json spread = jsonIn("c.json")["results"];
    ASSERT_EQ(spread.size(), 5u);
    EXPECT_EQ(spread[0]["hash"], frames[0]["hash"]);
    EXPECT_EQ(spread[4]["hash"], frames[2]["hash"]);
    EXPECT_NE(spread[1]["hash"], frames[0]["hash"]);
    EXPECT_TRUE(std::filesystem::exists(at("f04.png")));
}

constexpr const char* kMachine = CDR_SOURCE_DIR "/tests/assets/machine.glb";

/// Three views of a model that stands still, each beside the last and a quarter of a second of its animation later.
std::vector<viewer::ReproducedView> viewsBesideMachine() {
    const scene::Camera own = scenes::openScene(kMachine, scenes::kDefaultSeed).setup.path.at(0);
    std::vector<viewer::ReproducedView> views;
    for (int i = 0; i < 3; ++i) {
        viewer::ReproducedView& view = views.emplace_back();
        view.settings.scene = kMachine;
        view.settings.choice.animation = "work";
        view.settings.choice.seconds = 0.125 + 0.25 * i;
        view.camera = scene::canonical(scene::lookAlong(own, own.position + 0.05 * i * own.right, -own.back));
        view.sceneCamera = own;
        view.extent = {96, 54};
    }
    return views;
}

/// Each frame is seen by its own camera, at its own moment, in one cascade and in several.
TEST_F(ViewCommand, AnAnimationPlaysAlongARecordedPath) {
    std::vector<viewer::ReproducedView> views = viewsBesideMachine();
    scene::CameraRecording recording{.scene = kMachine, .cameras = {}};
    for (const viewer::ReproducedView& view : views) {
        scene::record(recording, *view.settings.choice.seconds, view.camera);
    }
    scene::writeRecording(at("p.json"), recording);
    for (const std::string name : {"anchored", "cdr"}) {
        const json frames =
            documentOf(std::string("render ") + kMachine +
                       " --animation work --path p.json --time 0.125 --fps 4 --size 96x54 --technique " +
                       name)["results"];
        ASSERT_EQ(frames.size(), views.size()) << name;
        std::set<json> hashes;
        for (std::size_t i = 0; i < views.size(); ++i) {
            views[i].settings.technique = depth::parseTechnique(name);
            EXPECT_EQ(frames[i]["hash"], pictureOf(views[i])["hash"]) << name << ", frame " << i;
            EXPECT_EQ(frames[i]["seconds"], views[i].settings.choice.seconds) << name;
            hashes.insert(frames[i]["hash"]);
        }
        // Camera and moment both count: another moment is another picture.
        views[2].settings.choice.seconds = 0.375;
        hashes.insert(pictureOf(views[2])["hash"]);
        views[2].settings.choice.seconds = 0.625;
        EXPECT_EQ(hashes.size(), views.size() + 1) << name;
    }
}

} // namespace

} // namespace cdr::cli_test
