#include "obstacles.h"

#include <cdr/measure/truth/object_ray.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace cdr::viewer {

namespace {

std::vector<std::shared_ptr<const measure::Shape>> shapesOf(const scene::Scene& scene,
                                                            platform::WorkerPool& workers) {
    std::vector<std::shared_ptr<const measure::Shape>> shapes(scene.meshes.size());
    workers.run(shapes.size(), [&](std::size_t mesh, std::size_t) {
        shapes[mesh] = std::make_shared<const measure::Shape>(scene.meshes[mesh]);
    });
    return shapes;
}

} // namespace

struct Obstacles::Way {
    glm::dvec3 from;
    glm::dvec3 along;
    double share = 1.0; ///< of `along` that is clear as far as is known

    /// Whether it may come near a sphere whose centre is in the box.
    bool mayMeet(const visibility::InstanceCells::Box& box) const {
        const glm::dvec3 low = glm::min(from, from + along);
        const glm::dvec3 high = glm::max(from, from + along);
        return glm::all(glm::lessThanEqual(low, box.high + box.radius)) &&
               glm::all(glm::greaterThanEqual(high, box.low - box.radius));
    }
    bool meets(const glm::dvec3& centre, double radius) const {
        const glm::dvec3 to = centre - from;
        const double t = std::clamp(glm::dot(to, along) / glm::dot(along, along), 0.0, 1.0);
        const glm::dvec3 off = to - t * along;
        return glm::dot(off, off) <= radius * radius;
    }
};

Obstacles::Obstacles(const scene::Scene& scene, platform::WorkerPool& workers)
    : m_scene(scene),
      m_instances(std::shared_ptr<void>(), &scene.instances),
      m_shapes(shapesOf(scene, workers)) {
    m_cells.build(scene, workers);
}

Obstacles Obstacles::moved(const scene::Scene& shown, std::span<const std::uint32_t> deformed,
                           platform::WorkerPool& workers) const {
    Obstacles there(*this);
    workers.run(deformed.size(), [&](std::size_t i, std::size_t) {
        there.m_shapes[deformed[i]] = std::make_shared<const measure::Shape>(shown.meshes[deformed[i]]);
    });
    there.m_instances = std::make_shared<const scene::Instances>(shown.instances);
    there.m_cells.build(shown, workers);
    return there;
}

Obstacles Obstacles::bent(std::span<const std::uint32_t> meshes, std::vector<scene::MeshVertices> vertices,
                          platform::WorkerPool& workers) const {
    Obstacles there(*this);
    workers.run(meshes.size(), [&](std::size_t i, std::size_t) {
        scene::Mesh mesh;
        mesh.indices = m_scene.meshes[meshes[i]].indices;
        mesh.vertices = std::move(vertices[i].vertices);
        there.m_shapes[meshes[i]] = std::make_shared<const measure::Shape>(mesh);
    });
    return there;
}

double Obstacles::clearWay(const glm::dvec3& from, const glm::dvec3& to) const {
    Way way{.from = from, .along = to - from};
    const double length = glm::length(way.along);
    const std::size_t levels = m_cells.levels().size();
    const std::size_t tops = length > 0.0 && levels > 0 ? m_cells.levels().back().size() : 0;
    for (std::size_t node = 0; node < tops; ++node) {
        shortenBelow(levels - 1, node, way);
    }
    return way.share * length;
}

void Obstacles::shortenBelow(std::size_t level, std::size_t node, Way& way) const {
    constexpr std::size_t kFan = visibility::InstanceCells::kFan;
    if (!way.mayMeet(m_cells.levels()[level][node])) {
        return;
    }
    if (level == 0) {
        shortenInCell(node, way);
        return;
    }
    const std::size_t end = std::min((node + 1) * kFan, m_cells.levels()[level - 1].size());
    for (std::size_t child = node * kFan; child < end; ++child) {
        shortenBelow(level - 1, child, way);
    }
}

void Obstacles::shortenInCell(std::size_t cell, Way& way) const {
    const scene::Instances& instances = *m_instances;
    for (std::uint64_t held = m_cells.held(cell); held != 0; held &= held - 1) {
        const std::uint32_t i = m_cells.instancesOf(cell)[std::countr_zero(held)];
        const auto inverse = way.meets(instances.position(i), instances.radius[i])
                                 ? measure::invertBasis(instances.basis[i])
                                 : std::nullopt;
        if (inverse) {
            // The difference first: exact far from the origin, too.
            const measure::ObjectRay ray{inverse->worldToObject * (way.from - instances.position(i)),
                                         inverse->worldToObject * way.along};
            const measure::Sidedness sides = measure::sidednessOf(m_scene.materials[instances.material[i]]);
            way.share =
                std::min(way.share, m_shapes[instances.mesh[i]]->nearest(ray, sides, {0.0, way.share}));
        }
    }
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
