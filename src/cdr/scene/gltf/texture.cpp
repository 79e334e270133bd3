#include "checks.h"
#include "material.h"

#include <cdr/image/codec.h>

namespace cdr::scene::gltf {

namespace {

/// Most pixels of all textures of one file together: 4 bytes each, so 1 GiB.
constexpr std::uint64_t kMaxTexturePixels = 256ull << 20;

/// Whether a wrap mode repeats; glTF's default does.
bool repeats(int wrap, Notes& notes, int texture) {
    switch (wrap) {
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
        notes.add("mirrored wrapping is drawn as plain repeat", fmt::format("texture {}", texture));
        return true;
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
        return true;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
        return false;
    default:
        refuse("texture {}: wrap mode {} does not exist", texture, wrap);
    }
}

/// Linear: glTF does not encode these channels. Of at least one pixel, as decoded pictures have.
glm::dvec2 meanOfBlueAndGreen(const image::ImageRgba8& picture) {
    glm::u64vec2 sum(0);
    for (const image::Rgba8& pixel : picture.pixels) {
        sum += glm::u64vec2(pixel[2], pixel[1]);
    }
    return glm::dvec2(sum) / (255.0 * static_cast<double>(picture.pixels.size()));
}

} // namespace

TextureImporter::TextureImporter(const Sources& sources, Scene& scene) : m_sources(sources), m_scene(scene) {}

std::optional<int> TextureImporter::imageOf(int index) {
    const tinygltf::Texture& texture = itemAt(m_sources.document.model.textures, index, "texture");
    if (texture.source < 0) {
        m_sources.notes.add("a texture's picture is supplied by an extension that is not supported",
                            fmt::format("texture {}", index));
        return {};
    }
    return texture.source;
}

std::optional<glm::dvec2> TextureImporter::meanMetallicRoughness(int index) {
    const std::optional<int> image = imageOf(index);
    if (!image) {
        return {};
    }
    const auto [found, isNew] = m_means.try_emplace(*image, 0.0);
    if (isNew) {
        found->second = meanOfBlueAndGreen(decode(*image));
    }
    return found->second;
}

std::optional<std::uint32_t> TextureImporter::use(int index) {
    const tinygltf::Model& model = m_sources.document.model;
    const std::optional<int> image = imageOf(index);
    if (!image) {
        return {};
    }
    const tinygltf::Texture& texture = itemAt(model.textures, index, "texture");
    bool repeatU = true;
    bool repeatV = true;
    if (texture.sampler >= 0) {
        const tinygltf::Sampler& sampler = itemAt(model.samplers, texture.sampler, "sampler");
        repeatU = repeats(sampler.wrapS, m_sources.notes, index);
        repeatV = repeats(sampler.wrapT, m_sources.notes, index);
    }
    const auto [found, isNew] = m_imported.try_emplace({*image, repeatU, repeatV},
                                                       static_cast<std::uint32_t>(m_scene.textures.size()));
    if (isNew) {
        image::ImageRgba8 pixels = decode(*image);
        const DataSource& source = itemAt(m_sources.document.images, *image, "image");
        m_scene.textures.push_back({source.name, std::move(pixels), repeatU, repeatV});
    }
    return found->second;
}

image::ImageRgba8 TextureImporter::decode(int imageIndex) {
    const DataSource& source = itemAt(m_sources.document.images, imageIndex, "image");
    host::Bytes owned;
    std::span<const std::uint8_t> encoded;
    if (source.uri) {
        encoded = owned = m_sources.files.read(*source.uri);
    } else {
        encoded = m_sources.buffers.view(m_sources.document.model, source.bufferView);
    }
    image::ImageRgba8 pixels = image::decodeImage(encoded, fmt::format("image {}", imageIndex));
    m_pixels += pixels.pixels.size();
    if (m_pixels > kMaxTexturePixels) {
        refuse("its textures have over {} pixels", kMaxTexturePixels);
    }
    return pixels;
}

} // namespace cdr::scene::gltf
