#pragma once

#include <cdr/scene/camera.h>
#include <cdr/scene/camera_path.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cdr::scene {

/// A camera at a moment of a recording.
struct RecordedCamera {
    double seconds = 0.0; ///< since the recording began, >= 0
    Camera camera;
};

/// A camera path that was recorded.
struct CameraRecording {
    std::string scene; ///< that it was recorded in, as openScene() takes it; only shown to people
    std::vector<RecordedCamera> cameras; ///< seconds ascend strictly; may be empty while it is being recorded

    double seconds() const { return cameras.empty() ? 0.0 : cameras.back().seconds; }
};

inline constexpr std::size_t kMaxRecordedCameras = 36'000; ///< 20 minutes at 30 a second

/// Adds a camera, made canonical(). Returns false, and adds nothing, for one that is not later than the last
/// or exceeds kMaxRecordedCameras. base::InputError for one that is not usable.
bool record(CameraRecording& recording, double seconds, const Camera& camera);

/// The camera at a moment. Before the recording begins it is the first, and after its end the last. At a recorded
/// moment it is the recorded one to the bit. In between
/// - positions are linear in float64 from the nearer end, so that steps of micrometres stay exact far out;
/// - orientation follows the shortest turn;
/// - field of view, near and far are interpolated by their logarithms.
/// base::InputError for a recording without cameras.
Camera cameraAt(const CameraRecording& recording, double seconds);

/// The recording as `frames` frames at equal intervals, from its first camera to its last. With as many frames as there are
/// cameras it is these cameras, to the bit, whatever their moments are. Keeps a copy.
/// base::InputError for a recording without cameras, or for no frames.
CameraPath pathOf(const CameraRecording& recording, std::uint32_t frames);

/// Writes a recording as JSON, whole or not at all, every number to the bit. base::InputError or
/// base::RunError when that fails.
void writeRecording(const std::filesystem::path& path, const CameraRecording& recording);
/// Reads what writeRecording() writes. base::InputError, with the file and what is wrong, for a file that is
/// missing, too large or not such a recording. Its cameras must be usable and orthonormal, the way from each to the next
/// finite, and its moments must ascend.
CameraRecording readRecording(const std::filesystem::path& path);

} // namespace cdr::scene
