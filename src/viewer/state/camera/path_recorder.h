#pragma once

#include <cdr/scene/camera_recording.h>

#include <optional>
#include <string>

namespace cdr::viewer {

/// Turns the cameras of a session, however many a second, into a recording of at most kMaxRecordedCameras. It
/// keeps 30 a second while the camera moves, and only the ends of the time that it rests. The first and the
/// last camera are kept to the bit.
class PathRecorder {
  public:
    static constexpr double kCamerasPerSecond = 30.0;

    /// Forgets what was recorded before.
    void begin(std::string scene);
    /// A recording made before, instead of what was recorded.
    void load(scene::CameraRecording recording);
    /// The camera `seconds` after the last one. False once the recording is full.
    bool add(double seconds, const scene::Camera& camera);
    /// Ends the recording with the last camera that was added.
    void end();

    bool isRecording() const { return m_isRecording; }
    /// Without cameras when none was added.
    const scene::CameraRecording& recording() const { return m_recording; }

  private:
    void keep(const scene::RecordedCamera& camera);

    scene::CameraRecording m_recording;
    std::optional<scene::RecordedCamera> m_last; ///< added, and perhaps not kept
    double m_seconds = 0.0;
    bool m_isRecording = false;
};

} // namespace cdr::viewer
