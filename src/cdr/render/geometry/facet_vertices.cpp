#include <cdr/render/geometry/facet_vertices.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <span>

namespace cdr::render {

namespace {

bool looksLike(const scene::Vertex& a, const scene::Vertex& b) {
    return a.normal == b.normal && a.color == b.color;
}

/// Gives each triangle a first vertex that has its facet's looks, and as few vertices as a greedy choice finds.
class VertexSharer {
  public:
    explicit VertexSharer(std::span<const scene::Vertex> vertices) : m_from(vertices) {
        std::map<std::array<std::uint32_t, 3>, std::uint32_t> places;
        for (const scene::Vertex& vertex : vertices) {
            const auto [entry, isNew] = places.try_emplace(bitsOf(vertex.position), m_atPlace.size());
            if (isNew) {
                m_atPlace.emplace_back();
            }
            m_placeOf.push_back(entry->second);
        }
    }

    std::vector<std::uint32_t> share(std::span<const std::uint32_t> indices) {
        std::vector<std::uint32_t> shared;
        shared.reserve(indices.size());
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            const Choice first = chooseFirst(indices, i);
            shared.push_back(first.vertex);
            for (const std::size_t corner : {first.corner + 1, first.corner + 2}) {
                shared.push_back(anyAt(indices[i + corner % 3]));
            }
        }
        return shared;
    }

    std::vector<scene::Vertex> takeVertices() { return std::move(m_vertices); }

  private:
    /// A vertex made here, and whether triangles start with it.
    struct Made {
        std::uint32_t vertex;
        bool isFirst;
    };
    struct Choice {
        std::size_t corner;
        std::uint32_t vertex;
    };

    static std::array<std::uint32_t, 3> bitsOf(const glm::vec3& position) {
        return {std::bit_cast<std::uint32_t>(position.x), std::bit_cast<std::uint32_t>(position.y),
                std::bit_cast<std::uint32_t>(position.z)};
    }

    Choice chooseFirst(std::span<const std::uint32_t> indices, std::size_t triangle) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            for (const Made& made : madeAt(indices[triangle + corner])) {
                if (made.isFirst && looksLike(m_vertices[made.vertex], m_from[indices[triangle]])) {
                    return {corner, made.vertex};
                }
            }
        }
        // A corner that the next triangle of the facet has too serves both.
        std::array<std::size_t, 3> corners{0, 1, 2};
        std::stable_partition(corners.begin(), corners.end(), [&](std::size_t corner) {
            return isInNext(indices, triangle, m_placeOf[indices[triangle + corner]]);
        });
        for (const std::size_t corner : corners) {
            for (Made& made : madeAt(indices[triangle + corner])) {
                if (!made.isFirst) {
                    made.isFirst = true;
                    m_vertices[made.vertex] = m_from[indices[triangle + corner]];
                    return {corner, made.vertex};
                }
            }
            if (madeAt(indices[triangle + corner]).empty()) {
                return {corner, make(indices[triangle + corner], true)};
            }
        }
        return {corners[0], make(indices[triangle + corners[0]], true)};
    }

    bool isInNext(std::span<const std::uint32_t> indices, std::size_t triangle, std::uint32_t place) const {
        const std::size_t next = triangle + 3;
        return next + 2 < indices.size() && looksLike(m_from[indices[triangle]], m_from[indices[next]]) &&
               std::any_of(&indices[next], &indices[next] + 3,
                           [&](std::uint32_t vertex) { return m_placeOf[vertex] == place; });
    }

    std::vector<Made>& madeAt(std::uint32_t from) { return m_atPlace[m_placeOf[from]]; }

    std::uint32_t anyAt(std::uint32_t from) {
        return madeAt(from).empty() ? make(from, false) : madeAt(from).front().vertex;
    }

    std::uint32_t make(std::uint32_t from, bool isFirst) {
        const auto vertex = static_cast<std::uint32_t>(m_vertices.size());
        m_vertices.push_back(m_from[from]);
        madeAt(from).push_back({vertex, isFirst});
        return vertex;
    }

    std::span<const scene::Vertex> m_from;
    std::vector<std::uint32_t> m_placeOf; ///< by vertex of m_from
    std::vector<std::vector<Made>> m_atPlace;
    std::vector<scene::Vertex> m_vertices;
};

} // namespace

scene::Mesh shareFacetVertices(const scene::Mesh& mesh) {
    VertexSharer sharer(mesh.vertices);
    scene::Mesh shared = mesh;
    shared.indices = sharer.share(mesh.indices);
    for (scene::MeshLevel& level : shared.levels) {
        level.indices = sharer.share(level.indices);
    }
    shared.vertices = sharer.takeVertices();
    return shared;
}

} // namespace cdr::render
