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

/// A sampler's wrap mode; glTF's default repeats.
int wrapOf(const json& sampler, const char* key, int texture) {
    const int wrap = indexMember(sampler, key).value_or(kRepeat);
    if (wrap != kMirroredRepeat && wrap != kRepeat && wrap != kClampToEdge) {
        refuse("texture {}: wrap mode {} does not exist", texture, wrap);
    }
    return wrap;
}

/// glTF's numbers for the filters that show single texels, of the picture or of its mip levels.
enum Filter { kNearest = 9728, kNearestMipmapNearest = 9984, kNearestMipmapLinear = 9986 };

/// Whether a sampler shows single texels; notes one that does so only where texels are smaller than pixels.
bool showsTexels(const json& sampler, Notes& notes, int texture) {
    if (indexMember(sampler, "magFilter").value_or(0) == kNearest) {
        return true;
    }
    const int small = indexMember(sampler, "minFilter").value_or(0);
    if (small == kNearest || small == kNearestMipmapNearest || small == kNearestMipmapLinear) {
        notes.add("nearest filtering of small texels is drawn as linear", fmt::format("texture {}", texture));
    }
    return false;
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

std::optional<std::uint32_t> TextureImporter::use(int index, TextureContent content) {
    const std::optional<int> image = imageOf(index);
    if (!image) {
        return {};
    }
    const json& root = m_sources.document.root;
    const json& source = itemAt(root, "textures", index, "texture");
    const std::optional<int> samplerIndex = indexMember(source, "sampler");
    const json defaults = json::object();
    const json& sampler = samplerIndex ? itemAt(root, "samplers", *samplerIndex, "sampler") : defaults;
    const int wrapU = wrapOf(sampler, "wrapS", index);
    const int wrapV = wrapOf(sampler, "wrapT", index);
    const bool nearest = showsTexels(sampler, m_sources.notes, index);
    const auto [found, isNew] = m_imported.try_emplace({*image, wrapU, wrapV, nearest, content},
                                                       static_cast<std::uint32_t>(m_scene.textures.size()));
    if (isNew) {
        Texture texture{.repeatU = wrapU != kClampToEdge,
                        .repeatV = wrapV != kClampToEdge,
                        .mirrorU = wrapU == kMirroredRepeat,
                        .mirrorV = wrapV == kMirroredRepeat,
                        .nearest = nearest,
                        .content = content};
        texture.pixels = import(*image, texture.name);
        m_scene.textures.push_back(std::move(texture));
    }
    return found->second;
}

image::ImageRgba8 TextureImporter::import(int index, std::string& name) {
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
    name = oneLine(fullNameOf(source));
    image::ImageRgba8 pixels = image::decodeImage(encoded, fmt::format("image {}", index));
    m_pixels += pixels.pixels.size();
    if (m_pixels > kMaxTexturePixels) {
        refuse("its textures have over {} pixels", kMaxTexturePixels);
    }
    return pixels;
}

} // namespace cdr::scene::gltf
