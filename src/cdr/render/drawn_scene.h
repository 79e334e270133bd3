#pragma once

#include <cdr/render/uploaded_scene.h>
#include <cdr/scene/scene.h>

namespace cdr::render {

/// A scene as a renderer draws it.
struct DrawnScene {
    const scene::Scene& scene;     ///< what is drawn
    const UploadedScene& uploaded; ///< of `scene`
};

} // namespace cdr::render
