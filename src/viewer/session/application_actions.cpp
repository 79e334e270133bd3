#include "application.h"
#include "startup.h"

#include <cdr/base/error.h>
#include <cdr/base/quantity_text.h>
#include <cdr/host/file.h>
#include <cdr/image/codec.h>
#include <viewer/state/camera/framing.h>
#include <viewer/state/plain_words.h>
#include <viewer/state/shown_picture.h>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace cdr::viewer {

void Application::dropFiles(const DropInput& drop) {
    const auto found = std::find_if(drop.paths.begin(), drop.paths.end(), scene::isGltfPath);
    if (found == drop.paths.end()) {
        m_model.say(drop.paths.empty() ? "nothing that is a file was dropped"
                                       : fmt::format("{} is no scene: drop a .gltf or .glb file",
                                                     drop.paths.front().filename().string()),
                    true);
        return;
    }
    m_model.settings.scene = found->string();
    m_model.settings.choice = {};
    m_model.say(drop.paths.size() == 1 ? fmt::format("opening {}", found->filename().string())
                                       : fmt::format("opening {}, of {} files that were dropped",
                                                     found->filename().string(), drop.paths.size()));
}

void Application::toggleRecording() {
    PathRecorder& recorder = m_model.recorder;
    if (recorder.isRecording()) {
        recorder.end();
        const std::size_t cameras = recorder.recording().cameras.size();
        if (cameras == 0) {
            m_model.say("nothing was recorded", true);
            return;
        }
        const std::filesystem::path file = freeName("camera-path", ".json");
        scene::writeRecording(file, recorder.recording());
        m_model.say(fmt::format("{} holds {}", file.string(), counted(cameras, "camera")));
    } else if (m_model.hasCamera) {
        if (m_model.motion == Motion::recording) {
            m_model.motion = Motion::free; // what it plays goes
        }
        recorder.begin(m_model.settings.scene);
        m_model.say("recording the camera; R ends it");
    }
}

void Application::toggleVideo() {
    if (m_model.video != nullptr) {
        const auto video = std::exchange(m_model.video, nullptr);
        video->finish();
        m_model.say(fmt::format("{} holds {}, {} s", video->file().string(),
                                counted(video->pictures(), "picture"), base::quantityText(video->seconds())));
    } else if (m_model.shown != nullptr) {
        const std::vector<SideResult>& sides = m_model.shown->sides;
        const image::ImageRgba8& first = *sides.front().picture;
        m_model.video = std::make_unique<VideoRecording>(freeName("cdr-video", ".mp4"), sides.size(),
                                                         first.width, first.height);
    }
}

void Application::recordVideo(double seconds) {
    if (m_model.video == nullptr) {
        return;
    }
    const std::vector<SideResult>& sides = m_model.shown->sides;
    const image::ImageRgba8* right = sides.size() > 1 ? sides[1].picture.get() : nullptr;
    try {
        if (!m_model.video->add(*sides.front().picture, right, seconds)) {
            toggleVideo(); // another size or number of pictures is another video
        }
    } catch (const base::RunError& error) {
        m_model.video.reset();
        m_model.say(error.what(), true);
    }
}

void Application::savePicture(const std::filesystem::path& file) {
    const image::ImageRgba8 picture = shownPicture(m_model);
    if (!picture.pixels.empty()) {
        image::writeImage(file, picture);
        m_model.say(fmt::format("{} written", file.string()));
    }
}

void Application::captureWindow() {
    if (!m_presenter.isReadable()) {
        throw base::RunError("this window system does not let a window's pixels be read");
    }
    const std::filesystem::path file = freeName("cdr-window", ".png");
    host::requireWritable(file); // later there is nobody to tell but the shell
    m_capture = file;
}

void Application::copyCommandLines() {
    const std::string lines = commandLinesOf(m_model);
    if (lines.empty()) {
        m_model.say("nothing is shown yet", true);
        return;
    }
    m_window.copyToClipboard(lines);
    m_model.say(fmt::format("copied: {}", lines));
}

void Application::frameSelected() {
    const auto& last = m_model.measuring.second() ? m_model.measuring.second() : m_model.measuring.first();
    if (!last || m_model.shown == nullptr) {
        m_model.say("nothing is selected: click an object first", true);
        return;
    }
    const double aspect = pictureArea().extent.aspect();
    const Ball ball = ballOf(m_model.shown->scene->setup.scene.instances, last->object);
    m_model.motion = Motion::free;
    m_model.camera = scene::canonical(framed(m_model.camera, ball, aspect));
    m_model.pivot = ball.centre;
    m_model.surfaceView = glm::distance(m_model.camera.position, ball.centre);
}

void Application::toggleTour() {
    if (m_model.motion == Motion::tour) {
        m_model.motion = Motion::free;
        return;
    }
    m_model.settings.scene = "orbit";
    m_model.settings.choice = {};
    m_model.settings.technique = depth::parseTechnique("standard");
    m_model.settings.second = depth::parseTechnique("anchored");
    m_model.playedSeconds = 0.0;
    m_model.motion = Motion::tour;
}

void Application::perform(Action action) {
    try {
        tryPerform(action);
    } catch (const base::InputError& error) {
        m_model.say(error.what(), true);
    } catch (const base::RunError& error) {
        m_model.say(error.what(), true);
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
        if (m_model.hasCamera) {
            m_model.motion = Motion::free;
            m_model.pathFrame = 0;
            m_model.camera = scene::canonical(m_model.sceneCamera);
            m_model.pivot = m_model.camera.position - m_model.camera.back * m_model.surfaceView;
        }
        break;
    case Action::record:
        toggleRecording();
        break;
    case Action::playRecording:
        if (!m_model.recorder.recording().cameras.empty() && !m_model.recorder.isRecording()) {
            m_model.playedSeconds = 0.0;
            m_model.motion = Motion::recording;
        }
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
        m_model.measuring.clear();
        break;
    }
}

} // namespace cdr::viewer
