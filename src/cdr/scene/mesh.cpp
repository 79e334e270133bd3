#include <cdr/scene/mesh.h>
#include <cdr/scene/rounded_up.h>

#include <algorithm>

namespace cdr::scene {

float boundingRadiusOf(std::span<const Vertex> vertices) {
    double farthest = 0.0;
    for (const Vertex& vertex : vertices) {
        farthest = std::max(farthest, glm::length(glm::dvec3(vertex.position)));
    }
    return roundedUp(farthest);
}

Mesh makeBox(const glm::vec3& halfSides) {
    Mesh mesh;
    mesh.name = "box";
    mesh.boundingRadius = static_cast<float>(glm::length(glm::dvec3(halfSides)));
    mesh.boxHalfSides = halfSides;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0.0f);
            normal[axis] = side;
            // u x v = normal, so corners in the order (-,-) (+,-) (+,+) (-,+) run counter-clockwise from
            // outside.
            glm::vec3 u(0.0f);
            u[(axis + 1) % 3] = side;
            const glm::vec3 v = glm::cross(normal, u);
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const glm::vec2 corner :
                 {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
                mesh.vertices.push_back({.position = (normal + corner.x * u + corner.y * v) * halfSides,
                                         .normal = normal,
                                         .uv = corner * 0.5f + 0.5f});
            }
            for (const std::uint32_t index : {0u, 1u, 2u, 0u, 2u, 3u}) {
                mesh.indices.push_back(first + index);
            }
        }
    }
    return mesh;
}

Mesh unshareVertices(const Mesh& mesh) {
    Mesh unshared = mesh;
    unshared.vertices.clear();
    unshared.details.clear();
    unshared.levels.clear();
    unshared.clusters = {};
    for (std::uint32_t& index : unshared.indices) {
        unshared.vertices.push_back(mesh.vertices[index]);
        if (!mesh.details.empty()) {
            unshared.details.push_back(mesh.details[index]);
        }
        index = static_cast<std::uint32_t>(unshared.vertices.size() - 1);
    }
    return unshared;
}

} // namespace cdr::scene
