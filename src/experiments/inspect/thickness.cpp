#include "thickness.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace cdr::experiments {

double thicknessOf(const scene::Scene& scene, std::size_t instance) {
    const scene::Mesh& mesh = scene.meshes[scene.instances.mesh[instance]];
    const glm::dmat3 basis(scene.instances.basis[instance]);
    const auto cornerOf = [&](std::uint32_t vertex) {
        return basis * glm::dvec3(mesh.vertices[vertex].position);
    };
    glm::dvec3 largest(0.0); // twice a triangle's area, along its normal
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 first = cornerOf(mesh.indices[i]);
        const glm::dvec3 area =
            glm::cross(cornerOf(mesh.indices[i + 1]) - first, cornerOf(mesh.indices[i + 2]) - first);
        if (glm::dot(area, area) > glm::dot(largest, largest)) {
            largest = area;
        }
    }
    if (largest == glm::dvec3(0.0)) {
        return 0.0;
    }
    const glm::dvec3 normal = glm::normalize(largest);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const std::uint32_t vertex : mesh.indices) {
        const double along = glm::dot(normal, cornerOf(vertex));
        low = std::min(low, along);
        high = std::max(high, along);
    }
    return high - low;
}

} // namespace cdr::experiments
