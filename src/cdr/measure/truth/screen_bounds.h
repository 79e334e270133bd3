#pragma once

#include <cdr/measure/truth/object_ray.h>
#include <cdr/scene/camera.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace cdr::measure {

/// A half-open rectangle of pixels.
struct PixelRect {
    std::uint32_t left = 0;
    std::uint32_t top = 0;
    std::uint32_t right = 0;
    std::uint32_t bottom = 0;

    bool empty() const { return left >= right || top >= bottom; }
    bool contains(std::uint32_t x, std::uint32_t y) const {
        return x >= left && x < right && y >= top && y < bottom;
    }
    bool operator==(const PixelRect&) const = default;
};

PixelRect intersection(const PixelRect& a, const PixelRect& b);

/// A box that encloses an instance, as the camera sees it: view space, that is right, up, and view distance.
struct ViewBox {
    glm::dvec3 centre;
    std::array<glm::dvec3, 3> halfSides; ///< not orthogonal in general
    double rounding; ///< bounds how far a hit of a ray may lie off the exact box, in scene units
};

/// What an instance can cover: no visible hit lies outside.
struct Footprint {
    PixelRect pixels;
    double nearestView = 0.0; ///< view distance
};

/// Bounds of the part of `box` within the camera's [near, far], from the corners of that part. None when
/// nothing of it is on the picture.
/// @param marginPixels by how much wider they are on each side, at least kMinMargin for their own rounding.
std::optional<Footprint> footprint(const ViewBox& box, const scene::Camera& camera, std::uint32_t width,
                                   std::uint32_t height, double marginPixels);

/// A hundredth of a pixel.
inline constexpr double kMinMargin = 0.01;

} // namespace cdr::measure
