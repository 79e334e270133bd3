#include <cdr/scene/lod/surface_distance.h>

#include <algorithm>
#include <cmath>

namespace cdr::scene {

namespace {

/// Most parts an edge is cut into where a triangle is sampled.
constexpr double kMaxParts = 32.0;

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

double squaredToBox(const glm::dvec3& p, const Box& box) {
    return squared(glm::max(glm::max(box.low - p, p - box.high), glm::dvec3(0.0)));
}

} // namespace

SurfaceDistance::SurfaceDistance(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices)
    : m_triangles(trianglesOf(positions, indices)),
      m_tree(boxesOf(m_triangles)) {}

std::vector<SurfaceDistance::Triangle> SurfaceDistance::trianglesOf(std::span<const glm::vec3> positions,
                                                                    std::span<const std::uint32_t> indices) {
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        triangles.push_back({glm::dvec3(positions[indices[i]]), glm::dvec3(positions[indices[i + 1]]),
                             glm::dvec3(positions[indices[i + 2]])});
    }
    return triangles;
}

std::vector<Box> SurfaceDistance::boxesOf(std::span<const Triangle> triangles) {
    std::vector<Box> boxes(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (const glm::dvec3& corner : {triangles[i].a, triangles[i].b, triangles[i].c}) {
            boxes[i].add(corner);
        }
    }
    return boxes;
}

void SurfaceDistance::search(std::uint32_t node, const glm::dvec3& point, double enough,
                             Nearest& best) const {
    const BoxTree::Node& self = m_tree.nodes()[node];
    if (self.count > 0) {
        for (const std::uint32_t item : m_tree.order().subspan(self.first, self.count)) {
            const Triangle& t = m_triangles[item];
            const double found = squaredToTriangle(point, t.a, t.b, t.c);
            if (found < best.squared) {
                best = {.squared = found, .triangle = item};
            }
        }
        return;
    }
    const double toFirst = squaredToBox(point, m_tree.nodes()[self.first].box);
    const double toSecond = squaredToBox(point, m_tree.nodes()[self.first + 1].box);
    const std::uint32_t nearer = toFirst <= toSecond ? self.first : self.first + 1;
    const std::uint32_t farther = toFirst <= toSecond ? self.first + 1 : self.first;
    if (std::min(toFirst, toSecond) < best.squared) {
        search(nearer, point, enough, best);
    }
    if (std::max(toFirst, toSecond) < best.squared && best.squared > enough) {
        search(farther, point, enough, best);
    }
}

SurfaceDistance::Nearest SurfaceDistance::nearestTo(const glm::dvec3& point) const {
    Nearest best;
    search(0, point, 0.0, best);
    return best;
}

double SurfaceDistance::largerSquared(const glm::dvec3& point, double known) const {
    Nearest best;
    search(0, point, known, best);
    return std::max(known, best.squared);
}

double SurfaceDistance::largestSquaredTo(const std::array<glm::dvec3, 3>& triangle, double points,
                                         double known) const {
    const int parts = static_cast<int>(std::clamp(std::ceil(std::sqrt(points)), 2.0, kMaxParts));
    const glm::dvec3 u = (triangle[1] - triangle[0]) / static_cast<double>(parts);
    const glm::dvec3 v = (triangle[2] - triangle[0]) / static_cast<double>(parts);
    double largest = known;
    for (int j = 0; j <= parts; ++j) {
        for (int k = 0; j + k <= parts; ++k) {
            largest =
                largerSquared(triangle[0] + static_cast<double>(j) * u + static_cast<double>(k) * v, largest);
        }
    }
    return largest;
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
            greatest = toCoarse.largerSquared(glm::dvec3(positions[vertex]), greatest);
        }
    }
    const double perTriangle = static_cast<double>(full.size()) / static_cast<double>(coarse.size());
    for (std::size_t i = 0; i + 2 < coarse.size(); i += 3) {
        const std::array corners{glm::dvec3(positions[coarse[i]]), glm::dvec3(positions[coarse[i + 1]]),
                                 glm::dvec3(positions[coarse[i + 2]])};
        greatest = toFull.largestSquaredTo(corners, perTriangle, greatest);
    }
    return std::sqrt(greatest);
}

} // namespace cdr::scene
