#include <cdr/scene/lod/triangle_clusters.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace cdr::scene {

namespace {

/// A cut that leaves one side fewer than one in this many triangles goes through the middle triangle instead.
/// That bounds the work for any mesh.
constexpr std::size_t kMinShare = 8;

class Clusterer {
  public:
    explicit Clusterer(const SourceMesh& source) : m_source(source) {}

    TriangleCluster all() const {
        std::vector<std::uint32_t> triangles(m_source.indices.size() / 3);
        std::iota(triangles.begin(), triangles.end(), 0u);
        return bounded(std::move(triangles));
    }

    /// Leaves one half and returns the other; an empty one when cutting would not help.
    TriangleCluster halve(TriangleCluster& cluster) const {
        Box centres;
        double largest = 0.0;
        for (const std::uint32_t triangle : cluster.triangles) {
            centres.add(centre(triangle));
            largest = std::max(largest, boxOf(triangle).diagonal());
        }
        if (!(centres.diagonal() > largest)) {
            return {};
        }
        std::vector<std::uint32_t> upper = takeUpper(cluster.triangles, centres.longestAxis(), centres);
        cluster = bounded(std::move(cluster.triangles));
        return bounded(std::move(upper));
    }

  private:
    Box boxOf(std::uint32_t triangle) const {
        Box box;
        for (std::size_t i = 0; i < 3; ++i) {
            box.add(m_source.positionOf(m_source.indices[std::size_t{3} * triangle + i]));
        }
        return box;
    }
    glm::dvec3 centre(std::uint32_t triangle) const {
        const Box box = boxOf(triangle);
        return 0.5 * box.low + 0.5 * box.high;
    }

    TriangleCluster bounded(std::vector<std::uint32_t> triangles) const {
        TriangleCluster cluster{.triangles = std::move(triangles)};
        for (const std::uint32_t triangle : cluster.triangles) {
            cluster.bounds.add(boxOf(triangle));
        }
        return cluster;
    }

    std::vector<std::uint32_t> takeUpper(std::vector<std::uint32_t>& triangles, int axis,
                                         const Box& centres) const {
        const double plane = 0.5 * centres.low[axis] + 0.5 * centres.high[axis];
        auto cut = std::stable_partition(triangles.begin(), triangles.end(),
                                         [&](std::uint32_t t) { return centre(t)[axis] < plane; });
        const auto below = static_cast<std::size_t>(cut - triangles.begin());
        if (std::min(below, triangles.size() - below) < triangles.size() / kMinShare) {
            cut = triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2);
            std::nth_element(triangles.begin(), cut, triangles.end(), [&](std::uint32_t a, std::uint32_t b) {
                return std::pair(centre(a)[axis], a) < std::pair(centre(b)[axis], b);
            });
            std::sort(triangles.begin(), cut);
            std::sort(cut, triangles.end());
        }
        std::vector<std::uint32_t> upper(cut, triangles.end());
        triangles.erase(cut, triangles.end());
        return upper;
    }

    const SourceMesh& m_source;
};

} // namespace

std::vector<TriangleCluster> clusterTriangles(const SourceMesh& source, double radius, std::size_t most) {
    const Clusterer clusterer(source);
    std::vector<TriangleCluster> clusters{clusterer.all()};
    // By width, and at equal widths the first; clusters that cannot be cut are not in it.
    std::priority_queue<std::pair<double, std::size_t>> open;
    const auto enter = [&](std::size_t i) {
        if (clusters[i].radius() > radius) {
            open.emplace(clusters[i].radius(), std::numeric_limits<std::size_t>::max() - i);
        }
    };
    enter(0);
    while (!open.empty() && clusters.size() < most) {
        const std::size_t i = std::numeric_limits<std::size_t>::max() - open.top().second;
        open.pop();
        TriangleCluster other = clusterer.halve(clusters[i]);
        if (!other.triangles.empty()) {
            clusters.push_back(std::move(other));
            enter(i);
            enter(clusters.size() - 1);
        }
    }
    return clusters;
}

} // namespace cdr::scene
