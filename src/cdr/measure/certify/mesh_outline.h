#pragma once

#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace cdr::measure {

/// A mesh's triangles over corners that are one where their positions are the same, and each triangle's neighbours.
/// Triangles with two corners at one place are left out, since they cover nothing.
struct MeshOutline {
    static constexpr std::uint32_t kNoNeighbour = 0xffffffff;

    struct Face {
        std::array<std::uint32_t, 3> corners; ///< of `positions`
        /// Across the edge from corner i to the next: the one face that has it the other way round. None where there are
        /// none or several: then the surface ends there.
        std::array<std::uint32_t, 3> neighbours;
        std::uint32_t first = 0; ///< of its three indices in the mesh
    };

    std::vector<glm::dvec3> positions; ///< object space
    std::vector<Face> faces;
    glm::dvec3 reach{0.0}; ///< largest coordinates, in magnitude
};

/// Of the mesh's finest level. Indices must be in range, also of a box, whose indices Shape does not test.
MeshOutline outlineOf(const scene::Mesh& mesh);

} // namespace cdr::measure
