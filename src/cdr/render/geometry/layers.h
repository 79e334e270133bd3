#pragma once

#include <cdr/scene/mesh.h>

#include <cstdint>
#include <span>
#include <vector>

namespace cdr::render {

/// The layer of a material as draws need it.
struct LayerPlace {
    float offset = 0.0f; ///< scene::Material::layer
    /// Place among the scene's layers, counted from those without an offset: 1 is the next nearer one, -1 the next
    /// farther. Neighbours are told apart by at least two steps of the depth buffer, and by what rounded vertices move.
    float rank = 0.0f;

    bool operator==(const LayerPlace&) const = default;
};

/// By material.
std::vector<LayerPlace> layerPlaces(std::span<const scene::Material> materials);

/// Pixels by which two surfaces can be shifted against each other where vertices are rounded to so many sub-pixel bits.
float layerSlope(std::uint32_t subPixelBits);

} // namespace cdr::render
