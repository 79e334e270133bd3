#include <cdr/measure/truth/lens.h>
#include <cdr/measure/truth/object_ray.h>
#include <cdr/measure/truth/truth_motion.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

namespace cdr::measure {

namespace {

/// By the float64 inverse of a camera that was carried into an object's space.
std::optional<glm::dvec2> slopesOf(const PlacedCamera& camera, const glm::dvec3& point) {
    const glm::dmat3 axes(camera.right, camera.up, camera.front);
    const glm::dvec3 seen = glm::inverse(axes) * (point - camera.origin);
    if (!(seen.z > 0.0)) {
        return std::nullopt;
    }
    return glm::dvec2(seen.x, seen.y) / seen.z;
}

std::optional<glm::dvec2> motionAt(const TruthPixel& pixel, const SeenScene& now, const SeenScene& before,
                                   std::size_t instance, const glm::dvec2& slopes) {
    const auto inverseNow = invertBasis(now.scene.instances.basis[instance]);
    const auto inverseBefore = invertBasis(before.scene.instances.basis[instance]);
    if (!inverseNow || !inverseBefore) {
        return std::nullopt;
    }
    const ObjectRay ray = placeCamera(now.camera, now.scene.instances, instance, inverseNow->worldToObject)
                              .ray(slopes.x, slopes.y);
    return slopesOf(
        placeCamera(before.camera, before.scene.instances, instance, inverseBefore->worldToObject),
        ray.origin + ray.direction * pixel.distanceView);
}

} // namespace

image::Raster<glm::dvec2> truthMotion(const TruthImage& truth, const SeenScene& now,
                                      const SeenScene& before) {
    std::map<std::uint32_t, std::size_t> instanceOf;
    for (std::size_t i = 0; i < now.scene.instances.size(); ++i) {
        instanceOf[now.scene.instances.object[i] + 1] = i;
    }
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    image::Raster<glm::dvec2> motion(truth.width, truth.height, glm::dvec2(kNone));
    const PixelSlopes slopes = pixelSlopes(now.camera, truth.width, truth.height);
    // The picture's height is 2 tan(fovY / 2) in slopes, for either lens.
    const double perSlope = pixelsPerSlope(before.camera, truth.height);
    for (std::uint32_t y = 0; y < truth.height; ++y) {
        for (std::uint32_t x = 0; x < truth.width; ++x) {
            const TruthPixel& pixel = truth.at(x, y);
            if (pixel.id == 0) {
                continue;
            }
            const auto was =
                motionAt(pixel, now, before, instanceOf.at(pixel.id), {slopes.x[x], slopes.y[y]});
            if (was) {
                motion.at(x, y) = {0.5 * truth.width + was->x * perSlope - (x + 0.5),
                                   0.5 * truth.height - was->y * perSlope - (y + 0.5)};
            }
        }
    }
    return motion;
}

} // namespace cdr::measure
