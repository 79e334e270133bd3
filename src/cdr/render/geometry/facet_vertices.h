#pragma once

#include <cdr/scene/mesh.h>

namespace cdr::render {

/// The same triangles in the same order with fewer vertices. What a facet looks like is read from the first
/// vertex of each of its triangles alone, which Vulkan calls the provoking one. So vertices are shared across
/// facets, and triangles turned until their first vertex is their facet's: a cube has 8 vertices instead of 24.
/// Texture coordinates are lost.
/// @param mesh the corners of each of its triangles share their normal and colour.
scene::Mesh shareFacetVertices(const scene::Mesh& mesh);

} // namespace cdr::render
