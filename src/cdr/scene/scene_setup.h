#pragma once

#include <cdr/scene/camera_path.h>
#include <cdr/scene/scene.h>
#include <cdr/scene/world/check.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace cdr::scene {

/// Where every instance is at a frame, by index, as a pure function of the frame number; empty where nothing moves.
using InstancePaths = std::function<std::vector<Transform>(std::uint32_t frame)>;

/// A scene, the cameras that look at it, and what moves in it.
struct SceneSetup {
    Scene scene;            ///< what is looked at
    CameraPath path;        ///< the cameras that look
    InstancePaths motion{}; ///< the scene is as it is at frame 0
};

/// A scene that was opened by name or from a file.
struct OpenedScene {
    SceneSetup setup;               ///< scene and cameras
    std::vector<std::string> notes; ///< what an importer ignored, one line each
};

} // namespace cdr::scene
