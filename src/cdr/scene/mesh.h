#pragma once

#include <cdr/image/image.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cdr::scene {

struct Vertex {
    glm::vec3 position{0.0f};           ///< object space, relative to the mesh's bounding centre
    glm::vec3 normal{0.0f, 0.0f, 1.0f}; ///< object space, unit length
    glm::vec2 uv{0.0f};
    glm::u8vec4 color{255}; ///< linear, multiplies the material's base colour
};

/// A coarser form of a mesh, over the mesh's own vertices.
struct MeshLevel {
    std::vector<std::uint32_t> indices; ///< three per triangle, each below the mesh's vertices.size()
    /// Object space: how far the two surfaces lie apart where they lie farthest apart (Hausdorff distance).
    float error = 0.0f;
};

/// An indexed triangle list. Front faces are counter-clockwise in object space; under an instance that
/// mirrors they stay the front faces (glTF 2.0, section 3.7.4), though they are clockwise in world space.
///
/// Vertices are stored about the centre of their bounding sphere: that keeps float32 positions small, which
/// is what bounds the smallest separation far away (DESIGN: why anchored works).
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices; ///< three per triangle, each below vertices.size()
    float boundingRadius = 0.0f;        ///< object space, about the origin
    /// Levels of detail, coarser and coarser; the mesh itself is level 0, levels[k] is level k + 1. At most
    /// kMaxLevels; empty where nobody made any (levels.h).
    std::vector<MeshLevel> levels;
    /// Half the sides when the mesh is exactly an axis-aligned box about its origin; lets the truth use
    /// slabs.
    std::optional<glm::vec3> boxHalfSides;
};

/// Most levels beside the mesh itself: a level's number fits a byte.
inline constexpr std::size_t kMaxLevels = 32;

struct Texture {
    std::string name;
    image::ImageRgba8 pixels; ///< sRGB-encoded colour, linear alpha
    bool repeatU = true;
    bool repeatV = true;
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// How a surface shines: glTF 2.0's metallic-roughness material, both in [0, 1].
struct Shine {
    float metallic = 1.0f;  ///< 0 is a dielectric, 1 a metal, whose base colour is what it mirrors
    float roughness = 1.0f; ///< perceptual: the microfacets' alpha is its square

    bool operator==(const Shine&) const = default;
};

struct Material {
    std::string name;
    glm::vec4 baseColorFactor{1.0f};                 ///< linear
    std::optional<std::uint32_t> baseColorTexture{}; ///< index into Scene::textures
    std::optional<Shine> shine{}; ///< empty is matt: Lambert's law alone, without a highlight
    bool doubleSided = false;
    bool unlit = false;
    AlphaMode alphaMode = AlphaMode::opaque;
    float alphaCutoff = 0.5f;
};

/// A box of the given half sides about the origin, 24 vertices, flat normals, 12 triangles.
Mesh makeBox(const glm::vec3& halfSides);

/// The same triangles with three vertices of their own each, as a mesh without an index buffer has them.
/// Without levels.
Mesh unshareVertices(const Mesh& mesh);

} // namespace cdr::scene
