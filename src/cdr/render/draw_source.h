#pragma once

#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/geometry/layers.h>
#include <cdr/render/materials/material_words.h>
#include <cdr/render/materials/packed_vertex.h>
#include <cdr/shaders/shared.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::render {

/// Where a mesh lies in the shared vertex and index buffers.
struct MeshRange {
    std::uint32_t firstIndex = 0; ///< of the mesh itself, level of detail 0
    std::uint32_t indexCount = 0;
    std::int32_t vertexOffset = 0; ///< the same for all levels
    std::uint32_t firstLevel = 0;  ///< its coarser levels, into UploadedScene::levels()
    std::uint32_t levelCount = 0;
    std::uint32_t firstClusterIndex = 0; ///< where its scene::ClusterTree::indices begin
    /// Object space. For levels, so it is not followed where a mesh deforms, which has none.
    float boundingRadius = 0.0f;
    bool isFaceted = false; ///< the vertices of every triangle share their colour and its own normal
    /// render::isClosed(). Not while the device deforms it, since vertices at one place may part.
    bool isClosed = false;
    std::uint32_t firstChunk = 0; ///< visibility::chunksOf() the mesh itself, for UploadedScene::chunksOf()
    std::uint32_t chunkCount = 0; ///< 0 for a small mesh, and once the device deforms it

    bool operator==(const MeshRange&) const = default;
};

/// A coarser level of a mesh in the shared index buffer.
struct LevelRange {
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    float error = 0.0f; ///< scene::MeshLevel::error
};

/// Which of a technique's pipelines a mesh and its material need: a sum of these.
inline constexpr std::uint32_t kTexturedVariant = 1;
inline constexpr std::uint32_t kMaskedVariant = 2;
/// Every triangle is of one colour and normal and seen from one side, so its surface is encoded per vertex.
/// Never textured or masked.
inline constexpr std::uint32_t kFacetedVariant = 4;
/// It has a layer offset. Never faceted.
inline constexpr std::uint32_t kLayeredVariant = 8;
/// Every triangle is of one colour and normal, as of kFacetedVariant, but its material needs more. For Snapping::inPlane.
inline constexpr std::uint32_t kPlanesVariant = 16;
/// Above those, detailPartsOf() the material; never of kFacetedVariant.
inline constexpr std::uint32_t kDetailStep = 32;
inline constexpr std::size_t kPipelineVariants = std::size_t{kDetailStep} * shaders::kDetailMasks;

/// Of a material on a mesh.
/// @param detailParts of the material: SceneTextures::detailParts(), or detailPartsOf() it.
std::uint32_t variantOf(bool isFaceted, const scene::Material& material, std::uint32_t detailParts);
/// Of materials on meshes with facets and without, whatever their textures are. Each once.
std::vector<std::uint32_t> variantsOf(std::span<const scene::Material> materials);

/// What draws of the same mesh, material and handedness share. Consecutive draws of one kind bind nothing in
/// between and may become one instanced draw.
struct DrawKind {
    std::uint32_t meshIndex = 0; ///< into scene::Scene::meshes
    MeshRange mesh;
    std::uint32_t variant = 0; ///< below kPipelineVariants
    bool doubleSided = false;
    bool mirrored = false;
    LayerPlace layer;
    vk::DescriptorSet textureSet; ///< set 0
    vk::DescriptorSet detailSet;  ///< null unless the variant reads it

    bool operator==(const DrawKind&) const = default;
};

/// Whether an instance is turned inside out. In float64, since the volume of a small or large one is no float32.
inline bool isMirror(const glm::mat3& basis) {
    return glm::determinant(glm::dmat3(basis)) < 0.0;
}

/// One instance as recording reads it, all of it in two cache lines. The scene's structure of arrays, made
/// for culling, would take eight.
struct DrawSource {
    glm::dvec3 position; ///< world space
    glm::mat3 basis;
    std::uint32_t id = 0; ///< shaders::DrawRecord::id
    std::uint32_t material = 0;
    std::uint32_t kind = 0; ///< into UploadedScene::kinds()
};

} // namespace cdr::render
