#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/upload.h>
#include <cdr/render/gpu_scene.h>
#include <cdr/shaders/shared.h>

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <tuple>

namespace cdr::render {

namespace {

/// A vertex as the device reads it: 28 bytes.
struct PackedVertex {
    glm::vec3 position;
    std::uint32_t normal; ///< octahedral, two snorm16
    glm::vec2 uv;
    glm::u8vec4 color;
};
static_assert(sizeof(PackedVertex) == 28);

/// shaders/octahedral.glsl says where this comes from.
glm::vec2 encodeOctahedral(const glm::vec3& n) {
    const float sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    if (!(sum > 0.0f)) {
        return glm::vec2(0.0f);
    }
    const glm::vec2 p(n.x / sum, n.y / sum);
    if (n.z >= 0.0f) {
        return p;
    }
    return {(1.0f - std::abs(p.y)) * (p.x >= 0.0f ? 1.0f : -1.0f),
            (1.0f - std::abs(p.x)) * (p.y >= 0.0f ? 1.0f : -1.0f)};
}

vk::UniqueSampler makeSampler(const gpu::Device& device, bool repeatU, bool repeatV) {
    const auto mode = [](bool repeat) {
        return repeat ? vk::SamplerAddressMode::eRepeat : vk::SamplerAddressMode::eClampToEdge;
    };
    return device.handle().createSamplerUnique({.magFilter = vk::Filter::eLinear,
                                                .minFilter = vk::Filter::eLinear,
                                                .addressModeU = mode(repeatU),
                                                .addressModeV = mode(repeatV)});
}

bool areFaceted(const std::vector<scene::Vertex>& vertices, const std::vector<std::uint32_t>& indices) {
    const auto looksLike = [&](std::uint32_t a, std::uint32_t b) {
        return vertices[a].normal == vertices[b].normal && vertices[a].color == vertices[b].color;
    };
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        if (!looksLike(indices[i], indices[i + 1]) || !looksLike(indices[i], indices[i + 2])) {
            return false;
        }
    }
    return true;
}

/// At every level, since they share pipelines.
bool isFaceted(const scene::Mesh& mesh) {
    return areFaceted(mesh.vertices, mesh.indices) &&
           std::all_of(mesh.levels.begin(), mesh.levels.end(), [&](const scene::MeshLevel& level) {
               return areFaceted(mesh.vertices, level.indices);
           });
}

std::uint32_t variantOf(const MeshRange& mesh, const scene::Material& material) {
    const bool isMasked = material.alphaMode == scene::AlphaMode::mask;
    const bool isTextured = material.baseColorTexture.has_value();
    if (mesh.isFaceted && !isTextured && !isMasked && !material.doubleSided) {
        return kFacetedVariant;
    }
    return (isTextured ? kTexturedVariant : 0) + (isMasked ? kMaskedVariant : 0);
}

std::uint64_t predictBytes(const scene::Scene& scene) {
    std::uint64_t bytes = 0;
    for (const scene::Mesh& mesh : scene.meshes) {
        bytes += mesh.vertices.size() * sizeof(PackedVertex) + mesh.indices.size() * sizeof(std::uint32_t);
        for (const scene::MeshLevel& level : mesh.levels) {
            bytes += level.indices.size() * sizeof(std::uint32_t);
        }
    }
    for (const scene::Texture& texture : scene.textures) {
        bytes += texture.pixels.pixels.size() * sizeof(image::Rgba8);
    }
    return bytes;
}

} // namespace

GpuScene::GpuScene(const gpu::Device& device, const scene::Scene& scene) {
    gpu::requireDeviceBytes(device, predictBytes(scene), "scene " + scene.name);
    uploadMeshes(device, scene);
    uploadTextures(device, scene);
    uploadMaterials(device, scene);
    sortKinds(scene);
}

void GpuScene::uploadMeshes(const gpu::Device& device, const scene::Scene& scene) {
    std::vector<PackedVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const scene::Mesh& mesh : scene.meshes) {
        m_meshes.push_back({.firstIndex = static_cast<std::uint32_t>(indices.size()),
                            .indexCount = static_cast<std::uint32_t>(mesh.indices.size()),
                            .vertexOffset = static_cast<std::int32_t>(vertices.size()),
                            .firstLevel = static_cast<std::uint32_t>(m_levels.size()),
                            .levelCount = static_cast<std::uint32_t>(mesh.levels.size()),
                            .boundingRadius = mesh.boundingRadius,
                            .isFaceted = isFaceted(mesh)});
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
        for (const scene::MeshLevel& level : mesh.levels) {
            m_levels.push_back({.firstIndex = static_cast<std::uint32_t>(indices.size()),
                                .indexCount = static_cast<std::uint32_t>(level.indices.size()),
                                .error = level.error});
            indices.insert(indices.end(), level.indices.begin(), level.indices.end());
        }
        for (const scene::Vertex& vertex : mesh.vertices) {
            vertices.push_back({vertex.position, glm::packSnorm2x16(encodeOctahedral(vertex.normal)),
                                vertex.uv, vertex.color});
        }
    }
    m_vertices = gpu::uploadBuffer(device, std::as_bytes(std::span(vertices)),
                                   vk::BufferUsageFlagBits::eVertexBuffer, "scene vertices");
    m_indices = gpu::uploadBuffer(device, std::as_bytes(std::span(indices)),
                                  vk::BufferUsageFlagBits::eIndexBuffer, "scene indices");
}

