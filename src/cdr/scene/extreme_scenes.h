#pragma once

#include <cdr/scene/generators.h>
#include <cdr/scene/mesh_pieces.h>

#include <array>
#include <cstdint>

namespace cdr::scene {

/// View distances of the mixed scene, and its separations as shares of them.
inline constexpr std::array kMixedDistances{1.0, 1e3, 1e6, 1e8};
inline constexpr std::array kMixedShares{1e-6, 1e-7};

/// Four distances in one picture: for each a column of two turned cubes, a quarter of their distance wide, with a
/// red twin inside whose faces lie kMixedShares of the distance below theirs, 1e-6 in the upper row and 1e-7 in
/// the lower. Twins are drawn last, so a depth buffer that cannot tell the two apart shows red. 60 degrees, near
/// 0.1, far 2e8. Column c, row r is the objects 4c + 2r, and the twin one more.
StagedScene makeMixed();

struct GlobeOptions {
    double radius = 6.371e6;
    /// Squares along an edge of the cube that is blown up to the globe; the mesh has 12 cells^2 triangles.
    std::uint32_t cells = 128;
    double pieceRadius = 200e3; ///< as of cutIntoPieces()
    glm::dvec3 centre{0.0};     ///< world space
};

/// A planet of one mesh, its vertices float64, cut into pieces of one object 0: white, lit by a far light,
/// without a camera.
Scene makeGlobe(const GlobeOptions& options = {});

/// The mesh of it before it is cut, about the globe's centre.
SourceMesh globeMesh(double radius, std::uint32_t cells);

} // namespace cdr::scene
