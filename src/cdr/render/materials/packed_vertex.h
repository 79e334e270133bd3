#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/scene/mesh.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace cdr::render {

/// A vertex as the device reads it: 28 bytes.
struct PackedVertex {
    glm::vec3 position;
    std::uint32_t normal; ///< octahedral, two snorm16
    glm::vec2 uv;
    glm::u8vec4 color;
};
static_assert(sizeof(PackedVertex) == 28);

/// scene::VertexDetail as the device reads it: 16 bytes.
struct PackedDetail {
    std::uint64_t tangent; ///< octahedral, and scene::VertexDetail::tangent's w: three snorm16
    glm::vec2 uv;
};
static_assert(sizeof(PackedDetail) == 16);

PackedVertex packed(const scene::Vertex& vertex);
PackedDetail packed(const scene::VertexDetail& detail);

/// Binding 0, locations 0 to 3.
vk::VertexInputBindingDescription vertexBinding();
std::vector<vk::VertexInputAttributeDescription> vertexAttributes();

/// Binding kDetailBinding, locations 9 and 10.
inline constexpr std::uint32_t kDetailBinding = 2;
vk::VertexInputBindingDescription detailBinding();
std::vector<vk::VertexInputAttributeDescription> detailAttributes();

} // namespace cdr::render
