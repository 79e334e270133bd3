#pragma once

#include <cdr/scene/lod/mesh_pieces.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstdint>

namespace cdr::test {

struct GlobeOptions {
    double radius = 6.371e6;
    /// Squares along an edge of the cube that is blown up to the globe; the mesh has 12 cells^2 triangles.
    std::uint32_t cells = 128;
    double pieceRadius = 200e3; ///< as of cutIntoPieces()
    glm::dvec3 centre{0.0};     ///< world space
};

/// A planet of one mesh, its vertices float64, cut into pieces of one object 0: white, lit by a far light,
/// without a camera.
scene::Scene makeGlobe(const GlobeOptions& options = {});

/// The mesh of it before it is cut, about the globe's centre.
scene::SourceMesh globeMesh(double radius, std::uint32_t cells);

} // namespace cdr::test
