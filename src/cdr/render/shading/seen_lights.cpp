#include <cdr/render/shading/seen_lights.h>

#include <algorithm>
#include <cmath>

namespace cdr::render {

namespace {

/// The device finds distances from float32 places: a share of the range, and of the distance to the camera.
constexpr double kRangeRounding = 0x1p-10;
constexpr double kPlaceRounding = 0x1p-18;

/// Whether a sphere around a light reaches into the frustum. Planes are those of Frustum.
bool reachesView(const scene::PointLight& light, const scene::Camera& camera, const scene::Frustum& frustum) {
    const glm::dvec3 place = light.position - camera.position;
    const double w = -glm::dot(camera.back, place);
    const double x = std::abs(glm::dot(frustum.rightOf(camera), place));
    const double y = std::abs(glm::dot(frustum.upOf(camera), place));
    const double radius = *light.range * (1.0 + kRangeRounding) + glm::length(place) * kPlaceRounding;
    return w + radius >= camera.nearView && w - radius <= camera.farView &&
           x * frustum.cosX - w * frustum.sinX <= radius && y * frustum.cosY - w * frustum.sinY <= radius;
}

} // namespace

std::vector<std::uint32_t> seenLights(const std::vector<scene::PointLight>& lights,
                                      const scene::Camera& camera, const scene::Frustum& frustum) {
    std::vector<std::uint32_t> seen = scene::shadowLights(lights);
    const std::vector<std::uint32_t> casting = seen;
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
        const bool isThere = std::find(casting.begin(), casting.end(), i) != casting.end();
        if (!isThere && (!lights[i].range || reachesView(lights[i], camera, frustum))) {
            seen.push_back(i);
        }
    }
    return seen;
}

} // namespace cdr::render
