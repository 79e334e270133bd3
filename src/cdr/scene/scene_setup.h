#pragma once

#include <cdr/scene/camera_path.h>
#include <cdr/scene/scene.h>

#include <string>
#include <vector>

namespace cdr::scene {

/// A scene and the cameras that look at it.
struct SceneSetup {
    Scene scene;
    CameraPath path;
};

/// A scene that was opened by name or from a file.
struct OpenedScene {
    SceneSetup setup;
    std::vector<std::string> notes; ///< what an importer ignored, one line each
};

} // namespace cdr::scene
