#include <cdr/measure/certify/mesh_outline.h>

#include <map>
#include <unordered_map>

namespace cdr::measure {

namespace {

/// The faces that have an edge in this direction.
struct EdgeUse {
    std::uint32_t face = MeshOutline::kNoNeighbour;
    std::uint32_t count = 0;
};
using EdgeUses = std::unordered_map<std::uint64_t, EdgeUse>;

std::uint64_t edgeKey(std::uint32_t from, std::uint32_t to) {
    return (std::uint64_t{from} << 32u) | to;
}

/// Per vertex the number of its position among those that differ, which are appended to `positions`.
std::vector<std::uint32_t> mergePositions(const scene::Mesh& mesh, std::vector<glm::dvec3>& positions) {
    const auto less = [](const glm::vec3& a, const glm::vec3& b) {
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    };
    std::map<glm::vec3, std::uint32_t, decltype(less)> numbers(less);
    std::vector<std::uint32_t> merged;
    merged.reserve(mesh.vertices.size());
    for (const scene::Vertex& vertex : mesh.vertices) {
        const auto [found, isNew] =
            numbers.try_emplace(vertex.position, static_cast<std::uint32_t>(positions.size()));
        if (isNew) {
            positions.emplace_back(vertex.position);
        }
        merged.push_back(found->second);
    }
    return merged;
}

} // namespace

MeshOutline outlineOf(const scene::Mesh& mesh) {
    MeshOutline outline;
    const std::vector<std::uint32_t> merged = mergePositions(mesh, outline.positions);
    for (const glm::dvec3& position : outline.positions) {
        outline.reach = glm::max(outline.reach, glm::abs(position));
    }
    EdgeUses uses;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::array corners{merged[mesh.indices[i]], merged[mesh.indices[i + 1]],
                                 merged[mesh.indices[i + 2]]};
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
            continue;
        }
        for (std::size_t edge = 0; edge < 3; ++edge) {
            EdgeUse& use = uses[edgeKey(corners[edge], corners[(edge + 1) % 3])];
            use.face = static_cast<std::uint32_t>(outline.faces.size());
            ++use.count;
        }
        outline.faces.push_back({corners, {}, static_cast<std::uint32_t>(i)});
    }
    for (MeshOutline::Face& face : outline.faces) {
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const std::uint32_t from = face.corners[edge];
            const std::uint32_t to = face.corners[(edge + 1) % 3];
            const auto across = uses.find(edgeKey(to, from));
            const bool isPair =
                across != uses.end() && across->second.count == 1 && uses.at(edgeKey(from, to)).count == 1;
            face.neighbours[edge] = isPair ? across->second.face : MeshOutline::kNoNeighbour;
        }
    }
    return outline;
}

} // namespace cdr::measure
