#include "checks.h"
#include "json.h"
#include "material.h"

#include <cdr/image/codec.h>

#include <utility>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

/// Most pixels of all textures of one file together: 4 bytes each, so 1 GiB.
constexpr std::uint64_t kMaxTexturePixels = 256ull << 20;

/// glTF's numbers for how a texture goes on beyond its edge.
enum Wrap { kClampToEdge = 33071, kMirroredRepeat = 33648, kRepeat = 10497 };

/// Whether a sampler's wrap mode repeats; glTF's default does.
bool repeats(const json& sampler, const char* key, Notes& notes, int texture) {
    const int wrap = indexMember(sampler, key).value_or(kRepeat);
    switch (wrap) {
    case kMirroredRepeat:
        notes.add("mirrored wrapping is drawn as plain repeat", fmt::format("texture {}", texture));
        return true;
    case kRepeat:
        return true;
    case kClampToEdge:
        return false;
    default:
        refuse("texture {}: wrap mode {} does not exist", texture, wrap);
    }
}

/// glTF's numbers for the filters that show single texels, of the picture or of its mip levels.
enum Filter { kNearest = 9728, kNearestMipmapNearest = 9984, kNearestMipmapLinear = 9986 };

/// Whether a sampler magnifies or minifies so.
bool isNearest(const json& sampler) {
    const int magnifying = indexMember(sampler, "magFilter").value_or(0);
    const int minifying = indexMember(sampler, "minFilter").value_or(0);
    return magnifying == kNearest || minifying == kNearest || minifying == kNearestMipmapNearest ||
           minifying == kNearestMipmapLinear;
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
    const std::optional<int> image =
        indexMember(itemAt(m_sources.document.root, "textures", index, "texture"), "source");
    if (!image) {
        m_sources.notes.add("a texture's picture is supplied by an extension that is not supported",
                            fmt::format("texture {}", index));
    }
    return image;
}

std::optional<glm::dvec2> TextureImporter::meanMetallicRoughness(int index) {
    const std::optional<int> image = imageOf(index);
    if (!image) {
        return {};
    }
    const auto [found, isNew] = m_means.try_emplace(*image, 0.0);
    if (isNew) {
        found->second = meanOfBlueAndGreen(import(*image).pixels);
    }
    return found->second;
}

std::optional<std::uint32_t> TextureImporter::use(int index) {
    const std::optional<int> image = imageOf(index);
    if (!image) {
        return {};
    }
    const json& root = m_sources.document.root;
    const json& source = itemAt(root, "textures", index, "texture");
    bool repeatU = true;
    bool repeatV = true;
    if (const std::optional<int> sampler = indexMember(source, "sampler")) {
        const json& chosen = itemAt(root, "samplers", *sampler, "sampler");
        repeatU = repeats(chosen, "wrapS", m_sources.notes, index);
        repeatV = repeats(chosen, "wrapT", m_sources.notes, index);
        if (isNearest(chosen)) {
            m_sources.notes.add("nearest filtering is drawn as linear", fmt::format("texture {}", index));
        }
    }
    const auto [found, isNew] = m_imported.try_emplace({*image, repeatU, repeatV},
                                                       static_cast<std::uint32_t>(m_scene.textures.size()));
    if (isNew) {
        Texture texture = import(*image);
        texture.repeatU = repeatU;
        texture.repeatV = repeatV;
        m_scene.textures.push_back(std::move(texture));
    }
    return found->second;
}

Texture TextureImporter::import(int index) {
    const json& source = itemAt(m_sources.document.root, "images", index, "image");
    const std::optional<int> bufferView = indexMember(source, "bufferView");
    const std::optional<std::string> uri = stringMember(source, "uri");
    if (bufferView.has_value() == uri.has_value()) {
        refuse("image {} must have one of 'uri' and 'bufferView'", index);
    }
    host::Bytes owned;
    std::span<const std::uint8_t> encoded;
    if (uri) {
        encoded = owned = m_sources.files.read(*uri);
    } else {
        encoded = m_sources.buffers.view(*bufferView).bytes;
    }
    Texture texture;
    texture.name = oneLine(fullNameOf(source));
    texture.pixels = image::decodeImage(encoded, fmt::format("image {}", index));
    m_pixels += texture.pixels.pixels.size();
    if (m_pixels > kMaxTexturePixels) {
        refuse("its textures have over {} pixels", kMaxTexturePixels);
    }
    return texture;
}

} // namespace cdr::scene::gltf
