#pragma once

#include "uv_places.h"

#include <cdr/scene/lod/mesh_pieces.h>

namespace cdr::scene::gltf {

/// Works out the tangents of a mesh whose file has none, where MikkTSpace cannot (mikktspace_tangents.h). Each corner has
/// the direction in which u grows on its triangle. It is turned into the plane of the vertex' normal, and weighted by the
/// corner's angle. A vertex between triangles that run through their texture in opposite senses becomes two.
/// @param mesh with details. @param along the place of textures that tangents follow.
void deriveTangents(SourceMesh& mesh, UvPlaces::Tangents along);

/// The angle between two vectors, radians; 0 where one of them is 0.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b);

/// Any unit vector at a right angle to a unit normal.
glm::vec3 anyTangent(const glm::vec3& normal);

} // namespace cdr::scene::gltf
