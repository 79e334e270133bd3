#include <cdr/visibility/cluster_cut.h>
#include <cdr/visibility/vertex_rounding.h>

#include <algorithm>
#include <cmath>

namespace cdr::visibility {

ClusterView::ClusterView(const scene::Scene& scene, std::uint32_t instance, const SphereTest& test)
    : m_test(test) {
    const scene::Instances& instances = scene.instances;
    const glm::dmat3 basis(instances.basis[instance]);
    const glm::dmat3 view = glm::transpose(glm::dmat3(test.right, test.up, -test.back));
    const glm::dvec3 fromCamera = instances.position(instance) - test.position;
    m_centreView = view * fromCamera;
    m_toView = view * basis;
    const auto radius = static_cast<double>(instances.radius[instance]);
    m_rounding = vertexRounding(fromCamera, radius);
    m_scale = radius / static_cast<double>(scene.meshes[instances.mesh[instance]].boundingRadius);
    const bool isFlat = glm::determinant(basis) == 0.0;
    m_hasBacks = !isFlat && !scene.materials[instances.material[instance]].doubleSided;
    if (m_hasBacks) {
        m_cameraInObject = -(glm::inverse(basis) * fromCamera);
    }
}

ClusterView::Seen ClusterView::see(const scene::ClusterSphere& sphere) const {
    const glm::dvec3 centre = m_centreView + m_toView * glm::dvec3(sphere.centre);
    const double radius = static_cast<double>(sphere.radius) * m_scale + m_rounding;
    const double sideX = centre.z * m_test.sinX - std::abs(centre.x) * m_test.cosX;
    const double sideY = centre.z * m_test.sinY - std::abs(centre.y) * m_test.cosY;
    const double depth = std::min(centre.z - m_test.nearView, m_test.farView - centre.z);
    return {.distanceView = centre.z, .radius = radius, .margin = std::min({sideX, sideY, depth}) + radius};
}

bool ClusterView::facesAway(const scene::MeshCluster& cluster) const {
    const glm::dvec3 way = glm::dvec3(cluster.bounds.centre) - m_cameraInObject;
    return m_hasBacks && glm::dot(way, glm::dvec3(cluster.coneAxis)) >=
                             static_cast<double>(cluster.coneCutoff) * glm::length(way) +
                                 static_cast<double>(cluster.bounds.radius);
}

bool ClusterView::isCoarseEnough(const scene::ClusterGroup& group, double slope) const {
    const double ahead = m_centreView.z + (m_toView * glm::dvec3(group.bounds.centre)).z -
                         static_cast<double>(group.bounds.radius) * m_scale;
    return static_cast<double>(group.error) * m_scale <= slope * std::max(ahead, m_test.nearView);
}

void ClusterCut::start(const scene::ClusterTree& tree) {
    for (const std::uint32_t group : m_known) {
        m_groups[group] = Group::unseen;
    }
    m_known.clear();
    m_groups.resize(std::max(m_groups.size(), tree.groups.size()), Group::unseen);
    m_chosen.clear();
}

void ClusterCut::consider(const scene::ClusterTree& tree, const ClusterView& view, double slope,
                          std::uint32_t cluster) {
    const scene::MeshCluster& considered = tree.clusters[cluster];
    if (considered.madeBy != scene::kNoGroup) {
        Group& group = m_groups[considered.madeBy];
        if (group == Group::unseen) {
            const bool isCoarse = view.isCoarseEnough(tree.groups[considered.madeBy], slope);
            group = isCoarse ? Group::coarse : Group::fine;
            m_known.push_back(considered.madeBy);
            if (!isCoarse) {
                m_open.push_back(considered.madeBy);
            }
        }
        if (group == Group::fine) {
            return; // the finer clusters that it takes the place of are drawn
        }
    }
    if (view.see(considered.bounds).margin >= 0.0 && !view.facesAway(considered)) {
        m_chosen.push_back(cluster);
    }
}

std::span<const std::uint32_t> ClusterCut::of(const scene::ClusterTree& tree, const ClusterView& view,
                                              double slope) {
    start(tree);
    // The coarsest clusters are the last ones, those before them are of groups.
    const std::uint32_t grouped =
        tree.groups.empty() ? 0 : tree.groups.back().firstCluster + tree.groups.back().clusterCount;
    for (auto cluster = grouped; cluster < tree.clusters.size(); ++cluster) {
        consider(tree, view, slope, cluster);
    }
    while (!m_open.empty()) {
        const scene::ClusterGroup& group = tree.groups[m_open.back()];
        m_open.pop_back();
        for (std::uint32_t i = 0; i < group.clusterCount; ++i) {
            consider(tree, view, slope, group.firstCluster + i);
        }
    }
    std::sort(m_chosen.begin(), m_chosen.end());
    return m_chosen;
}

} // namespace cdr::visibility
