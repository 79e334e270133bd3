#include "application.h"
#include "render_failure.h"
#include "startup.h"

#include <cdr/base/error.h>
#include <cdr/base/quantity_text.h>
#include <cdr/image/codec.h>
#include <cdr/platform/file.h>
#include <viewer/state/camera/framing.h>
#include <viewer/state/camera/obstacles.h>
#include <viewer/state/camera/stereo_view.h>
#include <viewer/state/plain_words.h>
#include <viewer/state/shown_picture.h>
#include <viewer/state/tour.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace cdr::viewer {

void Application::dropFiles(const DropInput& drop) {
    const auto found = std::find_if(drop.paths.begin(), drop.paths.end(), scene::isGltfPath);
    if (found == drop.paths.end()) {
        m_model.interface.sayProblem(drop.paths.empty()
                                         ? "what was dropped is not a file"
                                         : fmt::format("{} is no scene: drop a .gltf or .glb file",
                                                       drop.paths.front().filename().string()));
        return;
    }
    chooseScene(m_model.settings, found->string());
    m_model.interface.say(drop.paths.size() == 1
                              ? fmt::format("opening {}", found->filename().string())
                              : fmt::format("opening {}, of {} files that were dropped",
                                            found->filename().string(), drop.paths.size()));
}

void Application::toggleRecording() {
    PathRecorder& recorder = m_model.camera.recorder;
    if (recorder.isRecording() || m_model.camera.isPathUnsaved) {
        recorder.end();
        const std::size_t cameras = recorder.recording().cameras.size();
        if (cameras == 0) {
            m_model.interface.sayProblem("nothing was recorded");
            return;
        }
        m_model.camera.isPathUnsaved = true;
        const std::filesystem::path file = freeName("camera-path", ".json");
        scene::writeRecording(file, recorder.recording());
        m_model.camera.isPathUnsaved = false;
        m_model.interface.say(fmt::format("{} holds {}", file.string(), counted(cameras, "camera")));
    } else if (m_model.camera.isThere) {
        platform::requireWritable(freeName("camera-path", ".json")); // rather than when it has been flown
        if (m_model.camera.motion == Motion::recording) {
            m_model.camera.motion = Motion::free; // what it plays goes
        }
        recorder.begin(m_model.picture.shown->sceneName);
        m_model.interface.say("recording the camera; R ends it");
    }
}

void Application::playRecording() {
    const PathRecorder& recorder = m_model.camera.recorder;
    if (recorder.recording().cameras.empty() || recorder.isRecording()) {
        return;
    }
    m_model.camera.playedSeconds = 0.0;
    m_model.camera.motion = Motion::recording;
    m_model.camera.followsAnimation = false;
    if (recorder.recording().scene != m_model.settings.scene) {
        const std::filesystem::path scene = recorder.recording().scene;
        m_model.interface.say(
            fmt::format("playing a path that was recorded in {}", scene.filename().string()));
    }
}

void Application::toggleVideo() {
    if (m_model.video != nullptr) {
        const auto video = std::exchange(m_model.video, nullptr);
        if (video->pictures() == 0) { // without finish() no file is left
            m_model.interface.say("nothing was recorded: the video ended before its first picture");
            return;
        }
        video->finish();
        m_model.interface.say(fmt::format("{} holds {}, {} s", video->file().string(),
                                          counted(video->pictures(), "picture"),
                                          base::quantityText(video->seconds())));
    } else if (m_model.picture.shown != nullptr) {
        const std::vector<SideResult>& sides = m_model.picture.shown->sides;
        const image::ImageRgba8& first = *sides.front().picture;
        m_model.video = std::make_unique<VideoRecording>(freeName("cdr-video", ".mp4"), sides.size(),
                                                         first.width, first.height);
    }
}

