#include <cdr/base/error.h>
#include <cdr/scene/levels.h>
#include <cdr/scene/surface_distance.h>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <limits>
#include <span>

namespace cdr::scene {

namespace {

// Vertices are compared byte by byte, so none may lie between members.
static_assert(sizeof(Vertex) == 2 * sizeof(glm::vec3) + sizeof(glm::vec2) + sizeof(glm::u8vec4));

void requireUsable(const LevelOptions& options) {
    if (!(options.ratio > 0.0 && options.ratio < 1.0)) {
        throw base::InputError(
            fmt::format("levels: the ratio must lie between 0 and 1, not {}", options.ratio));
    }
    if (!(options.leastGain >= 0.0 && options.leastGain < 1.0)) {
        throw base::InputError(
            fmt::format("levels: the least gain must be at least 0 and below 1, not {}", options.leastGain));
    }
    if (options.most > kMaxLevels) {
        throw base::InputError(
            fmt::format("levels: at most {} beside the mesh, not {}", kMaxLevels, options.most));
    }
}

/// The indices with equal vertices taken as one, so that triangles of meshes without an index buffer touch.
std::vector<std::uint32_t> sharedIndices(const Mesh& mesh) {
    std::vector<std::uint32_t> shared(mesh.indices.size());
    meshopt_generateShadowIndexBuffer(shared.data(), mesh.indices.data(), mesh.indices.size(),
                                      mesh.vertices.data(), mesh.vertices.size(), sizeof(Vertex),
                                      sizeof(Vertex));
    return shared;
}

std::vector<std::uint32_t> simplified(const std::vector<std::uint32_t>& indices,
                                      std::span<const glm::vec3> positions, std::size_t targetTriangles) {
    std::vector<std::uint32_t> coarse(indices.size());
    // The target alone decides how far to go; what it costs is measured afterwards.
    constexpr float kAnyError = std::numeric_limits<float>::max();
    coarse.resize(meshopt_simplify(coarse.data(), indices.data(), indices.size(), &positions[0].x,
                                   positions.size(), sizeof(glm::vec3), 3 * targetTriangles, kAnyError,
                                   meshopt_SimplifyLockBorder, nullptr));
    return coarse;
}

} // namespace

std::vector<MeshLevel> makeLevels(const Mesh& mesh, const LevelOptions& options) {
    requireUsable(options);
    std::vector<MeshLevel> levels;
    const std::vector<std::uint32_t> full = sharedIndices(mesh);
    std::vector<glm::vec3> positions;
    for (const Vertex& vertex : mesh.vertices) {
        positions.push_back(vertex.position);
    }
    std::size_t triangles = full.size() / 3;
    while (levels.size() < options.most) {
        const auto target = static_cast<std::size_t>(static_cast<double>(triangles) * options.ratio);
        if (target < options.leastTriangles || target == 0) {
            break;
        }
        MeshLevel level{.indices = simplified(full, positions, target)};
        const std::size_t left = level.indices.size() / 3;
        const double gain = 1.0 - static_cast<double>(left) / static_cast<double>(triangles);
        if (left < options.leastTriangles || left == 0 || left == triangles || gain < options.leastGain) {
            break;
        }
        // Rounded up, and never below the level before, so that coarser always says more.
        const auto error = static_cast<float>(surfaceDeviation(positions, full, level.indices));
        level.error = std::nextafter(error, std::numeric_limits<float>::infinity());
        level.error = levels.empty() ? level.error : std::max(level.error, levels.back().error);
        triangles = left;
        levels.push_back(std::move(level));
    }
    return levels;
}

void makeLevels(Scene& scene, base::WorkerPool& workers, const LevelOptions& options) {
    workers.run(scene.meshes.size(), [&](std::size_t job, std::size_t) {
        Mesh& mesh = scene.meshes[job];
        if (mesh.levels.empty()) {
            mesh.levels = makeLevels(mesh, options);
        }
    });
}

} // namespace cdr::scene
