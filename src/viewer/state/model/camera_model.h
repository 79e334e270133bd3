#pragma once

#include <cdr/scene/camera.h>
#include <viewer/state/animation/playback.h>
#include <viewer/state/camera/orbit_controller.h>
#include <viewer/state/camera/path_recorder.h>

#include <options/camera_options.h>

#include <cstdint>
#include <optional>

namespace cdr::viewer {

/// What the camera follows; nothing where it is free.
enum class Motion : std::uint8_t { free, scenePath, recording, tour };

/// The camera, and what moves it.
struct CameraModel {
    scene::Camera now;
    scene::Camera ofScene;                       ///< the scene's own at frame 0
    bool isThere = false;                        ///< false until a scene is open
    std::optional<options::CameraOptions> first; ///< of the command line, for the first scene
    options::CameraOptions lens;                 ///< of the command line, while its scene is open
    bool orbits = false;
    glm::dvec3 pivot{0.0};
    double surfaceView = 0.0; ///< view distance of what is looked at: speeds follow from it
    Motion motion = Motion::free;
    std::uint32_t pathFrame = 0;
    PathRecorder recorder;
    bool isPathUnsaved = false;                 ///< of what was recorded last
    double playedSeconds = 0.0;                 ///< of what was recorded, or of the tour
    Playback playback;                          ///< of a file's animation
    bool followsAnimation = true;               ///< false once somebody steers away from an animated camera
    std::optional<std::uint32_t> animatedFrame; ///< at which the animation has put it
};

} // namespace cdr::viewer
