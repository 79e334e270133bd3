#pragma once

#include "../materials/uv_places.h"

#include <cdr/scene/animation/deform.h>

#include <cstdint>
#include <span>

namespace cdr::scene::gltf {

/// Lets morph targets turn tangents that the file lacks. With one target in full, each vertex has the tangent that would be
/// derived of the mesh deformed so. In between, tangents are blended in proportion to how far the target stretches the
/// texture along them. A target that stretches, shears or turns a surface evenly is exact at all weights.
///
/// Vertices stay those of the mesh at rest: where MikkTSpace would split the deformed mesh otherwise, they share a tangent.
/// @param deformer with details, and with the targets' other deltas. @param indices of its triangles.
/// @param along the place of textures that tangents follow.
void addTangentDeltas(Deformer& deformer, std::span<const std::uint32_t> indices, UvPlaces::Tangents along);

} // namespace cdr::scene::gltf
