#pragma once

#include <cdr/base/export.h>
#include <cdr/image/image.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cdr::scene {

/// A corner of a mesh.
struct Vertex {
    glm::vec3 position{0.0f};           ///< object space, relative to the mesh's bounding centre
    glm::vec3 normal{0.0f, 0.0f, 1.0f}; ///< object space, unit length
    glm::vec2 uv{0.0f};                 ///< of the texture, (0, 0) its first texel's corner
    glm::u8vec4 color{255};             ///< linear, multiplies the material's base colour
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
    std::string name;                   ///< for messages and captures
    std::vector<Vertex> vertices;       ///< shared by all levels
    std::vector<std::uint32_t> indices; ///< three per triangle, each below vertices.size()
    float boundingRadius = 0.0f;        ///< object space, about the origin
    /// Levels of detail, each coarser than the one before. The mesh itself is level 0, levels[k] is level k +
    /// 1. At most kMaxLevels; empty unless makeLevels() was called (lod/levels.h).
    std::vector<MeshLevel> levels;
    /// Half the sides, if the mesh is exactly an axis-aligned box about its origin. Ray casts then need no
    /// triangles.
    std::optional<glm::vec3> boxHalfSides;
};

/// Most levels beside the mesh itself; a level's number must fit a byte.
inline constexpr std::size_t kMaxLevels = 32;

/// An image that a material multiplies its base colour by.
struct Texture {
    std::string name{};         ///< for messages and captures
    image::ImageRgba8 pixels{}; ///< sRGB-encoded colour, linear alpha
    bool repeatU = true;        ///< beyond its edges; else the edge goes on
    bool repeatV = true;        ///< beyond its edges; else the edge goes on
};

/// What alpha does: nothing, cut away what is below the cutoff, or blend.
enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// The metallic-roughness material of glTF 2.0; both in [0, 1].
struct Shine {
    float metallic = 1.0f;  ///< 0 is a dielectric, 1 a metal, which reflects in its base colour
    float roughness = 1.0f; ///< perceptual: its square is the alpha of the microfacet distribution

    bool operator==(const Shine&) const = default;
};

/// How a surface looks.
struct Material {
    std::string name{};                              ///< for messages and captures
    glm::vec4 baseColorFactor{1.0f};                 ///< linear
    std::optional<std::uint32_t> baseColorTexture{}; ///< index into Scene::textures
    std::optional<Shine> shine{};                    ///< empty: Lambert's law alone
    bool doubleSided = false;                        ///< else its back is not drawn
    bool unlit = false;                              ///< shows its base colour, whatever light there is
    AlphaMode alphaMode = AlphaMode::opaque;         ///< what alpha does
    float alphaCutoff = 0.5f;                        ///< with AlphaMode::mask: below it nothing is drawn
    /// Offset towards the camera, along the view distance, in scene units, finite; below 0 away from it. It decides
    /// which of two surfaces at the same place is seen, and moves nothing else. See src/cdr/render/README.md, "Layers".
    float layer = 0.0f;
};

/// The least radius about the origin that holds every position, rounded up.
CDR_EXPORT float boundingRadiusOf(std::span<const Vertex> vertices);

/// A box of the given half sides about the origin, 24 vertices, flat normals, 12 triangles.
CDR_EXPORT Mesh makeBox(const glm::vec3& halfSides);

/// The same triangles, each with three vertices of its own, as in a mesh without an index buffer. Without
/// levels.
CDR_EXPORT Mesh unshareVertices(const Mesh& mesh);

} // namespace cdr::scene