void GpuScene::uploadMaterials(const gpu::Device& device, const scene::Scene& scene) {
    constexpr auto kType = vk::DescriptorType::eCombinedImageSampler;
    m_textureLayout = gpu::makeSetLayout(device, {kType}, vk::ShaderStageFlagBits::eFragment, "texture set");
    m_pool = gpu::makeDescriptorPool(device, static_cast<std::uint32_t>(scene.materials.size()), 1, {kType});
    for (const scene::Material& material : scene.materials) {
        m_materials.push_back(wordsOf(material));
        m_isShiny = m_isShiny || (m_materials.back().cutoffAndShine & shaders::kShineMask) != 0;
        // Untextured materials read the white pixel, so that every pipeline has a valid set.
        const std::size_t texture =
            material.baseColorTexture.value_or(static_cast<std::uint32_t>(scene.textures.size()));
        const vk::DescriptorSet set = gpu::allocateSet(device, *m_pool, *m_textureLayout);
        gpu::writeImageBinding(device, set, 0, kType, m_textures[texture].view(), *m_samplers[texture]);
        m_textureSets.push_back(set);
    }
}

void GpuScene::uploadTextures(const gpu::Device& device, const scene::Scene& scene) {
    const auto upload = [&](const image::ImageRgba8& pixels, const std::string& name) {
        m_textures.push_back(gpu::uploadImage(device, {pixels.width, pixels.height},
                                              vk::Format::eR8G8B8A8Srgb,
                                              std::as_bytes(std::span(pixels.pixels)), name));
    };
    for (const scene::Texture& texture : scene.textures) {
        upload(texture.pixels, "texture " + texture.name);
        m_samplers.push_back(makeSampler(device, texture.repeatU, texture.repeatV));
    }
    upload(image::ImageRgba8(1, 1, {255, 255, 255, 255}), "white texture");
    m_samplers.push_back(makeSampler(device, true, true));
}

void GpuScene::sortKinds(const scene::Scene& scene) {
    const scene::Instances& instances = scene.instances;
    std::map<std::tuple<std::uint32_t, std::uint32_t, bool>, std::uint32_t> known;
    m_sources.reserve(instances.size());
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const bool mirrored = glm::determinant(instances.basis[i]) < 0.0f;
        const auto [entry, isNew] =
            known.try_emplace({instances.mesh[i], instances.material[i], mirrored}, m_kinds.size());
        if (isNew) {
            const scene::Material& material = scene.materials[instances.material[i]];
            m_kinds.push_back({.mesh = m_meshes[instances.mesh[i]],
                               .variant = variantOf(m_meshes[instances.mesh[i]], material),
                               .doubleSided = material.doubleSided,
                               .mirrored = mirrored,
                               .textureSet = m_textureSets[instances.material[i]]});
        }
        m_sources.push_back({.position = instances.position(i),
                             .basis = instances.basis[i],
                             .id = instances.object[i] + 1 +
                                   (scene.materials[instances.material[i]].unlit ? shaders::kIdUnlit : 0u),
                             .material = instances.material[i],
                             .kind = entry->second});
    }
}

vk::VertexInputBindingDescription GpuScene::vertexBinding() {
    return {.binding = 0, .stride = sizeof(PackedVertex), .inputRate = vk::VertexInputRate::eVertex};
}

std::vector<vk::VertexInputAttributeDescription> GpuScene::vertexAttributes() {
    return {{0, 0, vk::Format::eR32G32B32Sfloat, offsetof(PackedVertex, position)},
            {1, 0, vk::Format::eR16G16Snorm, offsetof(PackedVertex, normal)},
            {2, 0, vk::Format::eR32G32Sfloat, offsetof(PackedVertex, uv)},
            {3, 0, vk::Format::eR8G8B8A8Unorm, offsetof(PackedVertex, color)}};
}

} // namespace cdr::render
