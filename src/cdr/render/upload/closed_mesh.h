#pragma once

#include <cdr/scene/mesh.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace cdr::render {

/// Meshes of more triangles count as open, so that the look at one takes little time and memory.
inline constexpr std::size_t kMostClosedTriangles = 100'000;

/// Whether triangles close volumes that they face away from: each edge of one is an edge of another, in the other direction, and
/// no part is inside out, as a room is that is modelled from within. Vertices at the same place count as one. From outside, the
/// nearest surface of such a mesh is a front face, unless a part passes through itself and is partly inside out. Edges are summed
/// as 64-bit hashes, so a mesh with gaps is taken for closed with a chance of 2⁻⁶⁴.
/// @param indices three per triangle
bool isClosed(std::span<const scene::Vertex> vertices, std::span<const std::uint32_t> indices);

} // namespace cdr::render
