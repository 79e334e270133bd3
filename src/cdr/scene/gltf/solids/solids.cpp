#include "solids.h"

#include "../triangles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cdr::scene::gltf {

namespace {

/// Of the distance of neighbours: points of an even grid stay apart.
constexpr double kPointShare = 1.0 / 3.0;
/// Of the diagonal.
constexpr double kLineShare = 1.0 / 500.0;

/// Solid `i` of those that `corners` make.
SolidEnds endsAt(int mode, const std::vector<std::uint32_t>& corners, std::size_t i) {
    switch (mode) {
    case kModePoints:
        return {corners[i], corners[i]};
    case kModeLines:
        return {corners[2 * i], corners[2 * i + 1]};
    default: // of a loop, the last segment ends where the first begins
        return {corners[i], corners[(i + 1) % corners.size()]};
    }
}

} // namespace

SolidShape pointShape() {
    // Rings of three about the axis (1, 1, 1), so that the triangles are those of a prism.
    return {glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1), glm::dvec3(-1, 0, 0),
            glm::dvec3(1, 0, 0),  glm::dvec3(0, 1, 0),  glm::dvec3(0, 0, 1)};
}

SolidShape segmentShape(const glm::dvec3& along) {
    const glm::dvec3 axis = along / glm::length(along);
    const glm::dvec3 size = glm::abs(axis);
    int least = size.x <= size.y ? 0 : 1;
    least = size.z < size[least] ? 2 : least;
    glm::dvec3 leastAligned(0.0);
    leastAligned[least] = 1.0;
    const glm::dvec3 u = glm::normalize(glm::cross(axis, leastAligned));
    const glm::dvec3 v = glm::cross(axis, u);
    SolidShape shape;
    for (std::size_t i = 0; i < 3; ++i) {
        const double angle = static_cast<double>(i) * 2.0 * std::numbers::pi / 3.0;
        shape[i] = shape[i + 3] = std::cos(angle) * u + std::sin(angle) * v;
    }
    return shape;
}

std::uint64_t solidCount(const Primitive& primitive, Accessors& accessors) {
    const std::uint64_t corners = cornerCount(primitive, accessors);
    switch (primitive.mode) {
    case kModePoints:
        return corners;
    case kModeLines:
        return corners / 2;
    case kModeLineLoop:
        return corners > 2 ? corners : corners / 2; // there and back is the same line
    case kModeLineStrip:
        return corners < 2 ? 0 : corners - 1;
    default:
        return 0;
    }
}

std::vector<SolidEnds> solidList(const Primitive& primitive, Accessors& accessors, std::size_t vertexCount,
                                 const std::string& where) {
    const std::uint64_t count = solidCount(primitive, accessors);
    std::vector<SolidEnds> solids;
    if (count == 0) {
        return solids;
    }
    const std::vector<std::uint32_t> corners = cornerList(primitive, accessors, vertexCount, where);
    solids.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const SolidEnds ends = endsAt(primitive.mode, corners, i);
        if (primitive.mode == kModePoints || ends.first != ends.second) {
            solids.push_back(ends);
        }
    }
    return solids;
}

std::uint64_t drawnTriangleCount(const Primitive& primitive, Accessors& accessors) {
    return triangleCount(primitive, accessors) + kSolidTriangles * solidCount(primitive, accessors);
}

double defaultPointRadius(const glm::dvec3& sides, std::uint64_t count) {
    const double area = sides.x * sides.y + sides.y * sides.z + sides.z * sides.x;
    const double length = std::max({sides.x, sides.y, sides.z});
    const auto points = static_cast<double>(std::max<std::uint64_t>(count, 1));
    return kPointShare * std::max(std::sqrt(area / points), length / points);
}

double defaultLineRadius(const glm::dvec3& sides) {
    return kLineShare * glm::length(sides);
}

Ground groundOf(const Primitive& primitive) {
    if (primitive.mode >= kModeTriangles) {
        return Ground::surface;
    }
    if (!primitive.attributes.contains("NORMAL")) {
        return Ground::solidAlone;
    }
    return primitive.attributes.contains("TANGENT") ? Ground::solidWithTangents : Ground::solidWithNormals;
}

} // namespace cdr::scene::gltf
