#include <cdr/image/levels.h>
#include <cdr/render/materials/texture_packing.h>

#include <algorithm>
#include <utility>

namespace cdr::render {

namespace {

/// Whether one sampler serves both, and all levels have the same sizes.
bool areReadAlike(const scene::Texture& a, const scene::Texture& b) {
    return a.pixels.width == b.pixels.width && a.pixels.height == b.pixels.height && a.wrapU == b.wrapU &&
           a.wrapV == b.wrapV && a.magFilter == b.magFilter && a.minFilter == b.minFilter &&
           a.levels == b.levels;
}

/// Read where a base colour is.
bool isAtBase(const std::optional<scene::TextureUse>& use) {
    return use && *use == scene::TextureUse{.texture = use->texture};
}

} // namespace

bool isPackable(const scene::Material& material, std::span<const scene::Texture> textures) {
    const scene::MaterialDetail& detail = material.detail;
    if (material.unlit || material.alphaMode != scene::AlphaMode::opaque || !material.baseColorTexture ||
        !isAtBase(detail.normal) || !isAtBase(detail.emissive) || !isAtBase(detail.occlusion) ||
        !isAtBase(detail.metallicRoughness)) {
        return false;
    }
    const PackKey key = packKeyOf(material);
    const scene::Texture& base = textures[key[0]];
    // Smaller levels of colours that count by their alpha, or keep its coverage, are made from that alpha.
    return std::all_of(key.begin(), key.end(), [&](std::uint32_t place) {
        const scene::Texture& texture = textures[place];
        return areReadAlike(texture, base) && !texture.alphaWeighs && !texture.cutoff;
    });
}

PackKey packKeyOf(const scene::Material& material) {
    const scene::MaterialDetail& detail = material.detail;
    return {*material.baseColorTexture, detail.normal->texture, detail.emissive->texture,
            detail.occlusion->texture, detail.metallicRoughness->texture};
}

std::uint32_t levelsOf(const scene::Texture& texture) {
    return texture.levels == scene::TextureLevels::none
               ? 1
               : image::levelCount(texture.pixels.width, texture.pixels.height);
}

std::vector<image::ImageRgba8> allLevels(const scene::Texture& texture, platform::WorkerPool* workers) {
    std::vector<image::ImageRgba8> levels{texture.pixels};
    for (image::ImageRgba8& level :
         image::smallerLevels(texture.pixels, scene::levelRulesOf(texture), levelsOf(texture) - 1, workers)) {
        levels.push_back(std::move(level));
    }
    return levels;
}

void putIntoAlpha(std::vector<image::ImageRgba8>& hosts, const std::vector<image::ImageRgba8>& guests,
                  std::size_t channel) {
    for (std::size_t level = 0; level < hosts.size(); ++level) {
        for (std::size_t i = 0; i < hosts[level].pixels.size(); ++i) {
            hosts[level].pixels[i][3] = guests[level].pixels[i][channel];
        }
    }
}

} // namespace cdr::render
