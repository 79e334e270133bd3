#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace cdr::scene::gltf {

/// Where a texture's coordinates come from: a TEXCOORD set and KHR_texture_transform.
struct UvSource {
    int texCoord = 0;
    glm::dvec2 offset{0.0};
    glm::dvec2 scale{1.0};
    double rotation = 0.0; ///< radians

    /// The transformed coordinates of a vertex, zero when they are not finite.
    glm::vec2 apply(const glm::vec4& uv) const;

    /// What leads from these coordinates to those of another source of the same set; nothing where it would not be finite.
    std::optional<glm::mat3x2> leadingTo(const UvSource& other) const;

    bool operator==(const UvSource&) const = default;
};

/// Reads a texture reference and its KHR_texture_transform; refuses one that is not sound.
UvSource uvSourceOf(const nlohmann::json& info);

} // namespace cdr::scene::gltf
