#include <scenes/solids.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace cdr::scenes {

namespace {

/// Outward normal of an outline at a point, in the plane of the axis: x and radial.
glm::dvec2 outlineNormal(std::span<const glm::dvec2> outline, std::size_t i) {
    const glm::dvec2 before = outline[i == 0 ? 0 : i - 1];
    const glm::dvec2 after = outline[i + 1 == outline.size() ? i : i + 1];
    const glm::dvec2 along = glm::normalize(after - before);
    return {-along.y, along.x};
}

} // namespace

void addTriangle(scene::SourceMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto& at = mesh.positions;
    if (at[a] != at[b] && at[b] != at[c] && at[c] != at[a]) {
        mesh.indices.insert(mesh.indices.end(), {a, b, c});
    }
}

scene::SourceMesh turnedSolid(std::string name, std::span<const glm::dvec2> outline, std::uint32_t segments) {
    scene::SourceMesh mesh;
    mesh.name = std::move(name);
    for (std::size_t ring = 0; ring < outline.size(); ++ring) {
        const glm::dvec2 normal = outlineNormal(outline, ring);
        for (std::uint32_t i = 0; i <= segments; ++i) {
            const std::uint32_t step = i == segments ? 0 : i; // the last column is the first to the bit
            const double angle = 2.0 * std::numbers::pi * step / segments;
            const glm::dvec3 radial(0.0, std::cos(angle), std::sin(angle));
            mesh.positions.push_back(glm::dvec3(outline[ring].x, 0.0, 0.0) + outline[ring].y * radial);
            mesh.vertices.push_back(
                {.normal = glm::vec3(glm::dvec3(normal.x, 0.0, 0.0) + normal.y * radial)});
        }
    }
    const std::uint32_t columns = segments + 1;
    for (std::uint32_t ring = 0; ring + 1 < outline.size(); ++ring) {
        for (std::uint32_t i = 0; i < segments; ++i) {
            const std::uint32_t a = ring * columns + i;
            const std::uint32_t b = a + columns;
            addTriangle(mesh, a, a + 1, b + 1);
            addTriangle(mesh, a, b + 1, b);
        }
    }
    return mesh;
}

scene::SourceMesh hexahedron(std::string name, const std::array<glm::dvec3, 8>& corners) {
    constexpr std::array<std::array<std::size_t, 4>, 6> kSides{
        {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
    scene::SourceMesh mesh;
    mesh.name = std::move(name);
    for (const auto& side : kSides) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const glm::dvec3 normal = glm::normalize(
            glm::cross(corners[side[2]] - corners[side[0]], corners[side[3]] - corners[side[1]]));
        for (const std::size_t corner : side) {
            mesh.positions.push_back(corners[corner]);
            mesh.vertices.push_back({.normal = glm::vec3(normal)});
        }
        addTriangle(mesh, first, first + 1, first + 2);
        addTriangle(mesh, first, first + 2, first + 3);
    }
    return mesh;
}

scene::SourceMesh sphereMesh(std::string name, double radius, std::uint32_t segments) {
    std::vector<glm::dvec2> outline;
    const std::uint32_t rings = segments / 2;
    for (std::uint32_t i = 0; i <= rings; ++i) {
        const double angle = std::numbers::pi * i / rings;
        // The ends lie on the axis exactly.
        const double across = i == 0 || i == rings ? 0.0 : std::sin(angle);
        outline.push_back(radius * glm::dvec2(-std::cos(angle), across));
    }
    scene::SourceMesh mesh = turnedSolid(std::move(name), outline, segments);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.vertices[i].normal = glm::vec3(mesh.positions[i] / radius);
    }
    return mesh;
}

} // namespace cdr::scenes
