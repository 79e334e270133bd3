#include <cdr/scene/lod/shared_mesh.h>

#include <meshoptimizer.h>

#include <limits>

namespace cdr::scene {

// Vertices are compared byte by byte, so none may lie between members.
static_assert(sizeof(Vertex) == 2 * sizeof(glm::vec3) + sizeof(glm::vec2) + sizeof(glm::u8vec4));

SharedMesh sharedBy(const Mesh& mesh) {
    constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max();
    SharedMesh shared;
    shared.indices.resize(mesh.indices.size());
    meshopt_generateShadowIndexBuffer(shared.indices.data(), mesh.indices.data(), mesh.indices.size(),
                                      mesh.vertices.data(), mesh.vertices.size(), sizeof(Vertex),
                                      sizeof(Vertex));
    std::vector<std::uint32_t> places(mesh.vertices.size(), kUnseen);
    for (std::uint32_t& index : shared.indices) {
        std::uint32_t& place = places[index];
        if (place == kUnseen) {
            place = static_cast<std::uint32_t>(shared.positions.size());
            shared.positions.push_back(mesh.vertices[index].position);
            shared.vertices.push_back(index);
        }
        index = place;
    }
    return shared;
}

std::vector<std::uint32_t> simplified(std::span<const std::uint32_t> indices,
                                      std::span<const glm::vec3> positions, std::size_t triangles) {
    constexpr float kAnyError = std::numeric_limits<float>::max();
    std::vector<std::uint32_t> coarse(indices.size());
    coarse.resize(meshopt_simplify(coarse.data(), indices.data(), indices.size(), &positions[0].x,
                                   positions.size(), sizeof(glm::vec3), 3 * triangles, kAnyError,
                                   meshopt_SimplifyLockBorder, nullptr));
    return coarse;
}

} // namespace cdr::scene
