#include <cdr/render/upload/closed_mesh.h>

#include <bit>
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

} // namespace

bool isClosed(std::span<const scene::Vertex> vertices, std::span<const std::uint32_t> indices) {
    if (indices.size() > 3 * kMostClosedTriangles) {
        return false;
    }
    std::vector<std::uint64_t> places;
    places.reserve(vertices.size());
    for (const scene::Vertex& vertex : vertices) {
        places.push_back(hashOf(vertex.position));
    }
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const std::uint64_t a = places[indices[i]];
        const std::uint64_t b = places[indices[i + 1]];
        const std::uint64_t c = places[indices[i + 2]];
        sum += edgeHash(a, b) + edgeHash(b, c) + edgeHash(c, a);
    }
    return sum == 0;
}

} // namespace cdr::render
