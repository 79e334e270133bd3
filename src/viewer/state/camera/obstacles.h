#pragma once

#include <cdr/measure/truth/shape.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/scene/camera.h>
#include <cdr/scene/scene.h>
#include <cdr/visibility/instance_cells.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cdr::viewer {

/// The surfaces that a flight stops at: the scene's own, whatever pictures have shown. Blended ones are flown through.
class Obstacles {
  public:
    /// @param scene must outlive the obstacles, its meshes unchanged.
    Obstacles(const scene::Scene& scene, platform::WorkerPool& workers);

    /// The same meshes where `shown` has them now, which may move on at once.
    /// @param deformed meshes that have other vertices than at first
    Obstacles moved(const scene::Scene& shown, std::span<const std::uint32_t> deformed,
                    platform::WorkerPool& workers) const;
    /// The same with other vertices of some meshes, which the scene lacks where the device makes them.
    Obstacles bent(std::span<const std::uint32_t> meshes, std::vector<scene::MeshVertices> vertices,
                   platform::WorkerPool& workers) const;

    /// Of the scene, where they are now. They live no longer than the scene and the obstacles.
    const scene::Instances& instances() const { return *m_instances; }

    /// How far a straight way leads before a surface, at most its own length. From the back of a single-sided one it
    /// leads out.
    double clearWay(const glm::dvec3& from, const glm::dvec3& to) const;

  private:
    struct Way;
    void shortenBelow(std::size_t level, std::size_t node, Way& way) const;
    void shortenInCell(std::size_t cell, Way& way) const;

    const scene::Scene& m_scene;
    std::shared_ptr<const scene::Instances> m_instances; ///< the scene's, or a copy of what moved
    visibility::InstanceCells m_cells;
    std::vector<std::shared_ptr<const measure::Shape>> m_shapes; ///< per mesh
};

/// The camera on its way from `before`, stopped two near planes short of the first surface, so that none is cut open.
scene::Camera stopped(const scene::Camera& before, scene::Camera after, const Obstacles& obstacles);

} // namespace cdr::viewer
