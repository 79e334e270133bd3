#include <cdr/measure/truth/lens.h>
#include <cdr/measure/truth/object_ray.h>

#include <cmath>

namespace cdr::measure {

PixelSlopes pixelSlopes(const scene::Camera& camera, std::uint32_t width, std::uint32_t height) {
    const double halfHeight = halfHeightSlope(camera);
    const double perPixel = halfHeight / height;
    PixelSlopes slopes;
    slopes.step = 2.0 * perPixel;
    slopes.x.reserve(width);
    slopes.y.reserve(height);
    // 2i + 1 - n is exact, so the two halves of a picture about the view axis mirror each other to the bit.
    for (std::uint32_t i = 0; i < width; ++i) {
        slopes.x.push_back((2.0 * i + 1.0 - width) * perPixel + camera.lensShift.x);
    }
    for (std::uint32_t j = 0; j < height; ++j) {
        slopes.y.push_back((height - 1.0 - 2.0 * j) * perPixel + camera.lensShift.y);
    }
    return slopes;
}

std::optional<InverseBasis> invertBasis(const glm::mat3& basis) {
    const glm::dmat3 b(basis);
    // Cofactors: each row of the inverse stays exact relative to its own length, however uneven the scale.
    const glm::dvec3 rows[3] = {glm::cross(b[1], b[2]), glm::cross(b[2], b[0]), glm::cross(b[0], b[1])};
    const double determinant = glm::dot(b[0], rows[0]);
    const double boxVolume = glm::length(b[0]) * glm::length(b[1]) * glm::length(b[2]);
    const double skew = boxVolume / std::abs(determinant);
    // Below 2^-46 of an upright box' volume the determinant is mostly rounding.
    if (!(skew < 0x1p46)) {
        return std::nullopt;
    }
    const glm::dmat3 columns(rows[0] / determinant, rows[1] / determinant, rows[2] / determinant);
    return InverseBasis{glm::transpose(columns), skew};
}

PlacedCamera placeCamera(const scene::Camera& camera, const scene::Instances& instances, std::size_t i,
                         const glm::dmat3& worldToObject) {
    return {worldToObject * (camera.position - instances.position(i)), worldToObject * -camera.back,
            worldToObject * camera.right, worldToObject * camera.up};
}

} // namespace cdr::measure
