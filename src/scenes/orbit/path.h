#pragma once

#include <cdr/scene/camera_path.h>

#include <glm/glm.hpp>

namespace cdr::scenes {

/// A look through a window that ends as one through a telescope.
struct ZoomPath {
    glm::dvec3 eye{0.0};       ///< world space
    glm::dvec3 firstAim{0.0};  ///< world space, unit: where the widest lens looks
    glm::dvec3 target{0.0};    ///< world space: what the narrowest lens looks at
    double widestDegrees = 60; ///< vertical field of view
    double narrowestDegrees = 0.002;
    double nearView = 0.1;
    double farView = 1e9;
    std::uint32_t frames = 240;
};

/// The camera of each frame. The lens narrows by the same factor every frame. The aim nears the target faster
/// than the lens narrows, so the target comes into the picture and stays there. Frames beyond the path begin it
/// again.
scene::CameraPath zoomPath(const ZoomPath& zoom);

} // namespace cdr::scenes
