#pragma once

#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::scene {

/// A mesh as a simplifier wants it. Vertices that are equal with their details are one, so that triangles of meshes without an
/// index buffer touch. None is unused, since one in the same place would count as a seam.
struct SharedMesh {
    std::vector<std::uint32_t> indices;
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> vertices; ///< by position: the mesh's
};

SharedMesh sharedBy(const Mesh& mesh);

/// Fewer triangles over the same positions, about as many as are wanted, by edge collapses that leave open borders as they
/// are, and points where positions are without a triangle. The number alone decides how far to go; what it costs is for the caller to measure.
std::vector<std::uint32_t> simplified(std::span<const std::uint32_t> indices,
                                      std::span<const glm::vec3> positions, std::size_t triangles);

} // namespace cdr::scene
