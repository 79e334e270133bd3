#include <cdr/scene/lod/mesh_pieces.h>
#include <cdr/scene/lod/triangle_clusters.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

namespace cdr::scene {

namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kTrianglesPerPiece = 8;

/// For each position the index of the first equal one in sorted order. Vertices that differ only in normal or
/// texture coordinate are one point.
std::vector<std::uint32_t> pointsOf(const SourceMesh& source) {
    std::vector<std::uint32_t> order(source.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        const glm::dvec3 position = source.positionOf(i);
        return std::array{position.x, position.y, position.z};
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
    std::vector<std::uint32_t> points(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && source.positionOf(order[i]) == source.positionOf(order[i - 1]);
        points[order[i]] = same ? points[order[i - 1]] : order[i];
    }
    return points;
}

/// Gives each point's triangles to the widest cluster that meets there.
void closeSeams(std::span<const std::uint32_t> points, std::span<const std::uint32_t> indices,
                std::vector<TriangleCluster>& clusters) {
    std::vector<std::uint32_t> keeper(points.size(), kUnused); // by point
    const auto pointAt = [&](std::uint32_t triangle, std::size_t corner) {
        return points[indices[std::size_t{3} * triangle + corner]];
    };
    for (std::uint32_t c = 0; c < clusters.size(); ++c) {
        for (const std::uint32_t triangle : clusters[c].triangles) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                std::uint32_t& kept = keeper[pointAt(triangle, corner)];
                kept = kept == kUnused || clusters[c].radius() > clusters[kept].radius() ? c : kept;
            }
        }
    }
    std::vector<std::vector<std::uint32_t>> borrowed(clusters.size());
    for (std::uint32_t c = 0; c < clusters.size(); ++c) {
        for (const std::uint32_t triangle : clusters[c].triangles) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                std::vector<std::uint32_t>& taken = borrowed[keeper[pointAt(triangle, corner)]];
                if (keeper[pointAt(triangle, corner)] != c && (taken.empty() || taken.back() != triangle)) {
                    taken.push_back(triangle);
                }
            }
        }
    }
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        std::vector<std::uint32_t>& triangles = clusters[c].triangles;
        triangles.insert(triangles.end(), borrowed[c].begin(), borrowed[c].end());
        std::sort(triangles.begin(), triangles.end());
        triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    }
}

/// Copies triangles out of a source.
class PieceMaker {
  public:
    explicit PieceMaker(const SourceMesh& source)
        : m_source(source),
          m_newIndex(source.vertices.size(), kUnused) {}

    MeshPiece make(std::span<const std::uint32_t> triangles, const glm::dvec3& origin, std::string name) {
        MeshPiece piece{.mesh = {}, .origin = origin};
        piece.mesh.name = std::move(name);
        piece.mesh.indices.reserve(3 * triangles.size());
        if (3 * triangles.size() == m_source.indices.size()) { // all of it: most of its vertices are used
            piece.mesh.vertices.reserve(m_source.vertices.size());
        }
        std::vector<std::uint32_t> used;
        for (const std::uint32_t triangle : triangles) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const std::uint32_t index = m_source.indices[std::size_t{3} * triangle + corner];
                if (m_newIndex[index] == kUnused) {
                    m_newIndex[index] = static_cast<std::uint32_t>(used.size());
                    used.push_back(index);
                    Vertex vertex = m_source.vertices[index];
                    vertex.position = glm::vec3(m_source.positionOf(index) - origin);
                    piece.mesh.vertices.push_back(vertex);
                    if (!m_source.details.empty()) {
                        piece.mesh.details.push_back(m_source.details[index]);
                    }
                }
                piece.mesh.indices.push_back(m_newIndex[index]);
            }
        }
        for (const std::uint32_t index : used) {
            m_newIndex[index] = kUnused;
        }
        piece.mesh.boundingRadius = boundingRadiusOf(piece.mesh.vertices);
        return piece;
    }

  private:
    const SourceMesh& m_source;
    std::vector<std::uint32_t> m_newIndex; ///< by vertex of the source; kUnused between calls
};

