#pragma once

#include "../uv.h"

#include <cstdint>
#include <optional>

namespace cdr::scene::gltf {

/// At which places of its textures a material's primitives read them: a vertex has room for two.
struct UvPlaces {
    /// Which place tangents follow, where any texture needs them.
    enum class Tangents : std::uint8_t { none, first, second };

    std::optional<UvSource> first;  ///< of Vertex::uv
    std::optional<UvSource> second; ///< of VertexDetail::uv
    Tangents tangents = Tangents::none;

    /// Whether a source is the second place; takes room for it where there is some. Nothing where there is none left.
    std::optional<bool> place(const UvSource& source) {
        if (!first || *first == source) {
            first = source;
            return false;
        }
        if (!second || *second == source) {
            second = source;
            return true;
        }
        return std::nullopt;
    }

    /// Whether vertices need scene::VertexDetail.
    bool hasDetail() const { return second.has_value() || tangents != Tangents::none; }
};

} // namespace cdr::scene::gltf
