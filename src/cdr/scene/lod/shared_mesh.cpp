#include <cdr/scene/lod/shared_mesh.h>

#include <meshoptimizer.h>

#include <array>
#include <limits>

namespace cdr::scene {

// Vertices and details are compared byte by byte, so none may lie between members.
static_assert(sizeof(Vertex) == 2 * sizeof(glm::vec3) + sizeof(glm::vec2) + sizeof(glm::u8vec4));
static_assert(sizeof(VertexDetail) == sizeof(glm::vec4) + sizeof(glm::vec2));

SharedMesh sharedBy(const Mesh& mesh) {
    constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max();
    SharedMesh shared;
    shared.indices.resize(mesh.indices.size());
    const std::array<meshopt_Stream, 2> streams{
        {{mesh.vertices.data(), sizeof(Vertex), sizeof(Vertex)},
         {mesh.details.data(), sizeof(VertexDetail), sizeof(VertexDetail)}}};
    meshopt_generateShadowIndexBufferMulti(shared.indices.data(), mesh.indices.data(), mesh.indices.size(),
                                           mesh.vertices.size(), streams.data(),
                                           mesh.details.empty() ? 1 : streams.size());
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