std::vector<TriangleCluster> clustersOf(const SourceMesh& source, double radius) {
    const std::size_t triangles = source.indices.size() / 3;
    const std::size_t most = std::clamp<std::size_t>(triangles / kTrianglesPerPiece, 2, kMaxPieces);
    return clusterTriangles(source, radius, most);
}

/// Each about the middle of its box: from there to a float32 vertex at least the piece's size from the source's origin is a
/// float32 without rounding.
std::vector<MeshPiece> makePieces(const SourceMesh& source, std::vector<TriangleCluster> clusters) {
    PieceMaker maker(source);
    if (clusters.size() > 1) {
        closeSeams(pointsOf(source), source.indices, clusters);
    }
    std::vector<MeshPiece> pieces;
    for (const TriangleCluster& cluster : clusters) {
        const std::string suffix = clusters.size() > 1 ? " piece " + std::to_string(pieces.size()) : "";
        pieces.push_back(maker.make(cluster.triangles, cluster.bounds.centre(), source.name + suffix));
    }
    return pieces;
}

/// Whether a piece of all triangles has the same vertices in the same order.
bool isInOrderOfUse(const SourceMesh& source) {
    std::size_t used = 0;
    for (const std::uint32_t index : source.indices) {
        if (index > used) {
            return false;
        }
        used += index == used ? 1 : 0;
    }
    return used == source.vertices.size();
}

/// The piece of all triangles of a mesh that isInOrderOfUse().
MeshPiece takeWhole(SourceMesh&& source, const glm::dvec3& origin) {
    for (std::size_t i = 0; i < source.vertices.size(); ++i) {
        source.vertices[i].position = glm::vec3(source.positionOf(i) - origin);
    }
    MeshPiece piece{.mesh = {}, .origin = origin};
    piece.mesh.name = std::move(source.name);
    piece.mesh.vertices = std::move(source.vertices);
    piece.mesh.details = std::move(source.details);
    piece.mesh.indices = std::move(source.indices);
    source = {};
    piece.mesh.boundingRadius = boundingRadiusOf(piece.mesh.vertices);
    return piece;
}

/// Around all vertices.
Box boxOf(const SourceMesh& source) {
    Box box;
    for (std::size_t i = 0; i < source.vertices.size(); ++i) {
        box.add(source.positionOf(i));
    }
    return box;
}

} // namespace

std::vector<MeshPiece> cutIntoPieces(const SourceMesh& source, double radius) {
    return makePieces(source, clustersOf(source, radius));
}

std::vector<MeshPiece> cutIntoPieces(SourceMesh&& source, double radius) {
    // Clusters list all triangles, which a mesh that stays whole does not need.
    const Box box = boxOf(source);
    std::vector<MeshPiece> pieces;
    if (0.5 * box.diagonal() <= radius && isInOrderOfUse(source)) {
        pieces.push_back(takeWhole(std::move(source), box.centre()));
    } else {
        pieces = makePieces(source, clustersOf(source, radius));
        source = {};
    }
    return pieces;
}

PieceSet addPieces(Scene& scene, std::vector<MeshPiece> pieces) {
    PieceSet set{.firstMesh = static_cast<std::uint32_t>(scene.meshes.size()), .origins = {}};
    for (MeshPiece& piece : pieces) {
        scene.meshes.push_back(std::move(piece.mesh));
        set.origins.push_back(piece.origin);
    }
    return set;
}

void placePieces(Scene& scene, const PieceSet& pieces, std::uint32_t material, std::uint32_t object,
                 const glm::dmat4& toWorld) {
    const glm::mat3 basis{glm::dmat3(toWorld)};
    for (std::size_t i = 0; i < pieces.origins.size(); ++i) {
        const glm::dvec3 position(toWorld * glm::dvec4(pieces.origins[i], 1.0));
        addInstance(scene, pieces.firstMesh + static_cast<std::uint32_t>(i), material, object, position,
                    basis);
    }
}

} // namespace cdr::scene
