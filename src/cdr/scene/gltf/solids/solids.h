#pragma once

#include "../accessor.h"
#include "../primitive.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace cdr::scene::gltf {

/// Points and lines are drawn as closed solids: a point is an octahedron, a segment of a line a prism of three sides. Both
/// have three corners about each end, and the same triangles. So they have a depth and an id like any other surface.
inline constexpr std::uint32_t kSolidCorners = 6;
inline constexpr std::uint32_t kSolidTriangles = 8;

/// The corners of a solid's triangles, counter-clockwise from outside.
inline constexpr std::array<std::uint32_t, std::size_t{3} * kSolidTriangles> kSolidIndices{
    0, 2, 1, 3, 4, 5, 0, 1, 3, 3, 1, 4, 1, 2, 4, 4, 2, 5, 2, 0, 5, 5, 0, 3};

/// The directions from an end of a solid to the corners about that end, of length 1. The first three are of the first end,
/// the others of the second.
using SolidShape = std::array<glm::dvec3, kSolidCorners>;

/// The octahedron of a point.
SolidShape pointShape();
/// The prism of a segment. @param along from one end to the other, not zero.
SolidShape segmentShape(const glm::dvec3& along);

/// Two vertices of the file; twice the same one for a point.
struct SolidEnds {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
};

/// The points or segments of a primitive; none for triangles. A rest that makes no segment is dropped, and so is a segment
/// from a vertex to itself. Each index is below `vertexCount`; one that is not is refused.
std::vector<SolidEnds> solidList(const Primitive& primitive, Accessors& accessors, std::size_t vertexCount,
                                 const std::string& where);

/// How many solidList() makes of a primitive at most, from its counts alone.
std::uint64_t solidCount(const Primitive& primitive, Accessors& accessors);

/// Triangles that a primitive is drawn as at most, from its counts alone.
std::uint64_t drawnTriangleCount(const Primitive& primitive, Accessors& accessors);

/// The radius of points without a radius of their own (src/cdr/scene/README.md, "Points and lines"). 0 where they are all at
/// one place.
/// @param sides of their box.
double defaultPointRadius(const glm::dvec3& sides, std::uint64_t count);

/// The same of lines: about two pixels of a picture that they fill.
double defaultLineRadius(const glm::dvec3& sides);

/// What a primitive shows its material on. glTF lights points and lines by the normals that they have, and without
/// normals not at all. Normal textures need tangents. Of a solid only the front is drawn.
enum class Ground : std::uint8_t { surface, solidWithTangents, solidWithNormals, solidAlone };

Ground groundOf(const Primitive& primitive);

} // namespace cdr::scene::gltf
