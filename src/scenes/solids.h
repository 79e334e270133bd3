#pragma once

#include <cdr/scene/lod/mesh_pieces.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace cdr::scenes {

/// Adds a triangle of vertices that the mesh has, unless two of its corners lie at one place.
void addTriangle(scene::SourceMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c);

/// A solid of revolution about the x axis, closed where its outline ends on the axis, with smooth normals.
/// @param outline x and radius, in the order that keeps the solid on the right; at least two points.
/// @param segments around the axis, at least 3.
scene::SourceMesh turnedSolid(std::string name, std::span<const glm::dvec2> outline, std::uint32_t segments);

/// A six-sided solid by its corners, the lower four counter-clockwise seen from above, then the upper four
/// above them; flat normals. Sides need not be parallel, but are drawn as two triangles each.
scene::SourceMesh hexahedron(std::string name, const std::array<glm::dvec3, 8>& corners);

/// A sphere about the origin.
scene::SourceMesh sphereMesh(std::string name, double radius, std::uint32_t segments);

} // namespace cdr::scenes
