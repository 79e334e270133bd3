#include <cdr/render/materials/packed_vertex.h>
#include <cdr/render/octahedral.h>
#include <cdr/shaders/deform_shared.h>

#include <glm/gtc/packing.hpp>

#include <cstddef>
#include <cstdint>

namespace cdr::render {

static_assert(sizeof(PackedVertex) == sizeof(std::uint32_t) * shaders::kVertexWords);
static_assert(sizeof(PackedDetail) == sizeof(std::uint32_t) * shaders::kDetailWords);

PackedVertex packed(const scene::Vertex& vertex) {
    return {vertex.position, glm::packSnorm2x16(encodeOctahedral(vertex.normal)), vertex.uv, vertex.color};
}

PackedDetail packed(const scene::VertexDetail& detail) {
    const glm::vec2 folded = encodeOctahedral(glm::vec3(detail.tangent));
    return {glm::packSnorm4x16(glm::vec4(folded, detail.tangent.w, 0.0f)), detail.uv};
}

vk::VertexInputBindingDescription vertexBinding() {
    return {.binding = 0, .stride = sizeof(PackedVertex), .inputRate = vk::VertexInputRate::eVertex};
}

std::vector<vk::VertexInputAttributeDescription> vertexAttributes() {
    return {{0, 0, vk::Format::eR32G32B32Sfloat, offsetof(PackedVertex, position)},
            {1, 0, vk::Format::eR16G16Snorm, offsetof(PackedVertex, normal)},
            {2, 0, vk::Format::eR32G32Sfloat, offsetof(PackedVertex, uv)},
            {3, 0, vk::Format::eR8G8B8A8Unorm, offsetof(PackedVertex, color)}};
}

vk::VertexInputBindingDescription detailBinding() {
    return {
        .binding = kDetailBinding, .stride = sizeof(PackedDetail), .inputRate = vk::VertexInputRate::eVertex};
}

std::vector<vk::VertexInputAttributeDescription> detailAttributes() {
    return {{9, kDetailBinding, vk::Format::eR16G16B16A16Snorm, offsetof(PackedDetail, tangent)},
            {10, kDetailBinding, vk::Format::eR32G32Sfloat, offsetof(PackedDetail, uv)}};
}

} // namespace cdr::render
