#pragma once

#include <cdr/image/image.h>
#include <cdr/measure/truth/truth.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

namespace cdr::render_test {

/// A scene and who looked at it.
struct SeenScene {
    const scene::Scene& scene;
    const scene::Camera& camera;
};

/// How far each pixel of `truth` is from where its surface was before, in pixels, to the right and down, in float64.
/// Not numbers where nothing is seen, or where the surface was not in front of the camera. Shares no code with the
/// renderer's motion.
/// @param truth of `now`.
/// @param before holds the same instances at the same places, each of an object of its own. Their meshes have the same triangles, of
/// which vertices may be elsewhere.
image::Raster<glm::dvec2> truthMotion(const measure::TruthImage& truth, const SeenScene& now,
                                      const SeenScene& before);

} // namespace cdr::render_test
