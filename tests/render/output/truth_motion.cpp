#include "truth_motion.h"

#include <cdr/measure/truth/lens.h>
#include <cdr/measure/truth/object_ray.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace cdr::render_test {

namespace {

/// By the float64 inverse of a camera that was carried into an object's space.
std::optional<glm::dvec2> slopesOf(const measure::PlacedCamera& camera, const glm::dvec3& point) {
    const glm::dmat3 axes(camera.right, camera.up, camera.front);
    const glm::dvec3 seen = glm::inverse(axes) * (point - camera.origin);
    if (!(seen.z > 0.0)) {
        return std::nullopt;
    }
    return glm::dvec2(seen.x, seen.y) / seen.z;
}

/// The shares of a triangle's corners in the point of its plane that is nearest to a point.
glm::dvec3 sharesAt(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& point) {
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double twice = glm::dot(normal, normal);
    const auto share = [&](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::dot(normal, glm::cross(b - a, point - a)) / twice;
    };
    return {share(corners[1], corners[2]), share(corners[2], corners[0]), share(corners[0], corners[1])};
}

std::array<glm::dvec3, 3> cornersOf(const scene::Mesh& mesh, std::size_t triangle) {
    std::array<glm::dvec3, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
        corners[c] = glm::dvec3(mesh.vertices[mesh.indices[triangle + c]].position);
    }
    return corners;
}

/// Where a point on a mesh was, object space, when its vertices were elsewhere: by the triangle that it lies on.
glm::dvec3 pointBefore(const scene::Mesh& now, const scene::Mesh& before, const glm::dvec3& point) {
    double least = std::numeric_limits<double>::infinity();
    glm::dvec3 found = point;
    for (std::size_t triangle = 0; triangle + 2 < now.indices.size(); triangle += 3) {
        const std::array<glm::dvec3, 3> corners = cornersOf(now, triangle);
        // Beside a triangle the nearest point of it would do; the least of its shares, made 0, is near enough to choose.
        const glm::dvec3 inside = glm::max(sharesAt(corners, point), glm::dvec3(0.0));
        const glm::dvec3 shares = inside / (inside.x + inside.y + inside.z);
        const double off =
            glm::length(shares.x * corners[0] + shares.y * corners[1] + shares.z * corners[2] - point);
        if (off < least) {
            const std::array<glm::dvec3, 3> was = cornersOf(before, triangle);
            least = off;
            found = shares.x * was[0] + shares.y * was[1] + shares.z * was[2];
        }
    }
    return found;
}

bool haveSamePositions(const scene::Mesh& a, const scene::Mesh& b) {
    return std::equal(
        a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
        [](const scene::Vertex& x, const scene::Vertex& y) { return x.position == y.position; });
}

/// A scene that was seen twice.
struct SeenTwice {
    const SeenScene& now;
    const SeenScene& before;
    std::vector<bool> deforms; ///< by mesh
};

SeenTwice compared(const SeenScene& now, const SeenScene& before) {
    SeenTwice seen{.now = now, .before = before, .deforms = {}};
    for (std::size_t mesh = 0; mesh < now.scene.meshes.size(); ++mesh) {
        seen.deforms.push_back(!haveSamePositions(now.scene.meshes[mesh], before.scene.meshes[mesh]));
    }
    return seen;
}

std::optional<glm::dvec2> motionAt(const measure::TruthPixel& pixel, const SeenTwice& seen,
                                   std::size_t instance, const glm::dvec2& slopes) {
    const auto& [now, before, deforms] = seen;
    const auto inverseNow = measure::invertBasis(now.scene.instances.basis[instance]);
    const auto inverseBefore = measure::invertBasis(before.scene.instances.basis[instance]);
    if (!inverseNow || !inverseBefore) {
        return std::nullopt;
    }
    const measure::ObjectRay ray =
        measure::placeCamera(now.camera, now.scene.instances, instance, inverseNow->worldToObject)
            .ray(slopes.x, slopes.y);
    const std::uint32_t mesh = now.scene.instances.mesh[instance];
    glm::dvec3 point = ray.origin + ray.direction * pixel.distanceView;
    if (deforms[mesh]) {
        point = pointBefore(now.scene.meshes[mesh], before.scene.meshes[mesh], point);
    }
    return slopesOf(
        measure::placeCamera(before.camera, before.scene.instances, instance, inverseBefore->worldToObject),
        point);
}

} // namespace

image::Raster<glm::dvec2> truthMotion(const measure::TruthImage& truth, const SeenScene& now,
                                      const SeenScene& before) {
    std::map<std::uint32_t, std::size_t> instanceOf;
    for (std::size_t i = 0; i < now.scene.instances.size(); ++i) {
        instanceOf[now.scene.instances.object[i] + 1] = i;
    }
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    image::Raster<glm::dvec2> motion(truth.width, truth.height, glm::dvec2(kNone));
    const SeenTwice seen = compared(now, before);
    const measure::PixelSlopes slopes = measure::pixelSlopes(now.camera, truth.width, truth.height);
    // The picture's height is 2 tan(fovY / 2) in slopes, for either lens.
    const double perSlope = measure::pixelsPerSlope(before.camera, truth.height);
    const glm::dvec2 shift = before.camera.lensShift;
    for (std::uint32_t y = 0; y < truth.height; ++y) {
        for (std::uint32_t x = 0; x < truth.width; ++x) {
            const measure::TruthPixel& pixel = truth.at(x, y);
            if (pixel.id == 0) {
                continue;
            }
            const auto was = motionAt(pixel, seen, instanceOf.at(pixel.id), {slopes.x[x], slopes.y[y]});
            if (was) {
                motion.at(x, y) = {0.5 * truth.width + (was->x - shift.x) * perSlope - (x + 0.5),
                                   0.5 * truth.height - (was->y - shift.y) * perSlope - (y + 0.5)};
            }
        }
    }
    return motion;
}

} // namespace cdr::render_test
