#pragma once

#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::visibility {

/// An axis-aligned box around triangles of a mesh that follow one another, in object space.
struct MeshChunk {
    glm::vec3 middle{0.0f};
    glm::vec3 half{0.0f}; ///< of its sides, 0 or more

    bool operator==(const MeshChunk&) const = default;
};

/// Triangles of a chunk; the last one of a mesh may have fewer.
inline constexpr std::size_t kChunkTriangles = 512;
/// Meshes of fewer triangles have no chunks: to look at each would take longer than to draw them.
inline constexpr std::size_t kLeastChunkedTriangles = 8 * kChunkTriangles;

/// Boxes around all triangles of a large mesh, in the order of its indices. None for a small mesh.
/// @param indices three per triangle
std::vector<MeshChunk> chunksOf(std::span<const scene::Vertex> vertices,
                                std::span<const std::uint32_t> indices);

/// Indices that follow one another in a mesh.
struct IndexRun {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// Calls `draw` with each run of neighbouring chunks for which `isSeen` is true, in order.
/// @param indices of the mesh
template <typename IsSeen, typename Draw>
void forEachSeenRun(std::span<const MeshChunk> chunks, std::uint32_t indices, const IsSeen& isSeen,
                    const Draw& draw) {
    constexpr auto kIndices = static_cast<std::uint32_t>(3 * kChunkTriangles);
    IndexRun run;
    const auto end = [&] {
        if (run.count > 0) {
            draw(run);
        }
    };
    std::uint32_t first = 0;
    for (const MeshChunk& chunk : chunks) {
        const std::uint32_t count = std::min(kIndices, indices - first);
        if (isSeen(chunk)) {
            if (run.count == 0) {
                run.first = first;
            }
            run.count += count;
        } else {
            end();
            run = {};
        }
        first += count;
    }
    end();
}

} // namespace cdr::visibility
