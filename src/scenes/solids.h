#pragma once

#include <cdr/scene/mesh_pieces.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace cdr::scene {

/// A solid of revolution about the x axis, closed where its outline ends on the axis, with smooth normals.
/// @param outline x and radius, in the order that keeps the solid on the right; at least two points.
/// @param segments around the axis, at least 3.
SourceMesh turnedSolid(std::string name, std::span<const glm::dvec2> outline, std::uint32_t segments);

/// A six-sided solid by its corners, the lower four counter-clockwise seen from above, then the upper four
/// above them; flat normals. Sides need not be parallel, but are drawn as two triangles each.
SourceMesh hexahedron(std::string name, const std::array<glm::dvec3, 8>& corners);

/// A sphere about the origin.
SourceMesh sphereMesh(std::string name, double radius, std::uint32_t segments);

} // namespace cdr::scene
