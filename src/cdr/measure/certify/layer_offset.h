#pragma once

#include <cdr/scene/mesh.h>

#include <algorithm>
#include <span>
#include <vector>

namespace cdr::measure {

/// The layer of a surface: what orders it among others at its place. Distances that a picture keeps do not have it.
struct LayerOffset {
    double view = 0.0; ///< scene::Material::layer, scene units towards the camera
    /// How many offsets of the scene's materials lie from none to this one. A device parts neighbours by two steps of its
    /// buffer, and by what rounded vertices move; it does so once for each.
    double ranks = 0.0;

    /// By how much a device moves a surface at a view distance: at most half of the way, before it parts neighbours.
    double movedView(double distanceView) const { return std::min(view, 0.5 * distanceView); }
};

/// By material.
std::vector<LayerOffset> layerOffsets(std::span<const scene::Material> materials);

} // namespace cdr::measure
