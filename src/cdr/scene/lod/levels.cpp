#include <cdr/base/format_error.h>
#include <cdr/scene/lod/levels.h>
#include <cdr/scene/lod/shared_mesh.h>
#include <cdr/scene/lod/surface_distance.h>

#include <algorithm>
#include <limits>

namespace cdr::scene {

namespace {

void requireUsableLevels(const LevelOptions& options) {
    if (!(options.ratio > 0.0 && options.ratio < 1.0)) {
        throw base::inputError("levels: the ratio must lie between 0 and 1, not {}", options.ratio);
    }
    if (!(options.leastGain >= 0.0 && options.leastGain < 1.0)) {
        throw base::inputError("levels: the least gain must be at least 0 and below 1, not {}",
                               options.leastGain);
    }
    if (options.most > kMaxLevels) {
        throw base::inputError("levels: at most {} beside the mesh, not {}", kMaxLevels, options.most);
    }
}

} // namespace

std::vector<MeshLevel> makeLevels(const Mesh& mesh, const LevelOptions& options) {
    requireUsableLevels(options);
    std::vector<MeshLevel> levels;
    if (mesh.indices.empty()) {
        return levels;
    }
    const SharedMesh full = sharedBy(mesh);
    std::size_t triangles = full.indices.size() / 3;
    while (levels.size() < options.most) {
        const auto target = static_cast<std::size_t>(static_cast<double>(triangles) * options.ratio);
        if (target < options.leastTriangles || target == 0) {
            break;
        }
        MeshLevel level{.indices = simplified(full.indices, full.positions, target)};
        const std::size_t left = level.indices.size() / 3;
        const double gain = 1.0 - static_cast<double>(left) / static_cast<double>(triangles);
        if (left < options.leastTriangles || left == 0 || left == triangles || gain < options.leastGain) {
            break;
        }
        // Rounded up, and never below the level before, so that coarser always says more.
        const auto error = static_cast<float>(surfaceDeviation(full.positions, full.indices, level.indices));
        level.error = std::nextafter(error, std::numeric_limits<float>::infinity());
        level.error = levels.empty() ? level.error : std::max(level.error, levels.back().error);
        for (std::uint32_t& index : level.indices) {
            index = full.vertices[index];
        }
        triangles = left;
        levels.push_back(std::move(level));
    }
    return levels;
}

void makeLevels(Scene& scene, platform::WorkerPool& workers, const LevelOptions& options) {
    workers.run(scene.meshes.size(), [&](std::size_t job, std::size_t) {
        Mesh& mesh = scene.meshes[job];
        if (mesh.levels.empty() && mesh.clusters.clusters.empty()) {
            mesh.levels = makeLevels(mesh, options);
        }
    });
}

} // namespace cdr::scene
