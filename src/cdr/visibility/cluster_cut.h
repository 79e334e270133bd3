#pragma once

#include <cdr/scene/cluster_tree.h>
#include <cdr/scene/scene.h>
#include <cdr/visibility/sphere_test.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cdr::visibility {

/// An instance of a mesh with clusters, as a camera sees it.
class ClusterView {
  public:
    ClusterView(const scene::Scene& scene, std::uint32_t instance, const SphereTest& test);

    /// A sphere of the mesh's object space.
    struct Seen {
        double distanceView = 0.0; ///< of the centre
        double radius = 0.0;       ///< in world space, vertices rounded
        double margin = 0.0;       ///< below 0: outside the frustum
    };
    Seen see(const scene::ClusterSphere& sphere) const;
    /// Whether all triangles of a cluster show their backs, and are not drawn.
    bool facesAway(const scene::MeshCluster& cluster) const;
    /// Whether a group's coarser form errs by no more than `slope` times its view distance.
    bool isCoarseEnough(const scene::ClusterGroup& group, double slope) const;

  private:
    const SphereTest& m_test;
    glm::dvec3 m_centreView; ///< of the instance: right, up, ahead
    glm::dmat3 m_toView;     ///< of object space, without the translation
    glm::dvec3 m_cameraInObject{0.0};
    double m_scale;
    double m_rounding; ///< of vertices on the device
    bool m_hasBacks = false;
};

/// Finds the clusters that stand for an instance. It keeps its memory, so that a warm one allocates nothing.
class ClusterCut {
  public:
    /// The clusters to draw, ascending, none of which is outside the frustum or faces away.
    /// @lifetime Until the next call.
    std::span<const std::uint32_t> of(const scene::ClusterTree& tree, const ClusterView& view, double slope);

  private:
    void start(const scene::ClusterTree& tree);
    void consider(const scene::ClusterTree& tree, const ClusterView& view, double slope,
                  std::uint32_t cluster);

    enum class Group : std::uint8_t { unseen, coarse, fine };
    std::vector<Group> m_groups;        ///< by group
    std::vector<std::uint32_t> m_known; ///< groups that are not unseen
    std::vector<std::uint32_t> m_open;  ///< groups to look into
    std::vector<std::uint32_t> m_chosen;
};

} // namespace cdr::visibility
