#include "path_recorder.h"

#include <utility>

namespace cdr::viewer {

void PathRecorder::begin(std::string scene) {
    m_recording = {.scene = std::move(scene), .cameras = {}};
    m_last.reset();
    m_seconds = 0.0;
    m_isRecording = true;
}

void PathRecorder::load(scene::CameraRecording recording) {
    m_recording = std::move(recording);
    m_isRecording = false;
}

void PathRecorder::keep(const scene::RecordedCamera& camera) {
    scene::record(m_recording, camera.seconds, camera.camera); // one that is kept already stays as it is
}

bool PathRecorder::add(double seconds, const scene::Camera& camera) {
    const bool isFull =
        m_recording.cameras.size() + 3 > scene::kMaxRecordedCameras; // two here, one at the end
    if (!m_isRecording || isFull) {
        return false;
    }
    m_seconds += m_last ? seconds : 0.0;
    const scene::RecordedCamera now{.seconds = m_seconds, .camera = camera};
    if (m_recording.cameras.empty()) {
        keep(now);
    } else {
        const double kept = m_recording.seconds();
        if (m_last->camera != camera && m_last->camera == m_recording.cameras.back().camera) {
            keep(*m_last); // it rested until then
        }
        if (camera != m_recording.cameras.back().camera && m_seconds - kept >= 1.0 / kCamerasPerSecond) {
            keep(now);
        }
    }
    m_last = now;
    return true;
}

void PathRecorder::end() {
    if (std::exchange(m_isRecording, false) && m_last) {
        keep(*m_last);
    }
}

} // namespace cdr::viewer
