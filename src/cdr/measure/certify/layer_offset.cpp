#include <cdr/measure/certify/layer_offset.h>

#include <set>

namespace cdr::measure {

std::vector<LayerOffset> layerOffsets(std::span<const scene::Material> materials) {
    std::set<float> offsets;
    for (const scene::Material& material : materials) {
        if (material.layer != 0.0f) {
            offsets.insert(material.layer);
        }
    }
    const auto ranksOf = [&](float layer) {
        return std::count_if(offsets.begin(), offsets.end(), [&](float offset) {
            return layer > 0.0f ? offset > 0.0f && offset <= layer : offset < 0.0f && offset >= layer;
        });
    };
    std::vector<LayerOffset> layers(materials.size());
    std::transform(materials.begin(), materials.end(), layers.begin(), [&](const scene::Material& material) {
        return material.layer == 0.0f
                   ? LayerOffset{}
                   : LayerOffset{material.layer, static_cast<double>(ranksOf(material.layer))};
    });
    return layers;
}

} // namespace cdr::measure
