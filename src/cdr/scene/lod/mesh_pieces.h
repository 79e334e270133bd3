#pragma once

/// @file
/// @errors None: what is wanted of arguments is not checked.

#include <cdr/base/export.h>
#include <cdr/scene/mesh.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace cdr::scene {

/// A mesh before it is cut. Its vertices may lie anywhere, in float64.
///
/// Importers fill it with what their files hold. glTF has float32, so a vertex 10^6 from the mesh's origin has a
/// step of 1/16 in the file. Generators may use all of float64.
struct SourceMesh {
    std::string name;                    ///< that pieces get
    std::vector<glm::dvec3> positions;   ///< one per vertex, or empty, which takes the vertices' own
    std::vector<Vertex> vertices;        ///< their own positions are read only where `positions` is empty
    std::vector<std::uint32_t> indices;  ///< three per triangle, each below vertices.size()
    std::vector<VertexDetail> details{}; ///< one per vertex, or empty

    /// Where a vertex lies in the source's own space. @param vertex below vertices.size()
    glm::dvec3 positionOf(std::size_t vertex) const {
        return positions.empty() ? glm::dvec3(vertices[vertex].position) : positions[vertex];
    }
};

/// A part of a mesh about an origin of its own.
struct MeshPiece {
    Mesh mesh;              ///< of the piece
    glm::dvec3 origin{0.0}; ///< where the piece's origin goes in the space of the source
};

/// Most pieces of one mesh: each is a draw.
inline constexpr std::size_t kMaxPieces = 4096;

/// How wide pieces may be by default, in scene units. float32 vertices in them are exact to 3e-5.
inline constexpr double kPieceRadius = 512.0;

/// Cuts a mesh into pieces of about `radius`, each with vertices relative to its own origin. So float32 rounds
/// them to 2^-25 of the piece and not of the mesh. There are at most kMaxPieces, and at most one per eight
/// triangles, or two; if more would be needed, pieces are larger. One piece where the mesh is no wider. Triangles are
/// not cut. One that is larger than `radius` goes to a piece by its centre. That piece is then as large as the
/// triangle, and the renderer's wide draws take it.
///
/// No cracks: at every vertex where pieces meet, the widest of them holds all triangles of that vertex. So
/// any two triangles that share an edge or a corner are drawn by one piece with one transform. Thus the pieces
/// of one object overlap by a row of triangles at their seams, with at most three copies of each. They are not
/// for blending, which would show the copies.
/// @param source not empty, positions finite.
/// @param radius in the source's space, > 0; infinity for one piece.
CDR_EXPORT std::vector<MeshPiece> cutIntoPieces(const SourceMesh& source,
                                                double radius = std::numeric_limits<double>::infinity());

/// The same pieces of a mesh that is not needed any more. A mesh no wider than `radius` is moved and not copied. For that its
/// vertices must be in the order in which its triangles first use them, as importers make it.
/// @param source not empty, positions finite; without contents afterwards.
/// @param radius in units of the source's space, > 0; infinity for one piece.
CDR_EXPORT std::vector<MeshPiece> cutIntoPieces(SourceMesh&& source,
                                                double radius = std::numeric_limits<double>::infinity());

/// Pieces that are in a scene.
struct PieceSet {
    std::uint32_t firstMesh = 0;     ///< index into Scene::meshes; the others follow
    std::vector<glm::dvec3> origins; ///< of each piece, in the source's space
};

/// Moves pieces into a scene's meshes.
CDR_EXPORT PieceSet addPieces(Scene& scene, std::vector<MeshPiece> pieces);

/// Appends an instance per piece, all of one object. Origins are turned in float64 by `toWorld`. So a piece
/// is where its node says, and only what lies within it turns by the basis rounded to float32.
/// @param pieces of addPieces() for this scene.
/// @param toWorld affine, from the source's space.
CDR_EXPORT void placePieces(Scene& scene, const PieceSet& pieces, std::uint32_t material,
                            std::uint32_t object, const glm::dmat4& toWorld);

} // namespace cdr::scene
