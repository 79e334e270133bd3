#include <cdr/scene/lod/surface_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cdr::scene {

namespace {

constexpr std::uint32_t kLeafTriangles = 4;
/// Most parts an edge is cut into where a triangle is sampled.
constexpr double kMostParts = 32.0;

double squared(const glm::dvec3& v) {
    return glm::dot(v, v);
}

double squaredToSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 along = b - a;
    const double length2 = squared(along);
    const double share = length2 > 0.0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
    return squared(p - (a + share * along));
}

/// The plane's distance where the point stands over the triangle, else that of the nearest edge.
double squaredToTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double area2 = squared(normal);
    const auto isInside = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return glm::dot(glm::cross(to - from, p - from), normal) >= 0.0;
    };
    if (area2 > 0.0 && isInside(a, b) && isInside(b, c) && isInside(c, a)) {
        const double height = glm::dot(p - a, normal);
        return height * height / area2;
    }
    return std::min({squaredToSegment(p, a, b), squaredToSegment(p, b, c), squaredToSegment(p, c, a)});
}

double squaredToBox(const glm::dvec3& p, const glm::dvec3& low, const glm::dvec3& high) {
    return squared(glm::max(glm::max(low - p, p - high), glm::dvec3(0.0)));
}

} // namespace

SurfaceDistance::SurfaceDistance(std::span<const glm::vec3> positions,
                                 std::span<const std::uint32_t> indices) {
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        m_triangles.push_back({glm::dvec3(positions[indices[i]]), glm::dvec3(positions[indices[i + 1]]),
                               glm::dvec3(positions[indices[i + 2]])});
    }
    m_nodes.emplace_back();
    build(0, 0, static_cast<std::uint32_t>(m_triangles.size()));
}

void SurfaceDistance::build(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high(-low);
    for (std::uint32_t i = begin; i < end; ++i) {
        const Triangle& t = m_triangles[i];
        low = glm::min(low, glm::min(t.a, glm::min(t.b, t.c)));
        high = glm::max(high, glm::max(t.a, glm::max(t.b, t.c)));
    }
    m_nodes[node] = {.low = low, .high = high, .left = 0, .begin = begin, .end = end};
    if (end - begin <= kLeafTriangles) {
        return;
    }
    const glm::dvec3 sides = high - low;
    const int axis = sides.x >= std::max(sides.y, sides.z) ? 0 : (sides.y >= sides.z ? 1 : 2); // the longest
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::uint32_t i) { return m_triangles.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [axis](const Triangle& s, const Triangle& t) {
        return s.a[axis] + s.b[axis] + s.c[axis] < t.a[axis] + t.b[axis] + t.c[axis];
    });
    const auto left = static_cast<std::uint32_t>(m_nodes.size());
    m_nodes[node].left = left;
    m_nodes.resize(m_nodes.size() + 2);
    build(left, begin, middle);
    build(left + 1, middle, end);
}

void SurfaceDistance::search(std::uint32_t node, const glm::dvec3& point, double& best) const {
    const Node& self = m_nodes[node];
    if (self.left == 0) {
        for (std::uint32_t i = self.begin; i < self.end; ++i) {
            const Triangle& t = m_triangles[i];
            best = std::min(best, squaredToTriangle(point, t.a, t.b, t.c));
        }
        return;
    }
    const auto toChild = [&](std::uint32_t child) {
        return squaredToBox(point, m_nodes[child].low, m_nodes[child].high);
    };
    const double toLeft = toChild(self.left);
    const double toRight = toChild(self.left + 1);
    const std::uint32_t nearer = toLeft <= toRight ? self.left : self.left + 1;
    const std::uint32_t farther = toLeft <= toRight ? self.left + 1 : self.left;
    if (std::min(toLeft, toRight) < best) {
        search(nearer, point, best);
    }
    if (std::max(toLeft, toRight) < best) {
        search(farther, point, best);
    }
}

double SurfaceDistance::squaredTo(const glm::dvec3& point) const {
    double best = std::numeric_limits<double>::infinity();
    search(0, point, best);
    return best;
}

double surfaceDeviation(std::span<const glm::vec3> positions, std::span<const std::uint32_t> full,
                        std::span<const std::uint32_t> coarse) {
    const SurfaceDistance toCoarse(positions, coarse);
    const SurfaceDistance toFull(positions, full);
    double greatest = 0.0;
    std::vector<bool> seen(positions.size());
    for (const std::uint32_t vertex : full) {
        if (!seen[vertex]) {
            seen[vertex] = true;
            greatest = std::max(greatest, toCoarse.squaredTo(glm::dvec3(positions[vertex])));
        }
    }
    const double perTriangle = static_cast<double>(full.size()) / static_cast<double>(coarse.size());
    const int parts = static_cast<int>(std::clamp(std::ceil(std::sqrt(perTriangle)), 2.0, kMostParts));
    for (std::size_t i = 0; i + 2 < coarse.size(); i += 3) {
        const glm::dvec3 a(positions[coarse[i]]);
        const glm::dvec3 u = (glm::dvec3(positions[coarse[i + 1]]) - a) / static_cast<double>(parts);
        const glm::dvec3 v = (glm::dvec3(positions[coarse[i + 2]]) - a) / static_cast<double>(parts);
        for (int j = 0; j <= parts; ++j) {
            for (int k = 0; j + k <= parts; ++k) {
                greatest = std::max(
                    greatest, toFull.squaredTo(a + static_cast<double>(j) * u + static_cast<double>(k) * v));
            }
        }
    }
    return std::sqrt(greatest);
}

} // namespace cdr::scene
