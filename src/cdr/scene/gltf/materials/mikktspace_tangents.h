#pragma once

#include "uv_places.h"

#include <cdr/scene/lod/mesh_pieces.h>

#include <cstdint>
#include <optional>
#include <string>

namespace cdr::scene::gltf {

/// Gives a mesh whose file has no tangents those of MikkTSpace, as glTF asks. A vertex whose corners get different ones
/// becomes several. The first of them stays where it was, and the others come after all vertices. There are at most twice
/// as many vertices then. Triangles without extent are left out.
/// @param mesh with details. @param along the place of textures that tangents follow.
/// @param bytes that it may take while it runs.
/// @return why it has none, and is unchanged; nothing where it has them.
std::optional<std::string> deriveMikkTSpaceTangents(SourceMesh& mesh, UvPlaces::Tangents along,
                                                    std::uint64_t bytes);

} // namespace cdr::scene::gltf
