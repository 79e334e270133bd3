#pragma once

/// @file
/// @errors requireUsable() throws base::InputError that says what is wrong, unless a scene may hold the value. isUsable()
///         throws nothing.

#include <cdr/base/export.h>
#include <cdr/scene/scene.h>

#include <optional>
#include <span>
#include <string>

namespace cdr::scene {

/// Where an instance is and how it is turned and scaled.
struct Transform {
    glm::dvec3 position{0.0}; ///< world space, of the mesh's origin
    glm::mat3 basis{1.0f};    ///< object to world, rotation and scale

    bool operator==(const Transform&) const = default;
};

/// What surrounds the things of a scene: its members of these names.
struct Environment {
    glm::vec3 ambient{0.25f};   ///< linear, 0 or more, multiplies albedo
    glm::vec3 background{0.0f}; ///< linear, 0 or more
    std::optional<Sky> sky{};   ///< takes the place of `ambient`
    std::optional<Air> air{};   ///< between the camera and what it sees
};

/// Whether requireUsable() would let it pass.
CDR_EXPORT bool isUsable(const Transform& transform);

/// Position and basis finite, the basis' columns no longer than 1e17.
/// @param what names the value in the message, here and below
CDR_EXPORT void requireUsable(const Transform& transform, const std::string& what);
/// Position, colour and half distance finite, half distance and range above 0, the cone's angles in the order that LightCone
/// names.
CDR_EXPORT void requireUsable(const PointLight& light, const std::string& what);
/// Indices are in range. Vertices are finite and within the bounding radius, which is at most 1e20. There are at most
/// kMaxLevels levels. Clusters and groups refer to what is there, and have spheres and cones as cluster_tree.h says. Errors of
/// levels and groups are finite and 0 or more.
CDR_EXPORT void requireUsable(const Mesh& mesh, const std::string& what);
/// The part of it that vertices decide.
/// @param boundingRadius object space
CDR_EXPORT void requireUsable(std::span<const Vertex> vertices, float boundingRadius,
                              const std::string& what);
/// None, or one for each vertex, finite.
/// @param vertices how many the mesh has
CDR_EXPORT void requireUsable(std::span<const VertexDetail> details, std::size_t vertices,
                              const std::string& what);
/// Colours finite and 0 or more, and numbers in the ranges that Sky and Air name.
CDR_EXPORT void requireUsable(const Environment& environment);
/// As many pixels as its size says, at least one.
CDR_EXPORT void requireUsable(const Texture& texture, const std::string& what);
/// Textures that are there, and numbers in the ranges that Material and MaterialDetail name.
/// @param textures of the scene
CDR_EXPORT void requireUsable(const Material& material, std::size_t textures, const std::string& what);
/// All of the above, the sky, the air, and that instances name meshes and materials that are there, and objects up to kMaxObjects.
/// Their radii are finite and 0 or more, or kNoRadius.
CDR_EXPORT void requireUsable(const Scene& scene);

} // namespace cdr::scene
