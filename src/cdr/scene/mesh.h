#pragma once

/// @file
/// @errors None but what a function that is handed in throws.

#include <cdr/base/export.h>
#include <cdr/image/image.h>
#include <cdr/image/levels.h>
#include <cdr/scene/cluster_tree.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cdr::scene {

static_assert(
    sizeof(glm::vec3) == 3 * sizeof(float),
    "cdr's libraries were built without GLM's aligned types: leave out GLM_FORCE_DEFAULT_ALIGNED_GENTYPES");

/// A corner of a mesh.
struct Vertex {
    glm::vec3 position{0.0f};           ///< object space, relative to the mesh's bounding centre
    glm::vec3 normal{0.0f, 0.0f, 1.0f}; ///< object space, unit length
    glm::vec2 uv{0.0f};                 ///< of the texture, (0, 0) its first texel's corner
    glm::u8vec4 color{255};             ///< linear, multiplies the material's base colour
};

/// What textures need of a corner, except the base colour's.
struct VertexDetail {
    /// Object space, unit length: where u grows; w is 1 or -1, and cross(normal, tangent) * w is the way up of a normal
    /// texture.
    glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f};
    glm::vec2 uv{0.0f}; ///< a second place in textures, as Vertex::uv
};

/// The corners of a mesh at a moment.
struct MeshVertices {
    std::vector<Vertex> vertices;      ///< as Mesh::vertices
    std::vector<VertexDetail> details; ///< as Mesh::details
};

/// A coarser form of a mesh, over the mesh's own vertices.
struct MeshLevel {
    std::vector<std::uint32_t> indices; ///< three per triangle, each below the mesh's vertices.size()
    /// Object space: the Hausdorff distance between this surface and the mesh's own.
    float error = 0.0f;
};

/// An indexed triangle list. Front faces are counter-clockwise in object space. Under an instance that
/// mirrors they stay the front faces (glTF 2.0, section 3.7.4), though they are clockwise in world space.
///
/// Vertices are stored relative to the centre of their bounding sphere. That keeps float32 positions small,
/// and their rounding limits the smallest separation that can be resolved far away.
struct Mesh {
    std::string name;             ///< for messages and captures
    std::vector<Vertex> vertices; ///< shared by all levels
    std::vector<VertexDetail>
        details; ///< one per vertex; or empty, which a material with detail takes for defaults
    std::vector<std::uint32_t> indices; ///< three per triangle, each below vertices.size()
    float boundingRadius = 0.0f;        ///< object space, about the origin
    /// Levels of detail, each coarser than the one before. The mesh itself is level 0, levels[k] is level k +
    /// 1. At most kMaxLevels; empty unless makeLevels() was called (lod/levels.h).
    std::vector<MeshLevel> levels;
    /// Half the sides, if the mesh is exactly an axis-aligned box about its origin. Ray casts then need no
    /// triangles.
    std::optional<glm::vec3> boxHalfSides;
    /// For a large mesh, levels of detail that differ from place to place; else empty.
    ClusterTree clusters{};
};

/// Most levels beside the mesh itself; a level's number must fit a byte.
inline constexpr std::size_t kMaxLevels = 32;

/// What the channels of a texture are.
enum class TextureContent : std::uint8_t {
    color, ///< sRGB-encoded, alpha linear
    data,  ///< linear
};

/// Which of a texture's smaller levels are read where its texels are smaller than pixels. None of them, so that they
/// alias; the one whose texels come closest to pixels; or a blend of the two around that.
enum class TextureLevels : std::uint8_t { none, nearest, blended };

/// What a texture shows beyond its edges.
enum class WrapMode : std::uint8_t { clampToEdge, repeat, mirroredRepeat };

/// Whether a texture is read as its nearest texel, or as a blend of the four around a place.
enum class Filter : std::uint8_t { nearest, linear };

/// An image that a material reads. What draws it makes its smaller levels, each half the size of the one before.
struct Texture {
    std::string name{};                             ///< for messages and captures
    image::ImageRgba8 pixels{};                     ///< of `content`
    WrapMode wrapU = WrapMode::repeat;              ///< beyond the edges where u is 0 and 1
    WrapMode wrapV = WrapMode::repeat;              ///< beyond the edges where v is 0 and 1
    Filter magFilter = Filter::linear;              ///< where texels are larger than pixels
    Filter minFilter = Filter::linear;              ///< where texels, of a level, are smaller than pixels
    TextureLevels levels = TextureLevels::blended;  ///< read where texels are smaller than pixels
    TextureContent content = TextureContent::color; ///< what its channels are
    /// Colours of smaller levels count by their alpha: of a base colour's texture whose material blends or is masked.
    bool alphaWeighs = false;
    /// In (0, 1]: the alpha below which masked materials show nothing of it. Smaller levels keep the share that is shown.
    std::optional<float> cutoff{};
};

/// How a texture's smaller levels are made.
inline image::LevelRules levelRulesOf(const Texture& texture) {
    return {.encoding =
                texture.content == TextureContent::color ? image::Encoding::srgb : image::Encoding::linear,
            .alphaWeighs = texture.alphaWeighs,
            .cutoff = texture.cutoff};
}

