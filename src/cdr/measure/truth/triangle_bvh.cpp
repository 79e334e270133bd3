#include <cdr/base/error.h>
#include <cdr/measure/truth/triangle_bvh.h>
#include <cdr/measure/truth/triangle_bvh_builder.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cdr::measure {

namespace {

std::vector<Triangle> trianglesOf(const scene::Mesh& mesh) {
    for (const scene::Vertex& vertex : mesh.vertices) {
        const glm::vec3& p = vertex.position;
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
            throw base::InputError("mesh '" + mesh.name + "' has a vertex that is not finite");
        }
    }
    std::vector<Triangle> triangles(mesh.indices.size() / 3);
    for (std::size_t i = 0; i < triangles.size() * 3; ++i) {
        const std::uint32_t index = mesh.indices[i];
        if (index >= mesh.vertices.size()) {
            throw base::InputError("mesh '" + mesh.name + "' has an index past its last vertex");
        }
        triangles[i / 3][i % 3] = mesh.vertices[index].position;
    }
    return triangles;
}

} // namespace

/// One ray's way through the tree, in parameters local to `m_ray.origin`.
class TriangleBvh::Walk {
  public:
    Walk(const ObjectRay& ray, double nearLocal, double farLocal)
        : m_ray(ray),
          m_inverse(1.0 / ray.direction),
          m_near(nearLocal),
          m_far(farLocal) {
        for (int axis = 0; axis < 3; ++axis) {
            m_enterCorner[static_cast<std::size_t>(axis)] = std::signbit(ray.direction[axis]) ? 1 : 0;
        }
    }

    /// Where the ray enters the node's box; kNoHit when it misses it, or the box lies outside [near, far].
    double enter(const Node& node) const {
        double enter = m_near;
        double leave = m_far;
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t corner = m_enterCorner[static_cast<std::size_t>(axis)];
            const double a = (node.corners[corner][axis] - m_ray.origin[axis]) * m_inverse[axis];
            const double b = (node.corners[1 - corner][axis] - m_ray.origin[axis]) * m_inverse[axis];
            // NaN, a ray within the face's plane, compares false and so bounds nothing.
            enter = a > enter ? a : enter;
            leave = b < leave ? b : leave;
        }
        return enter <= leave ? enter : kNoHit;
    }

    /// From now on, boxes behind `farLocal` are missed.
    void shorten(double farLocal) { m_far = std::min(m_far, farLocal); }

    /// Visits the leaves that the ray enters, the nearer child of a node first.
    template <typename Visitor>
    void visitLeaves(const std::vector<Node>& nodes, const Visitor& visitLeaf) {
        std::array<Entry, Builder::kMaxDepth + 2> open;
        std::size_t openCount = 0;
        open[openCount++] = {0, enter(nodes[0])};
        while (openCount > 0) {
            const Entry entry = open[--openCount];
            if (entry.enter > m_far) {
                continue;
            }
            const Node& node = nodes[entry.node];
            if (node.count > 0) {
                visitLeaf(node);
                continue;
            }
            Entry nearer{node.first, enter(nodes[node.first])};
            Entry farther{node.first + 1, enter(nodes[node.first + 1])};
            if (farther.enter < nearer.enter) {
                std::swap(nearer, farther);
            }
            for (const Entry& child : {farther, nearer}) {
                if (child.enter < kNoHit) {
                    open[openCount++] = child;
                }
            }
        }
    }

  private:
    struct Entry {
        std::uint32_t node;
        double enter;
    };

    ObjectRay m_ray;
    glm::dvec3 m_inverse;
    std::array<std::size_t, 3> m_enterCorner{};
    double m_near;
    double m_far;
};

TriangleBvh::TriangleBvh(const scene::Mesh& mesh) {
    const std::vector<Triangle> triangles = trianglesOf(mesh);
    for (const Triangle& triangle : triangles) {
        for (const glm::vec3& corner : triangle) {
            m_bounds.add(corner);
        }
    }
    m_centre = glm::dvec3(m_bounds.lower) * 0.5 + glm::dvec3(m_bounds.upper) * 0.5;
    const glm::vec3 reach = glm::max(glm::abs(m_bounds.lower), glm::abs(m_bounds.upper));
    Builder builder(triangles, 1e-6f * std::max({reach.x, reach.y, reach.z}));
    m_nodes = std::move(builder.nodes);
    m_triangles.reserve(triangles.size());
    m_places.reserve(triangles.size());
    for (const std::uint32_t i : builder.order) {
        m_triangles.push_back(triangles[i]);
        m_places.push_back(3 * i);
    }
}

template <typename IsKept>
double TriangleBvh::nearestOf(const ObjectRay& ray, Sidedness sides, const ViewRange& range,
                              const IsKept& isKept) const {
    if (m_nodes.empty()) {
        return kNoHit;
    }
    // Start where the ray passes the mesh: the subtraction of far-away coordinates then rounds once per ray,
    // and not once per corner.
    const double shift = ray.shiftTo(m_centre);
    const ObjectRay local = ray.from(shift);
    // The slack keeps hits exactly at the range's ends for the exact test of each triangle.
    const double slack = 1e-15 * (std::abs(shift) + range.farView);
    Walk walk(local, range.nearView - shift - slack, range.farView - shift + slack);
    const ShearedRay sheared(local);
    double best = kNoHit;
    walk.visitLeaves(m_nodes, [&](const Node& leaf) {
        for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
            const double hit = sheared.meet(m_triangles[i], sides);
            if (shift + hit < best && range.holds(shift + hit) && isKept(i, shift + hit)) {
                best = shift + hit;
                walk.shorten(hit);
            }
        }
    });
    return best;
}

double TriangleBvh::nearest(const ObjectRay& ray, Sidedness sides, const ViewRange& range) const {
    return nearestOf(ray, sides, range, [](std::uint32_t, double) { return true; });
}

double TriangleBvh::nearest(const ObjectRay& ray, Sidedness sides, const ViewRange& range,
                            const Keeps& keeps) const {
    return nearestOf(ray, sides, range,
                     [&](std::uint32_t i, double hitView) { return keeps(m_places[i], hitView); });
}

} // namespace cdr::measure
