#pragma once

#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace cdr::scene {

/// A mesh as a simplifier wants it: equal vertices are one, so that triangles of meshes without an index buffer touch, and
/// none is unused, since one in the same place would count as a seam.
struct SharedMesh {
    std::vector<std::uint32_t> indices;
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> vertices; ///< by position: the mesh's
};

SharedMesh sharedBy(const Mesh& mesh);

} // namespace cdr::scene
