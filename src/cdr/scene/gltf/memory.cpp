#include "memory.h"

#include "checks.h"
#include "draco/decompressor.h"
#include "solids/solids.h"
#include "triangles.h"

#include <cdr/scene/scene.h>

#include <algorithm>

namespace cdr::scene::gltf {

namespace {

constexpr std::uint64_t kIndexBytes = sizeof(std::uint32_t);

/// Tables of an index per vertex while a mesh is cut into pieces. They are order, points, keepers, new and used indices, and
/// the file's vertex.
constexpr std::uint64_t kTablesPerVertex = 6;

/// What deriving tangents keeps of a vertex.
constexpr std::uint64_t kTangentBytes = sizeof(glm::dvec3) + 2 * sizeof(std::uint32_t);

/// Instances grow by doubling: the old arrays, and new ones twice as large.
constexpr std::uint64_t kGrowth = 3;

constexpr std::uint64_t kInstanceBytes =
    3 * sizeof(double) + sizeof(float) + sizeof(glm::mat3) + 3 * sizeof(std::uint32_t);

std::uint64_t positionCount(const Primitive& primitive, Accessors& accessors) {
    const Accessor* position = attributeOf(primitive, "POSITION", accessors);
    return position == nullptr ? 0 : position->count();
}

/// Of points and lines.
PrimitiveBytes predictSolids(std::uint64_t solids, VertexKind kind) {
    const std::uint64_t vertices = kSolidCorners * solids;
    const std::uint64_t indices = kSolidIndices.size() * solids;
    PrimitiveBytes bytes;
    bytes.kept = vertices * (sizeof(Vertex) + (kind == VertexKind::detailed ? sizeof(VertexDetail) : 0)) +
                 indices * kIndexBytes;
    bytes.passing = bytes.kept + vertices * (sizeof(glm::dvec3) + kTablesPerVertex * kIndexBytes) +
                    indices * kIndexBytes + solids * sizeof(SolidEnds);
    return bytes;
}

} // namespace

PrimitiveBytes predictBytes(const Primitive& primitive, Accessors& accessors, VertexKind kind) {
    if (groundOf(primitive) != Ground::surface) {
        return predictSolids(solidCount(primitive, accessors), kind);
    }
    const std::uint64_t corners = 3 * triangleCount(primitive, accessors);
    const std::uint64_t positions = positionCount(primitive, accessors);
    // Without normals each triangle has vertices of its own.
    const bool isShared = primitive.attributes.contains("NORMAL");
    const std::uint64_t vertices = isShared ? std::min(corners, positions) : corners;
    PrimitiveBytes bytes;
    if (kind == VertexKind::detailed) {
        // Deriving tangents may make twice as many vertices. MikkTSpace runs only in memory that is left beside (mesh.cpp).
        const std::uint64_t most = isShared ? std::min(corners, 2 * vertices) : corners;
        bytes.kept = most * (sizeof(Vertex) + sizeof(VertexDetail)) + corners * kIndexBytes;
        bytes.passing = bytes.kept + most * (kTangentBytes + kTablesPerVertex * kIndexBytes) +
                        corners * 2 * kIndexBytes + positions * kIndexBytes;
        return bytes;
    }
    bytes.kept = vertices * sizeof(Vertex) + corners * kIndexBytes;
    bytes.passing = vertices * (sizeof(Vertex) + kTablesPerVertex * kIndexBytes) + corners * 2 * kIndexBytes +
                    (isShared && corners > 0 ? positions * kIndexBytes : 0);
    return bytes;
}

MemoryPrediction::MemoryPrediction(std::uint64_t limit) : m_limit(limit) {}

void MemoryPrediction::add(const PrimitiveBytes& bytes, const std::string& where) {
    m_kept += bytes.kept;
    require(bytes.passing, where);
}

std::uint64_t MemoryPrediction::leftBeside(const PrimitiveBytes& bytes) const {
    return left() - std::min(left(), bytes.passing);
}

void MemoryPrediction::addInstances(std::uint64_t count, const std::string& what) {
    m_kept += count * kGrowth * kInstanceBytes;
    require(0, what);
}

void MemoryPrediction::require(std::uint64_t passing, const std::string& what) const {
    if (m_kept + passing > m_limit) {
        refuse("{}: the import would take {} bytes of memory, over the limit of {}", what, m_kept + passing,
               m_limit);
    }
}

} // namespace cdr::scene::gltf
