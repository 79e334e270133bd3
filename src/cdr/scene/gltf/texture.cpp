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

/// glTF's numbers for filters.
enum Filter {
    kNearest = 9728,
    kLinear = 9729,
    kNearestMipmapNearest = 9984,
    kLinearMipmapNearest = 9985,
    kNearestMipmapLinear = 9986,
    kLinearMipmapLinear = 9987
};

/// How a sampler reads texels that are smaller than pixels. What it leaves open, and numbers that glTF does not have,
/// blend between texels and levels.
struct SmallFilter {
    bool showsTexels = false;
    TextureLevels levels = TextureLevels::blended;
};

SmallFilter smallFilterOf(const json& sampler) {
    switch (indexMember(sampler, "minFilter").value_or(kLinearMipmapLinear)) {
    case kNearest:
        return {.showsTexels = true, .levels = TextureLevels::none};
    case kLinear:
        return {.showsTexels = false, .levels = TextureLevels::none};
    case kNearestMipmapNearest:
        return {.showsTexels = true, .levels = TextureLevels::nearest};
    case kLinearMipmapNearest:
        return {.showsTexels = false, .levels = TextureLevels::nearest};
    case kNearestMipmapLinear:
        return {.showsTexels = true, .levels = TextureLevels::blended};
    default:
        return {};
    }
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
    const bool nearest = indexMember(sampler, "magFilter").value_or(kLinear) == kNearest;
    const SmallFilter small = smallFilterOf(sampler);
    const auto [found, isNew] =
        m_imported.try_emplace({*image, wrapU, wrapV, nearest, small.showsTexels, small.levels, content},
                               static_cast<std::uint32_t>(m_scene.textures.size()));
    if (isNew) {
        Texture texture{.repeatU = wrapU != kClampToEdge,
                        .repeatV = wrapV != kClampToEdge,
                        .mirrorU = wrapU == kMirroredRepeat,
                        .mirrorV = wrapV == kMirroredRepeat,
                        .nearest = nearest,
                        .nearestSmall = small.showsTexels,
                        .levels = small.levels,
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
