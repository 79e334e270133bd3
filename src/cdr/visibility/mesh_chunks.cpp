#include <cdr/visibility/mesh_chunks.h>

#include <cmath>
#include <limits>

namespace cdr::visibility {

namespace {

/// What float32 rounds off a box's middle and half sides, as a share of the largest coordinate.
constexpr float kBoxRounding = 0x1p-22f;

MeshChunk boxAround(std::span<const scene::Vertex> vertices, std::span<const std::uint32_t> indices) {
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(std::numeric_limits<float>::lowest());
    for (const std::uint32_t index : indices) {
        low = glm::min(low, vertices[index].position);
        high = glm::max(high, vertices[index].position);
    }
    // Halved first, so that the largest floats do not overflow.
    const glm::vec3 half = 0.5f * high - 0.5f * low;
    return {.middle = 0.5f * low + 0.5f * high,
            .half = half + kBoxRounding * glm::max(glm::abs(low), glm::abs(high))};
}

} // namespace

std::vector<MeshChunk> chunksOf(std::span<const scene::Vertex> vertices,
                                std::span<const std::uint32_t> indices) {
    constexpr std::size_t kIndices = 3 * kChunkTriangles;
    std::vector<MeshChunk> chunks;
    if (indices.size() < 3 * kLeastChunkedTriangles) {
        return chunks;
    }
    chunks.reserve((indices.size() + kIndices - 1) / kIndices);
    for (std::size_t first = 0; first < indices.size(); first += kIndices) {
        chunks.push_back(
            boxAround(vertices, indices.subspan(first, std::min(kIndices, indices.size() - first))));
    }
    return chunks;
}

} // namespace cdr::visibility
