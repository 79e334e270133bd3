#include <cdr/scene/lod/cluster_errors.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cdr::scene {

namespace {

constexpr std::size_t kJobPoints = 4096;

/// What was found at a vertex of the mesh, or over a cluster.
struct FoundError {
    std::uint32_t group = kNoGroup;
    double squared = 0.0;
};

/// From each vertex of the mesh to the surface.
std::vector<FoundError> toSurface(const SharedMesh& mesh, std::span<const LooseCluster> surface,
                                  platform::WorkerPool& workers) {
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> groups; // by triangle
    for (const LooseCluster& cluster : surface) {
        indices.insert(indices.end(), cluster.indices.begin(), cluster.indices.end());
        groups.resize(indices.size() / 3, cluster.madeBy);
    }
    const SurfaceDistance distance(mesh.positions, indices);
    std::vector<FoundError> found(mesh.positions.size());
    const std::size_t jobs = (found.size() + kJobPoints - 1) / kJobPoints;
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        const platform::IndexRange range = platform::evenRange(found.size(), job, jobs);
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const SurfaceDistance::Nearest nearest = distance.nearestTo(glm::dvec3(mesh.positions[i]));
            found[i] = {.group = groups[nearest.triangle], .squared = nearest.squared};
        }
    });
    return found;
}

/// From each cluster of the surface to the mesh.
std::vector<FoundError> fromSurface(const SharedMesh& mesh, const SurfaceDistance& toMesh,
                                    std::span<const LooseCluster> surface, platform::IndexRange groups,
                                    platform::WorkerPool& workers) {
    std::size_t indices = 0;
    for (const LooseCluster& cluster : surface) {
        indices += cluster.indices.size();
    }
    const double perTriangle = static_cast<double>(mesh.indices.size()) / static_cast<double>(indices);
    std::vector<FoundError> found(surface.size());
    workers.run(surface.size(), [&](std::size_t job, std::size_t) {
        const LooseCluster& cluster = surface[job];
        if (cluster.madeBy < groups.begin || cluster.madeBy >= groups.end) {
            return;
        }
        found[job].group = cluster.madeBy;
        for (std::size_t i = 0; i < cluster.indices.size(); i += 3) {
            std::array<glm::dvec3, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) {
                corners[k] = glm::dvec3(mesh.positions[cluster.indices[i + k]]);
            }
            found[job].squared = toMesh.largestSquaredTo(corners, perTriangle, found[job].squared);
        }
    });
    return found;
}

} // namespace

std::vector<double> measureErrors(const SharedMesh& mesh, const SurfaceDistance& toMesh,
                                  std::span<const LooseCluster> surface, platform::IndexRange groups,
                                  platform::WorkerPool& workers) {
    std::vector<double> errors(groups.end);
    for (const auto& found :
         {toSurface(mesh, surface, workers), fromSurface(mesh, toMesh, surface, groups, workers)}) {
        for (const FoundError& at : found) {
            if (at.group >= groups.begin && at.group < groups.end) {
                errors[at.group] = std::max(errors[at.group], std::sqrt(at.squared));
            }
        }
    }
    return errors;
}

} // namespace cdr::scene
