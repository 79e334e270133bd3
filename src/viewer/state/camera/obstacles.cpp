#include "obstacles.h"

#include <cdr/measure/truth/object_ray.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace cdr::viewer {

namespace {

std::vector<measure::Shape> shapesOf(const scene::Scene& scene, host::WorkerPool& workers) {
    std::vector<std::optional<measure::Shape>> made(scene.meshes.size());
    workers.run(made.size(), [&](std::size_t mesh, std::size_t) { made[mesh].emplace(scene.meshes[mesh]); });
    std::vector<measure::Shape> shapes;
    shapes.reserve(made.size());
    for (std::optional<measure::Shape>& shape : made) {
        shapes.push_back(std::move(*shape));
    }
    return shapes;
}

/// Whether a sphere comes near the straight way `from` + t * `way`, t from 0 to 1.
bool isInReach(const scene::Instances& instances, std::size_t i, const glm::dvec3& from,
               const glm::dvec3& way) {
    const glm::dvec3 centre = instances.position(i) - from;
    const double t = std::clamp(glm::dot(centre, way) / glm::dot(way, way), 0.0, 1.0);
    const double radius = instances.radius[i];
    const glm::dvec3 off = centre - t * way;
    return radius >= 0.0 && glm::dot(off, off) <= radius * radius;
}

} // namespace

Obstacles::Obstacles(const scene::Scene& scene, host::WorkerPool& workers)
    : m_scene(scene),
      m_shapes(shapesOf(scene, workers)) {}

double Obstacles::clearWay(const glm::dvec3& from, const glm::dvec3& to) const {
    const glm::dvec3 way = to - from;
    const double length = glm::length(way);
    const scene::Instances& instances = m_scene.instances;
    double share = 1.0;
    for (std::size_t i = 0; i < instances.size() && length > 0.0; ++i) {
        const scene::Material& material = m_scene.materials[instances.material[i]];
        if (!isInReach(instances, i, from, way) || material.alphaMode == scene::AlphaMode::blend) {
            continue;
        }
        if (const auto inverse = measure::invertBasis(instances.basis[i])) {
            // The difference first: exact far from the origin, too.
            const measure::ObjectRay ray{inverse->worldToObject * (from - instances.position(i)),
                                         inverse->worldToObject * way};
            share =
                std::min(share, m_shapes[instances.mesh[i]].nearest(ray, material.doubleSided, {0.0, share}));
        }
    }
    return share * length;
}

scene::Camera stopped(const scene::Camera& before, scene::Camera after, const Obstacles& obstacles) {
    const glm::dvec3 way = after.position - before.position;
    const double length = glm::length(way);
    if (length == 0.0) {
        return after;
    }
    const double margin = 2.0 * before.nearView;
    const glm::dvec3 reach = after.position + way / length * margin;
    const double clear = obstacles.clearWay(before.position, reach);
    if (clear < glm::length(reach - before.position)) { // to the bit what nothing in the way leaves
        after.position = before.position + way / length * std::max(clear - margin, 0.0);
    }
    return after;
}

} // namespace cdr::viewer
