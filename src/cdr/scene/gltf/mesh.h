#pragma once

#include "accessor.h"
#include "materials/uv_places.h"
#include "memory.h"
#include "notes.h"
#include "primitive.h"
#include "solids/solids.h"

#include <cdr/scene/lod/mesh_pieces.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cdr::scene::gltf {

/// The triangles of a primitive as the file has them, or those that its points and lines are drawn as.
struct SourcePrimitive {
    SourceMesh mesh;
    std::vector<std::uint32_t> fileVertices; ///< by vertex of the mesh: which one of the file's it is
    std::size_t fileVertexCount = 0;
    UvPlaces::Tangents derived =
        UvPlaces::Tangents::none; ///< the place that tangents which the file lacks follow
};

/// Lengths in a mesh's space.
struct MeshSizes {
    double pieceRadius;                  ///< as of cutIntoPieces()
    std::optional<double> pointRadius{}; ///< of points and lines; else they get a default one
};

/// Imports the triangles of a primitive. Keeps a scratch table between calls, so that many primitives which
/// each use a little of one large vertex buffer cost what they use.
class MeshImporter {
  public:
    /// @param memory what the import still may take, which says whether MikkTSpace can run.
    MeshImporter(Accessors& accessors, const MemoryPrediction& memory, Notes& notes);

    /// Nothing when the primitive has nothing to draw. `where` names it in messages.
    std::optional<SourcePrimitive> read(const Primitive& primitive, const UvPlaces& uv,
                                        std::optional<double> pointRadius, const std::string& where);

    /// The same in pieces; none when it has no extent either.
    std::vector<MeshPiece> import(const Primitive& primitive, const UvPlaces& uv, const MeshSizes& sizes,
                                  const std::string& where);

  private:
    struct Attributes;

    /// Nothing when the primitive has no triangles.
    std::optional<SourcePrimitive> readTriangles(const Primitive& primitive, const UvPlaces& uv,
                                                 const std::string& where);
    /// Those that the file lacks.
    void addTangents(SourceMesh& mesh, const Primitive& primitive, UvPlaces::Tangents along,
                     const std::string& where);
    /// Nothing when the primitive has no points or lines with an extent.
    std::optional<SourcePrimitive> readSolids(const Primitive& primitive, const UvPlaces& uv,
                                              std::optional<double> radius, const std::string& where);
    void addSolid(SourcePrimitive& source, const Attributes& attributes, const SolidEnds& ends, double radius,
                  const std::string& where);
    Attributes findAttributes(const Primitive& primitive, const UvPlaces& uv, const std::string& where);
    Vertex readVertex(const Attributes& attributes, std::uint32_t index, const std::string& where);
    VertexDetail readDetail(const Attributes& attributes, std::uint32_t index, const glm::vec3& normal,
                            const std::string& where);
    /// Of vertices of the file, in their order.
    void addVertices(SourceMesh& mesh, const Attributes& attributes, std::span<const std::uint32_t> indices,
                     const std::string& where);
    void addShared(SourcePrimitive& source, const Attributes& attributes, const std::string& where);
    void addFlat(SourcePrimitive& source, const Attributes& attributes, const std::string& where);

    Accessors& m_accessors;
    const MemoryPrediction& m_memory;
    Notes& m_notes;
    std::vector<std::uint32_t> m_newIndex; ///< by index in the file; kUnused between calls
};

} // namespace cdr::scene::gltf
