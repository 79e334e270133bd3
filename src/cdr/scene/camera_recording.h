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

/// A camera path as somebody flew it.
struct CameraRecording {
    std::string scene; ///< that it was recorded in, as openScene() takes it; for the reader's eye
    std::vector<RecordedCamera> cameras; ///< at least one to be used; seconds ascend strictly

    double seconds() const { return cameras.empty() ? 0.0 : cameras.back().seconds; }
};

inline constexpr std::size_t kMaxRecordedCameras = 36'000; ///< 20 minutes at 30 a second

/// Adds a camera, canonical(). One that is not later than the last is left out, and so is what exceeds
/// kMaxRecordedCameras; false then. base::InputError for one that is not usable.
bool record(CameraRecording& recording, double seconds, const Camera& camera);

/// The camera at a moment; the first before it begins, the last after its end, and at a recorded moment the
/// recorded one to the bit. In between: positions linear in float64, from the nearer end, so that steps of
/// micrometres stay exact far out; orientation along the shortest turn; field of view, near and far by their
/// logarithms. base::InputError for a recording without cameras.
Camera cameraAt(const CameraRecording& recording, double seconds);

/// The recording as `frames` frames, evenly spread, its first camera first and its last one last. Takes a
/// copy. base::InputError for a recording without cameras or no frames.
CameraPath pathOf(const CameraRecording& recording, std::uint32_t frames);

/// Writes a recording as JSON, whole or not at all, every number to the bit. base::InputError when that
/// fails.
void writeRecording(const std::filesystem::path& path, const CameraRecording& recording);
/// Reads what writeRecording() writes. base::InputError, in one line naming the file and what is wrong, for a
/// file that is missing, too large or not such a recording: its cameras must be usable and orthonormal, its
/// moments ascend.
CameraRecording readRecording(const std::filesystem::path& path);

} // namespace cdr::scene
