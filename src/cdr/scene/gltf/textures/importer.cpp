#include "importer.h"

#include "../checks.h"
#include "../json.h"

#include <cdr/image/levels.h>
#include <cdr/platform/worker_pool.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

/// Most that all textures of one file take with their levels, where nothing else is said: 1 GiB and a third of it.
constexpr std::uint64_t kMaxTextureBytes = 1366ull << 20;

/// Most texels that all pictures of one file have before levels are left out, 1024 pictures of 8192x8192. Decoding them takes
/// minutes.
constexpr std::uint64_t kMaxDecodedTexels = 1ull << 36;

/// glTF's numbers for how a texture goes on beyond its edge.
enum GltfWrap { kClampToEdge = 33071, kMirroredRepeat = 33648, kRepeat = 10497 };

/// A sampler's wrap mode; glTF's default repeats.
WrapMode wrapOf(const json& sampler, const char* key, int texture) {
    const int wrap = indexMember(sampler, key).value_or(kRepeat);
    switch (wrap) {
    case kClampToEdge:
        return WrapMode::clampToEdge;
    case kMirroredRepeat:
        return WrapMode::mirroredRepeat;
    case kRepeat:
        return WrapMode::repeat;
    default:
        refuse("texture {}: wrap mode {} does not exist", texture, wrap);
    }
}

/// glTF's numbers for filters.
enum GltfFilter {
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
    Filter filter = Filter::linear;
    TextureLevels levels = TextureLevels::blended;
};

SmallFilter smallFilterOf(const json& sampler) {
    switch (indexMember(sampler, "minFilter").value_or(kLinearMipmapLinear)) {
    case kNearest:
        return {.filter = Filter::nearest, .levels = TextureLevels::none};
    case kLinear:
        return {.filter = Filter::linear, .levels = TextureLevels::none};
    case kNearestMipmapNearest:
        return {.filter = Filter::nearest, .levels = TextureLevels::nearest};
    case kLinearMipmapNearest:
        return {.filter = Filter::linear, .levels = TextureLevels::nearest};
    case kNearestMipmapLinear:
        return {.filter = Filter::nearest, .levels = TextureLevels::blended};
    default:
        return {};
    }
}

} // namespace

TextureImporter::TextureImporter(const Sources& sources, Scene& scene) : m_sources(sources), m_scene(scene) {}

std::optional<int> TextureImporter::imageOf(int index) {
    const std::optional<int> image =
        indexMember(itemAt(m_sources.document, "textures", index, "texture"), "source");
    if (!image) {
        m_sources.notes.add("a texture's picture is supplied by an extension that is not supported",
                            fmt::format("texture {}", index));
    }
    return image;
}

std::optional<std::uint32_t> TextureImporter::use(int index, TextureContent content, const AlphaUse& alpha) {
    const std::optional<int> image = imageOf(index);
    if (!image) {
        return {};
    }
    const json& root = m_sources.document;
    const json& source = itemAt(root, "textures", index, "texture");
    const std::optional<int> samplerIndex = indexMember(source, "sampler");
    const json defaults = json::object();
    const json& sampler = samplerIndex ? itemAt(root, "samplers", *samplerIndex, "sampler") : defaults;
    const WrapMode wrapU = wrapOf(sampler, "wrapS", index);
    const WrapMode wrapV = wrapOf(sampler, "wrapT", index);
    const bool isNearest = indexMember(sampler, "magFilter").value_or(kLinear) == kNearest;
    const Filter magFilter = isNearest ? Filter::nearest : Filter::linear;
    const SmallFilter small = smallFilterOf(sampler);
    const auto [found, isNew] = m_imported.try_emplace(
        {*image, wrapU, wrapV, magFilter, small.filter, small.levels, content, alpha.weighs, alpha.cutoff},
        static_cast<std::uint32_t>(m_scene.textures.size()));
    if (isNew) {
        Shown& shown = shownOf(*image);
        shown.textures.push_back(found->second);
        m_needs.push_back({.size = shown.source.size, .hasLevels = small.levels != TextureLevels::none});
        m_scene.textures.push_back({.name = shown.source.name,
                                    .wrapU = wrapU,
                                    .wrapV = wrapV,
                                    .magFilter = magFilter,
                                    .minFilter = small.filter,
                                    .levels = small.levels,
                                    .content = content,
                                    .alphaWeighs = alpha.weighs,
                                    .cutoff = alpha.cutoff});
    }
    return found->second;
}

TextureImporter::Shown& TextureImporter::shownOf(int image) {
    const auto [found, isNew] = m_shownOf.try_emplace(image, m_shown.size());
    if (isNew) {
        m_shown.push_back({.source = readPictureSource(m_sources, image), .textures = {}});
    }
    return m_shown[found->second];
}

std::vector<std::uint32_t> TextureImporter::dropLevels(const std::optional<std::uint64_t>& bytes) {
    std::vector<std::uint32_t> dropped(m_needs.size(), 0);
    if (bytes) {
        dropped = levelsToDrop(m_needs, *bytes);
        for (const Shown& shown : m_shown) {
            if (std::any_of(shown.textures.begin(), shown.textures.end(),
                            [&](std::uint32_t texture) { return dropped[texture] > 0; })) {
                m_sources.notes.add(
                    fmt::format("shown smaller than it is, so that all textures fit in {} MiB",
                                *bytes >> 20u),
                    shown.source.label());
            }
        }
    }
    const std::uint64_t needed = textureBytes(m_needs, dropped);
    if (needed > bytes.value_or(kMaxTextureBytes)) {
        refuse("its textures take {} MiB, over the limit of {}; --texture-memory shows them smaller",
               needed >> 20u, bytes.value_or(kMaxTextureBytes) >> 20u);
    }
    return dropped;
}

void TextureImporter::decode(const GltfLimits& limits, ReadProgress& progress) {
    const std::vector<std::uint32_t> dropped = dropLevels(limits.textureMemory);
    std::uint64_t texels = 0;
    for (const Shown& shown : m_shown) {
        texels += std::uint64_t{shown.source.size.width} * shown.source.size.height;
    }
    if (texels > kMaxDecodedTexels) {
        refuse("its pictures have {} million texels, over the limit of {}", texels / 1'000'000,
               kMaxDecodedTexels / 1'000'000);
    }
    const std::size_t most =
        limits.threads != 0 ? limits.threads : std::max(1u, std::thread::hardware_concurrency());
    platform::WorkerPool workers(
        std::clamp<std::size_t>(m_shown.size(), 1, std::min(most, platform::WorkerPool::kMaxThreads)));
    std::atomic<std::size_t> decoded = 0; // and not yet told
    workers.run(m_shown.size(), [&](std::size_t i, std::size_t worker) {
        fill(m_shown[i], dropped);
        ++decoded;
        if (worker == 0) { // the thread that imports
            progress.read(decoded.exchange(0) * kPictureBytes);
        }
    });
}

void TextureImporter::fill(const Shown& shown, const std::vector<std::uint32_t>& dropped) {
    const image::ImageRgba8 pixels = decodePicture(m_sources, shown.source);
    for (const std::uint32_t index : shown.textures) {
        Texture& texture = m_scene.textures[index];
        if (dropped[index] == 0) {
            texture.pixels = pixels;
        } else {
            texture.pixels =
                std::move(image::smallerLevels(pixels, levelRulesOf(texture), dropped[index]).back());
        }
    }
}

} // namespace cdr::scene::gltf
