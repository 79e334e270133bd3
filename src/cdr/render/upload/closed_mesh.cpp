#include <cdr/render/upload/closed_mesh.h>

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <vector>

namespace cdr::render {

namespace {

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t value) {
    value = (value ^ (value >> 30u)) * 0xbf58476d1ce4e5b9u;
    value = (value ^ (value >> 27u)) * 0x94d049bb133111ebu;
    return value ^ (value >> 31u);
}

std::uint64_t hashOf(const glm::vec3& position) {
    const auto bitsOf = [](float place) -> std::uint64_t {
        return std::bit_cast<std::uint32_t>(place + 0.0f); // -0 is 0
    };
    return mixed(bitsOf(position.x) * 0x9e3779b97f4a7c15u + bitsOf(position.y) * 0xc2b2ae3d27d4eb4fu +
                 bitsOf(position.z) * 0x165667b19e3779f9u);
}

/// The opposite number in the other direction, and 0 where both ends are at the same place.
std::uint64_t edgeHash(std::uint64_t from, std::uint64_t to) {
    if (from == to) {
        return 0;
    }
    return from < to ? mixed(from + 3 * to) : ~mixed(to + 3 * from) + 1;
}

std::vector<std::uint64_t> hashesOf(std::span<const scene::Vertex> vertices) {
    std::vector<std::uint64_t> hashes(vertices.size());
    std::transform(vertices.begin(), vertices.end(), hashes.begin(),
                   [](const scene::Vertex& vertex) { return hashOf(vertex.position); });
    return hashes;
}

/// @param places hashes of the vertices' positions
bool hasNoOpenEdge(std::span<const std::uint64_t> places, std::span<const std::uint32_t> indices) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const std::uint64_t a = places[indices[i]];
        const std::uint64_t b = places[indices[i + 1]];
        const std::uint64_t c = places[indices[i + 2]];
        sum += edgeHash(a, b) + edgeHash(b, c) + edgeHash(c, a);
    }
    return sum == 0;
}

/// Sets of vertices, of which each begins as one.
class Parts {
  public:
    explicit Parts(std::size_t vertices) : m_towards(vertices) {
        std::iota(m_towards.begin(), m_towards.end(), 0u);
    }
    std::uint32_t of(std::uint32_t vertex) {
        while (m_towards[vertex] != vertex) {
            m_towards[vertex] = m_towards[m_towards[vertex]];
            vertex = m_towards[vertex];
        }
        return vertex;
    }
    void join(std::uint32_t a, std::uint32_t b) { m_towards[of(a)] = of(b); }

  private:
    std::vector<std::uint32_t> m_towards; ///< another vertex of the set, or itself
};

/// What triangles connect, and vertices at one place.
Parts partsOf(std::span<const std::uint64_t> places, std::span<const std::uint32_t> indices) {
    Parts parts(places.size());
    std::vector<std::uint32_t> order(places.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return places[a] < places[b]; });
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (places[order[i]] == places[order[i - 1]]) {
            parts.join(order[i], order[i - 1]);
        }
    }
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        parts.join(indices[i], indices[i + 1]);
        parts.join(indices[i], indices[i + 2]);
    }
    return parts;
}

/// Whether each part's volume is above 0, which it is where triangles face away from it.
bool facesOutwards(std::span<const scene::Vertex> vertices, std::span<const std::uint32_t> indices,
                   Parts parts) {
    std::map<std::uint32_t, double> volumes; // times 6
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const auto at = [&](std::size_t corner) {
            return glm::dvec3(vertices[indices[i + corner]].position);
        };
        volumes[parts.of(indices[i])] += glm::dot(at(0), glm::cross(at(1), at(2)));
    }
    return std::all_of(volumes.begin(), volumes.end(), [](const auto& part) { return part.second > 0.0; });
}

} // namespace

bool isClosed(std::span<const scene::Vertex> vertices, std::span<const std::uint32_t> indices) {
    if (indices.size() > 3 * kMostClosedTriangles) {
        return false;
    }
    const std::vector<std::uint64_t> places = hashesOf(vertices);
    return hasNoOpenEdge(places, indices) && facesOutwards(vertices, indices, partsOf(places, indices));
}

} // namespace cdr::render
