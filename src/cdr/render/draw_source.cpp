#include <cdr/render/draw_source.h>
#include <cdr/render/materials/scene_textures.h>

#include <algorithm>

namespace cdr::render {

std::uint32_t variantOf(bool isFaceted, const scene::Material& material, std::uint32_t detailParts) {
    const bool isMasked = material.alphaMode == scene::AlphaMode::mask;
    const bool isTextured = material.baseColorTexture.has_value();
    const bool isLayered = material.layer != 0.0f && material.alphaMode != scene::AlphaMode::blend;
    if (detailParts == 0 && isFaceted && !isTextured && !isMasked && !isLayered && !material.doubleSided) {
        return kFacetedVariant;
    }
    return (isTextured ? kTexturedVariant : 0) + (isMasked ? kMaskedVariant : 0) +
           (isLayered ? kLayeredVariant : 0) + (isFaceted ? kPlanesVariant : 0) + detailParts * kDetailStep;
}

std::vector<std::uint32_t> variantsOf(std::span<const scene::Material> materials) {
    std::vector<std::uint32_t> variants;
    const auto add = [&](std::uint32_t variant) {
        if (std::find(variants.begin(), variants.end(), variant) == variants.end()) {
            variants.push_back(variant);
        }
    };
    for (const scene::Material& material : materials) {
        for (const bool isFaceted : {false, true}) {
            const std::uint32_t parts = detailPartsOf(material);
            add(variantOf(isFaceted, material, parts));
            if (mayBePacked(material)) {
                add(variantOf(isFaceted, material, parts | shaders::kDetailPacked));
            }
        }
    }
    return variants;
}

} // namespace cdr::render
