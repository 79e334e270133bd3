#pragma once

#include <cdr/scene/mesh.h>

#include <cstdint>
#include <span>

namespace cdr::render {

/// Whether triangles close a volume: each edge of one is an edge of another, in the other direction. Vertices at the same place
/// count as one. From outside such a mesh the nearest surface is always a front face. Edges are summed as 64-bit hashes, so a
/// mesh with gaps is taken for closed with a chance of 2⁻⁶⁴.
/// @param indices three per triangle
bool isClosed(std::span<const scene::Vertex> vertices, std::span<const std::uint32_t> indices);

} // namespace cdr::render
