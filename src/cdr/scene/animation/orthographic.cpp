#include <cdr/scene/animation/orthographic.h>

#include <algorithm>
#include <cmath>

namespace cdr::scene {

Camera fromAfar(const Camera& place, const OrthographicLens& lens, const glm::dvec3& centre, double radius) {
    const double behind = kAfar * 2.0 * radius;
    // A scene behind the camera, or beyond what it sees, has no middle that is seen.
    const double middle = std::clamp(place.viewDistance(centre), lens.nearView, lens.farView);
    Camera camera = place;
    camera.position += behind * place.back;
    camera.fovY = 2.0 * std::atan(lens.halfHeight / (behind + middle));
    camera.nearView = behind + lens.nearView;
    camera.farView = behind + lens.farView;
    return camera;
}

} // namespace cdr::scene