/// What alpha does: nothing, cut away what is below the cutoff, or blend.
enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// The metallic-roughness material of glTF 2.0; both in [0, 1].
struct MetallicRoughness {
    float metallic = 1.0f;  ///< 0 is a dielectric, 1 a metal, which reflects in its base colour
    float roughness = 1.0f; ///< perceptual: its square is the alpha of the microfacet distribution

    bool operator==(const MetallicRoughness&) const = default;
};

/// A texture, and at which place of a vertex it is read.
struct TextureUse {
    std::uint32_t texture = 0; ///< index into Scene::textures
    bool second = false;       ///< at VertexDetail::uv; else at Vertex::uv
    /// From that place to where the texture is read: what a step of u adds, what one of v adds, and an offset. Finite.
    glm::mat3x2 transform{1.0f};

    bool operator==(const TextureUse&) const = default;
};

/// Most of Material::baseColorFactor that counts: the largest half float. What is more would be infinite, and black times that no number.
/// Of a surface that is not blended, the product with vertex colour and texture counts as 1 where it is more.
inline constexpr float kMaxBaseColor = 65504.0f;
/// Most of MaterialDetail::normalScale that counts, and least below 0. Beyond it a normal lies in the surface, and products overflow.
inline constexpr float kMaxNormalScale = 1e4f;

/// What a material of glTF 2.0 has beside its base colour, metallic and roughness. Unlit ones are drawn with what they emit alone.
struct MaterialDetail {
    std::optional<TextureUse>
        metallicRoughness{};               ///< blue and green, of data, multiply Material::metallicRoughness
    std::optional<TextureUse> normal{};    ///< in tangent space, of data
    std::optional<TextureUse> occlusion{}; ///< red, of data: the share of ambient light that arrives
    std::optional<TextureUse> emissive{};  ///< of colour, multiplies `emission`
    float normalScale = 1.0f;       ///< of x and y of a normal texture; beyond kMaxNormalScale as at it
    float occlusionStrength = 1.0f; ///< in [0, 1]: 0 is no occlusion
    glm::vec3 emission{0.0f};       ///< linear, what the surface sends by itself, 0 or more

    bool operator==(const MaterialDetail&) const = default;
};

/// How a surface looks.
struct Material {
    std::string name{};              ///< for messages and captures
    glm::vec4 baseColorFactor{1.0f}; ///< linear, 0 or more, above kMaxBaseColor as at it; alpha in [0, 1]
    std::optional<std::uint32_t> baseColorTexture{};      ///< index into Scene::textures
    std::optional<MetallicRoughness> metallicRoughness{}; ///< empty: Lambert's law alone
    bool doubleSided = false;                             ///< else its back is not drawn
    bool unlit = false;                                   ///< shows its base colour and emission in any light
    AlphaMode alphaMode = AlphaMode::opaque;              ///< what alpha does
    float alphaCutoff = 0.5f;                             ///< with AlphaMode::mask: below it nothing is drawn
    /// Offset towards the camera, along the view distance, in scene units, finite; below 0 away from it. It decides
    /// which of two surfaces at the same place is seen, and moves nothing else. See src/cdr/render/geometry/README.md,
    /// "Layers".
    float layer = 0.0f;
    MaterialDetail detail{}; ///< none by default

    bool operator==(const Material&) const = default;
};

/// The least radius about the origin that holds every position, rounded up. Object space.
CDR_EXPORT float boundingRadiusOf(std::span<const Vertex> vertices);

/// Calls `visit` with each texture index of a material, which it may change.
template <typename AnyMaterial, typename Visit>
void forEachTexture(AnyMaterial& material, const Visit& visit) {
    if (material.baseColorTexture) {
        visit(*material.baseColorTexture);
    }
    for (auto* use : {&material.detail.metallicRoughness, &material.detail.normal, &material.detail.occlusion,
                      &material.detail.emissive}) {
        if (*use) {
            visit((*use)->texture);
        }
    }
}

/// Whether a material is drawn with more than its base colour, metallic and roughness.
inline bool hasDetail(const Material& material) {
    return material.unlit ? material.detail.emission != glm::vec3(0.0f) : material.detail != MaterialDetail{};
}

/// Whether shading must be told of an opaque surface what it emits, and how much ambient light arrives there.
inline bool hasEmission(const Material& material) {
    const bool isOccluded = !material.unlit && material.detail.occlusion.has_value();
    return material.alphaMode != AlphaMode::blend &&
           (isOccluded || material.detail.emission != glm::vec3(0.0f));
}

/// A box of the given half sides, in object space, about the origin, 24 vertices, flat normals, 12 triangles.
CDR_EXPORT Mesh makeBox(const glm::vec3& halfSides);

/// The same triangles, each with three vertices of its own, as in a mesh without an index buffer. Without
/// levels.
CDR_EXPORT Mesh unshareVertices(const Mesh& mesh);

} // namespace cdr::scene
