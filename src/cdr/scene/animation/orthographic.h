#pragma once

#include <cdr/scene/camera.h>

#include <glm/glm.hpp>

namespace cdr::scene {

/// What a camera without perspective shows.
struct OrthographicLens {
    double halfHeight = 1.0; ///< scene units, > 0
    double nearView = 0.0;   ///< view distance, >= 0
    double farView = 1.0;    ///< view distance, > nearView
};

/// Diameters of a scene between it and the perspective camera that shows it without perspective. Then places move by at
/// most half a pixel in pictures up to 8192 pixels high, whatever their distance.
inline constexpr double kAfar = 4096.0;

/// A perspective camera far behind `place` that shows what an orthographic one does there. Its field of view is so small that
/// near and far things are equally large. At the view distance of the scene's middle, sizes are exact.
/// @param place where the orthographic camera stands, and its axes.
/// @param centre of the scene. @param radius of a sphere that holds the scene, > 0.
Camera fromAfar(const Camera& place, const OrthographicLens& lens, const glm::dvec3& centre, double radius);

} // namespace cdr::scene
