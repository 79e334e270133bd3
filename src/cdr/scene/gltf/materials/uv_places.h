#pragma once

#include "uv.h"

#include <cdr/scene/mesh.h>

#include <cstdint>
#include <optional>
#include <span>

namespace cdr::scene::gltf {

/// At which places of its textures a material's primitives read them: a vertex has room for two.
struct UvPlaces {
    /// Which place tangents follow, where any texture needs them.
    enum class Tangents : std::uint8_t { none, first, second };

    std::optional<UvSource> first;  ///< of Vertex::uv
    std::optional<UvSource> second; ///< of VertexDetail::uv
    Tangents tangents = Tangents::none;

    /// Whether vertices need scene::VertexDetail.
    bool hasDetail() const { return second.has_value() || tangents != Tangents::none; }
};

/// Chooses places for textures. Where there are no more than two, each has its own. Of more, those of the second set of
/// coordinates, or else of the normal texture, are beside the first. The others are read at one of them by a transform.
/// @param sources of all textures, the first the base colour's where there is one.
/// @param normal of the normal texture; null where there is none.
UvPlaces choosePlaces(std::span<const UvSource> sources, const UvSource* normal);

/// What a texture's transform must leave as it is.
enum class Kept : std::uint8_t { nothing, tangents };

/// At which place a source is read, and by which transform. Nothing where neither place leads there.
/// @param kept tangents: of a normal texture, which must not turn against the tangents of its place.
std::optional<TextureUse> useAt(const UvPlaces& places, const UvSource& source, Kept kept);

} // namespace cdr::scene::gltf