void Application::recordVideo(double seconds) {
    if (m_model.video == nullptr) {
        return;
    }
    const std::vector<SideResult>& sides = m_model.picture.shown->sides;
    const image::ImageRgba8* right = sides.size() > 1 ? sides[1].picture.get() : nullptr;
    try {
        if (!m_model.video->add(*sides.front().picture, right, seconds)) {
            toggleVideo(); // another size or number of pictures is another video
        }
    } catch (const base::RunError& error) {
        m_model.video.reset();
        m_model.interface.sayProblem(error.what());
    }
}

void Application::savePicture(const std::filesystem::path& file) {
    const image::ImageRgba8 picture = shownPicture(m_model.picture.shown.get(), m_model.settings.divider);
    if (!picture.pixels.empty()) {
        image::writeImage(file, picture);
        m_model.interface.say(fmt::format("{} written", file.string()));
    }
}

void Application::captureWindow() {
    if (!m_presenter.isReadable()) {
        throw base::RunError("this window system does not let a window's pixels be read");
    }
    const std::filesystem::path file = freeName("cdr-window", ".png");
    platform::requireWritable(file); // later there is nobody to tell but the shell
    m_capture = file;
}

void Application::copyCommandLines() {
    const std::string lines = commandLinesOf(m_model.picture);
    if (lines.empty()) {
        m_model.interface.sayProblem("nothing is shown yet");
        return;
    }
    m_window.copyToClipboard(lines);
    m_model.interface.say(fmt::format("copied: {}", lines));
}

void Application::frameSelected() {
    const auto& last = m_model.picture.measuring.last();
    if (!last || m_model.picture.shown == nullptr) {
        m_model.interface.sayProblem("nothing is selected: click an object first");
        return;
    }
    const double aspect = extentOfEye(m_model.settings, pictureArea().extent).aspect();
    const Ball ball = ballOf(m_model.picture.shown->obstacles->instances(), last->object);
    m_model.camera.motion = Motion::free;
    m_model.camera.followsAnimation = false;
    m_model.camera.now = scene::canonical(framed(m_model.camera.now, ball, aspect));
    m_model.camera.pivot = ball.centre;
    m_model.camera.surfaceView = glm::distance(m_model.camera.now.position, ball.centre);
}

void Application::toggleTour() {
    if (m_model.camera.motion == Motion::tour) {
        m_model.camera.motion = Motion::free;
        return;
    }
    chooseScene(m_model.settings, kTourScene);
    m_model.settings.technique = depth::parseTechnique("standard");
    m_model.settings.second = depth::parseTechnique("anchored");
    m_model.camera.playedSeconds = 0.0;
    m_model.camera.motion = Motion::tour;
}

void Application::goHome() {
    CameraModel& camera = m_model.camera;
    if (!camera.isThere) {
        return;
    }
    camera.motion = Motion::free;
    camera.pathFrame = 0;
    camera.followsAnimation = true;
    camera.animatedFrame.reset();
    const scene::Camera before = std::exchange(camera.now, scene::canonical(camera.ofScene));
    if (before != camera.now) { // else no new picture comes
        m_session.aimAnew();
    }
}

void Application::perform(Action action) {
    try {
        tryPerform(action);
    } catch (...) {
        m_model.interface.sayProblem(explainFailure().message);
    }
}

void Application::tryPerform(Action action) {
    switch (action) {
    case Action::quit:
        m_quits = true;
        break;
    case Action::screenshotPicture:
        savePicture(freeName("cdr-picture", ".png"));
        break;
    case Action::screenshotWindow:
        captureWindow();
        break;
    case Action::copyCommandLine:
        copyCommandLines();
        break;
    case Action::sceneCamera:
        goHome();
        break;
    case Action::record:
        toggleRecording();
        break;
    case Action::playRecording:
        playRecording();
        break;
    case Action::frameSelected:
        frameSelected();
        break;
    case Action::video:
        toggleVideo();
        break;
    case Action::tour:
        toggleTour();
        break;
    case Action::forgetMeasuring:
        m_model.picture.measuring.clear();
        break;
    }
}

} // namespace cdr::viewer
