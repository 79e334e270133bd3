#include <cdr/render/shading/air_record.h>
#include <cdr/render/view_transform.h>

#include <algorithm>
#include <cmath>

namespace cdr::render {

namespace {

/// Of the height by which the air gets thinner by e: where there is none worth a colour.
constexpr double kTopOfAir = 12.0;
/// Radii; beyond, the planet is smaller than any pixel, and float32 would overflow.
constexpr double kFarthestEye = 1e9;
/// Radii; by less, air is thinner than any pixel, and float32 would overflow.
constexpr double kLeastHeight = 1e-15;

/// In radii, as float32 can square it.
double heightOf(const scene::AirPart& part, double radius) {
    return std::clamp(part.height / radius, kLeastHeight, kFarthestEye / kTopOfAir);
}

glm::vec4 partRecord(const scene::AirPart& part, double radius) {
    return {glm::vec3(glm::dvec3(part.scattering) * radius), static_cast<float>(heightOf(part, radius))};
}

} // namespace

shaders::AirRecord makeAirRecord(const scene::Air& air, const scene::Camera& camera) {
    // Stretched along the axis, the ellipsoid is a sphere.
    const double added = 1.0 / (1.0 - air.flattening) - 1.0;
    const auto stretched = [&](const glm::dvec3& way) {
        return way + added * glm::dot(air.axis, way) * air.axis;
    };
    const glm::dvec3 fromCentre = stretched((camera.position - air.centre) / air.radius);
    const double eye = glm::length(fromCentre);
    const glm::dvec3 up = eye > 0.0 ? fromCentre / eye : air.axis;
    const double top =
        kTopOfAir * std::max(heightOf(air.molecules, air.radius), heightOf(air.haze, air.radius));
    const auto inView = [&](const glm::dvec3& direction) {
        return glm::vec3(directionInView(camera, direction));
    };
    return {.up = {inView(up), static_cast<float>(std::min(eye - 1.0, kFarthestEye))},
            .axis = {inView(std::sqrt(added) * air.axis), static_cast<float>(1.0 / air.radius)},
            .toSun = {inView(glm::normalize(stretched(air.toSun))), static_cast<float>(top)},
            .molecules = partRecord(air.molecules, air.radius),
            .haze = partRecord(air.haze, air.radius),
            .sunlight = {air.sunlight, static_cast<float>(air.hazeAhead)}};
}

} // namespace cdr::render
