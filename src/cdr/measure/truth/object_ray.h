#pragma once

#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace cdr::measure {

/// The distance that stands for "no hit".
inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// Which faces of a surface are seen.
enum class Sidedness : std::uint8_t {
    fronts,
    both ///< scene::Material::doubleSided
};
inline Sidedness sidednessOf(const scene::Material& material) {
    return material.doubleSided ? Sidedness::both : Sidedness::fronts;
}

/// A ray in an object's own space: origin + t * direction, where t is the view distance.
struct ObjectRay {
    glm::dvec3 origin;
    glm::dvec3 direction; ///< not of unit length

    /// Where it passes a point most closely.
    double shiftTo(const glm::dvec3& point) const {
        return glm::dot(point - origin, direction) / glm::dot(direction, direction);
    }
    /// The same ray, begun there.
    ObjectRay from(double shift) const { return {origin + shift * direction, direction}; }
};

/// The closed interval of view distances in which a surface is visible.
struct ViewRange {
    double nearView;
    double farView;

    bool holds(double distanceView) const { return distanceView >= nearView && distanceView <= farView; }
};

/// The rays of a picture. Pixel (i, j), with row 0 on top, looks along -back + right * x[i] + up * y[j]. So the
/// ray parameter is the view distance. Slopes are taken at pixel centres.
struct PixelSlopes {
    std::vector<double> x;
    std::vector<double> y;
    double step = 0.0; ///< between neighbours, either way
};

PixelSlopes pixelSlopes(const scene::Camera& camera, std::uint32_t width, std::uint32_t height);

/// The camera carried into one instance's object space.
struct PlacedCamera {
    glm::dvec3 origin; ///< the camera's position
    glm::dvec3 front;  ///< the camera's -back
    glm::dvec3 right;
    glm::dvec3 up;

    ObjectRay ray(double slopeX, double slopeY) const {
        return {origin, (front + up * slopeY) + right * slopeX};
    }
};

/// An instance's inverse basis and how far its rounding may be amplified.
struct InverseBasis {
    glm::dmat3 worldToObject;
    double skew; ///< 1 for orthogonal columns whatever their lengths, larger the nearer the basis is to flat
};

/// The float64 inverse of exactly these float32 values; none when the basis is flat or not finite.
std::optional<InverseBasis> invertBasis(const glm::mat3& basis);

/// Carries `camera` into the space of instance `i`: the difference of positions is formed first, in float64.
/// So the result is as exact at 10^8 units as at 1.
PlacedCamera placeCamera(const scene::Camera& camera, const scene::Instances& instances, std::size_t i,
                         const glm::dmat3& worldToObject);

} // namespace cdr::measure
