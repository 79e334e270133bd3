#include <cdr/render/geometry/layers.h>

#include <algorithm>
#include <cmath>

namespace cdr::render {

std::vector<LayerPlace> layerPlaces(std::span<const scene::Material> materials) {
    std::vector<float> offsets{0.0f};
    for (const scene::Material& material : materials) {
        offsets.push_back(material.layer);
    }
    std::sort(offsets.begin(), offsets.end());
    offsets.erase(std::unique(offsets.begin(), offsets.end()), offsets.end());
    const auto indexOf = [&](float offset) {
        return std::lower_bound(offsets.begin(), offsets.end(), offset) - offsets.begin();
    };
    std::vector<LayerPlace> places;
    places.reserve(materials.size());
    for (const scene::Material& material : materials) {
        places.push_back(
            {.offset = material.layer, .rank = static_cast<float>(indexOf(material.layer) - indexOf(0.0f))});
    }
    return places;
}

float layerSlope(std::uint32_t subPixelBits) {
    return std::ldexp(1.0f, -static_cast<int>(subPixelBits)); // each by half a step
}

} // namespace cdr::render
