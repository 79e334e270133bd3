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

/// Smaller levels of colours that count by their alpha, or keep its coverage, are made from that alpha.
bool isAlphaFree(const scene::Texture& texture) {
    return !texture.alphaWeighs && !texture.cutoff;
}

/// Read where a base colour is.
bool isAtBase(const std::optional<scene::TextureUse>& use) {
    return use && *use == scene::TextureUse{.texture = use->texture};
}

} // namespace

bool mayBePacked(const scene::Material& material) {
    const scene::MaterialDetail& detail = material.detail;
    return !material.unlit && material.alphaMode == scene::AlphaMode::opaque && material.baseColorTexture &&
           isAtBase(detail.normal) && isAtBase(detail.emissive) && isAtBase(detail.occlusion) &&
           isAtBase(detail.metallicRoughness) && material.metallicRoughness;
}

bool isPackable(const scene::Material& material, std::span<const scene::Texture> textures) {
    if (!mayBePacked(material)) {
        return false;
    }
    const scene::Texture& base = textures[*material.baseColorTexture];
    const std::array<PackedPair, 3> pairs = packedPairsOf(material);
    return std::all_of(pairs.begin(), pairs.end(), [&](const PackedPair& pair) {
        const scene::Texture& host = textures[pair.host];
        const scene::Texture& guest = textures[pair.guest];
        return areReadAlike(host, base) && areReadAlike(guest, base) && isAlphaFree(host) &&
               isAlphaFree(guest) && guest.content == scene::TextureContent::data; // alpha is always linear
    });
}

std::array<PackedPair, 3> packedPairsOf(const scene::Material& material) {
    const scene::MaterialDetail& detail = material.detail;
    const std::uint32_t shine = detail.metallicRoughness->texture;
    // Metallic has the coarsest steps, so it stays in a texture of the same kind.
    return {PackedPair{.host = *material.baseColorTexture, .guest = detail.occlusion->texture, .channel = 0},
            PackedPair{.host = detail.normal->texture, .guest = shine, .channel = 2},
            PackedPair{.host = detail.emissive->texture, .guest = shine, .channel = 1}};
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
                  std::uint32_t channel) {
    for (std::size_t level = 0; level < hosts.size(); ++level) {
        for (std::size_t i = 0; i < hosts[level].pixels.size(); ++i) {
            hosts[level].pixels[i][3] = guests[level].pixels[i][channel];
        }
    }
}

} // namespace cdr::render
