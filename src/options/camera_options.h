#pragma once

#include <cdr/scene/camera_path.h>

#include <options/cli_app.h>

#include <cstdint>
#include <optional>
#include <string>

namespace cdr::options {

/// Most frames one call renders.
inline constexpr std::uint32_t kMaxFrames = 1'000'000;

/// What a person may say of the cameras to render.
struct CameraOptions {
    std::uint32_t frame = 0;
    std::optional<std::uint32_t> frames;
    std::string path; ///< file of a scene::CameraRecording
    std::optional<glm::dvec3> eye;
    std::optional<glm::dvec3> target;
    std::optional<glm::dvec3> direction;
    std::optional<glm::dvec3> up;
    std::optional<double> fovDegrees;
    std::optional<glm::dvec2> lensShift;
    std::optional<double> nearView;
    std::optional<double> farView;
};

/// Adds --frame and --frames.
void addFrameOptions(CLI::App& command, CameraOptions& options);
/// Adds --path, --eye, --target, --direction, --up, --fov, --lens-shift, --near and --far.
void addCameraOptions(CLI::App& command, CameraOptions& options);

/// What options say of the lens: field of view, shift, near and far. Nothing of where the camera stands.
CameraOptions lensOf(const CameraOptions& options);

/// The camera with what the options override. base::InputError for an unusable one.
scene::Camera overridden(scene::Camera camera, const CameraOptions& options);

/// Which frames to render, numbered from `first` on, and their cameras.
class FrameCameras {
  public:
    /// Reads a recorded path. base::InputError when that fails, or for words that contradict each other.
    explicit FrameCameras(const CameraOptions& options);

    std::uint32_t first = 0;
    std::uint32_t frames = 1;

    /// The camera of a frame: the scene's own or the recorded one, with what the options override.
    /// base::InputError for an unusable one.
    scene::Camera at(const scene::CameraPath& own, std::uint32_t frame) const;

  private:
    CameraOptions m_options;
    std::optional<scene::CameraPath> m_recorded;
};

} // namespace cdr::options
