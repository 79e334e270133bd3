#include "application.h"
#include "shown_picture.h"
#include "startup.h"

#include <cdr/image/codec.h>

#include <fmt/format.h>

namespace cdr::viewer {

void Application::dropFiles(const DropInput& drop) {
    if (drop.paths.empty()) {
        return;
    }
    m_model.settings.scene = drop.paths.front().string();
    m_model.say(fmt::format("opening {}", drop.paths.front().filename().string()));
}

void Application::toggleRecording() {
    m_model.isRecording = !m_model.isRecording;
    if (m_model.isRecording) {
        m_model.recording = {.scene = m_model.settings.scene, .cameras = {}};
        m_model.recordingSeconds = 0.0;
        m_model.say("recording the camera; R ends it");
        return;
    }
    const std::filesystem::path file = freeName("camera-path", ".json");
    scene::writeRecording(file, m_model.recording);
    m_model.say(fmt::format("{} holds {} cameras", file.string(), m_model.recording.cameras.size()));
}

void Application::savePicture(const std::filesystem::path& file) {
    const image::ImageRgba8 picture = shownPicture(m_model);
    if (!picture.pixels.empty()) {
        image::writeImage(file, picture);
        m_model.say(fmt::format("{} written", file.string()));
    }
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

void Application::perform(Action action) {
    switch (action) {
    case Action::quit:
        m_quits = true;
        break;
    case Action::screenshotPicture:
        savePicture(freeName("cdr-picture", ".png"));
        break;
    case Action::screenshotWindow:
        m_capture = freeName("cdr-window", ".png");
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
        if (!m_model.recording.cameras.empty() && !m_model.isRecording) {
            m_model.recordingSeconds = 0.0;
            m_model.motion = Motion::recording;
        }
        break;
    case Action::forgetMeasuring:
        m_model.measuring.clear();
        break;
    }
}

} // namespace cdr::viewer
