#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/upload.h>
#include <cdr/image/levels.h>
#include <cdr/platform/worker_pool.h>
#include <cdr/render/materials/material_words.h>
#include <cdr/render/materials/scene_textures.h>
#include <cdr/shaders/shared.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <utility>

namespace cdr::render {

namespace {

constexpr auto kTextureType = vk::DescriptorType::eCombinedImageSampler;

/// The bindings of a material's detail: textures in the order of kDetailParts, then the record.
const std::vector kDetailTypes{kTextureType, kTextureType, kTextureType, kTextureType,
                               vk::DescriptorType::eUniformBuffer};

/// A texture of a material's detail, and the part that says so to shaders.
struct DetailPart {
    std::optional<scene::TextureUse> scene::MaterialDetail::*use;
    std::uint32_t part;
};
constexpr std::array<DetailPart, shaders::kDetailTextures> kDetailParts{
    DetailPart{&scene::MaterialDetail::metallicRoughness, shaders::kDetailMetallicRoughness},
    DetailPart{&scene::MaterialDetail::normal, shaders::kDetailNormal},
    DetailPart{&scene::MaterialDetail::occlusion, shaders::kDetailOcclusion},
    DetailPart{&scene::MaterialDetail::emissive, shaders::kDetailEmissive},
};

/// Whether a material has a part of which it has the texture: unlit ones only emit, and matt ones have no metallic and roughness.
bool isRead(const DetailPart& part, const scene::Material& material) {
    return part.part == shaders::kDetailEmissive ||
           (!material.unlit &&
            (material.metallicRoughness || part.part != shaders::kDetailMetallicRoughness));
}

bool isMoved(const scene::TextureUse& use) {
    return use.transform != scene::TextureUse{}.transform;
}

vk::Filter filterOf(scene::Filter filter) {
    return filter == scene::Filter::nearest ? vk::Filter::eNearest : vk::Filter::eLinear;
}

vk::SamplerAddressMode addressModeOf(scene::WrapMode mode) {
    switch (mode) {
    case scene::WrapMode::clampToEdge:
        return vk::SamplerAddressMode::eClampToEdge;
    case scene::WrapMode::mirroredRepeat:
        return vk::SamplerAddressMode::eMirroredRepeat;
    case scene::WrapMode::repeat:
        break;
    }
    return vk::SamplerAddressMode::eRepeat;
}

/// The largest level of detail of a texture without levels, so that a minified one still takes its own filter. A quarter
/// is what the Vulkan specification advises for VkSamplerCreateInfo.
constexpr float kFirstLevelAlone = 0.25f;

vk::SamplerCreateInfo samplerInfo(const scene::Texture& texture) {
    return {.magFilter = filterOf(texture.magFilter),
            .minFilter = filterOf(texture.minFilter),
            .mipmapMode = texture.levels == scene::TextureLevels::blended ? vk::SamplerMipmapMode::eLinear
                                                                          : vk::SamplerMipmapMode::eNearest,
            .addressModeU = addressModeOf(texture.wrapU),
            .addressModeV = addressModeOf(texture.wrapV),
            .maxLod = texture.levels == scene::TextureLevels::none ? kFirstLevelAlone : VK_LOD_CLAMP_NONE};
}

shaders::DetailRecord recordOf(const scene::Material& material) {
    const scene::MaterialDetail& detail = material.detail;
    const scene::MetallicRoughness metallicRoughness =
        material.metallicRoughness.value_or(scene::MetallicRoughness{.metallic = 0.0f, .roughness = 1.0f});
    shaders::DetailRecord record{.emissionAndNormalScale = glm::vec4(detail.emission, normalScaleOf(detail)),
                                 .metallicRoughnessAndOcclusion = {metallicRoughness.metallic,
                                                                   metallicRoughness.roughness,
                                                                   detail.occlusionStrength, 0.0f},
                                 .secondPlaces = 0,
                                 .unused0 = 0,
                                 .unused1 = 0,
                                 .unused2 = 0,
                                 .turns = {},
                                 .offsets = {}};
    for (std::size_t i = 0; i < kDetailParts.size(); ++i) {
        const scene::TextureUse use = (detail.*kDetailParts[i].use).value_or(scene::TextureUse{});
        record.secondPlaces |= use.second ? kDetailParts[i].part : 0u;
        record.turns[i] = {use.transform[0], use.transform[1]};
        record.offsets[i] = {use.transform[2], 0.0f, 0.0f};
    }
    return record;
}

/// Whether workers save time with a texture's smaller levels.
bool hasDividedLevels(const scene::Texture& texture) {
    return levelsOf(texture) > 1 && image::areLevelsDivided(texture.pixels.width, texture.pixels.height);
}

/// By place, whether it changed.
std::vector<bool> flagsOf(const SceneTextures::Changed& changed, std::size_t places) {
    std::vector<bool> flags(places, !changed);
    if (changed) {
        for (const std::uint32_t place : *changed) {
            flags[place] = true;
        }
    }
    return flags;
}

/// Of one texture with its levels.
std::uint64_t bytesOf(const scene::Texture& texture) {
    return image::levelPixels(texture.pixels.width, texture.pixels.height, levelsOf(texture)) *
           sizeof(image::Rgba8);
}

/// For messages: its place, and its own name if it has one.
std::string nameOfTexture(const scene::Scene& scene, std::uint32_t i) {
    const std::string& name = scene.textures[i].name;
    return "texture " + std::to_string(i) + (name.empty() ? "" : " " + name);
}

/// The textures that a material reads, each by itself.
std::vector<std::uint32_t> texturesOf(const scene::Material& material) {
    std::vector<std::uint32_t> textures;
    scene::forEachTexture(material, [&](std::uint32_t texture) { textures.push_back(texture); });
    return textures;
}

} // namespace

struct SceneTextures::Workers {
    std::size_t threads = 1;
    std::optional<platform::WorkerPool> pool{};
    const scene::Texture* guest = nullptr; ///< whose levels are kept: two pairs of a material have the same
    std::vector<image::ImageRgba8> guestLevels{};

    std::vector<image::ImageRgba8> levelsOf(const scene::Texture& texture) {
        if (!pool && hasDividedLevels(texture)) {
            pool.emplace(std::min(threads, platform::WorkerPool::kMaxThreads));
        }
        return allLevels(texture, pool ? &*pool : nullptr);
    }
    const std::vector<image::ImageRgba8>& guestLevelsOf(const scene::Texture& texture) {
        if (std::exchange(guest, &texture) != &texture) {
            guestLevels = levelsOf(texture);
        }
        return guestLevels;
    }
};

std::uint32_t detailPartsOf(const scene::Material& material) {
    if (!scene::hasDetail(material)) {
        return 0;
    }
    std::uint32_t parts = material.detail.emission != glm::vec3(0.0f) ? shaders::kDetailEmits : 0u;
    for (const DetailPart& part : kDetailParts) {
        if (const auto& use = material.detail.*part.use; use && isRead(part, material)) {
            parts |= part.part | (isMoved(*use) ? shaders::kDetailMoved : 0u);
        }
    }
    const bool isShared =
        material.detail.occlusion && material.detail.occlusion == material.detail.metallicRoughness;
    return parts | (isShared && !material.unlit ? shaders::kDetailShared : 0u);
}

SceneTextures::SceneTextures(const gpu::Device& device, std::size_t threads)
    : m_device(device),
      m_threads(threads != 0 ? threads : std::max(1u, std::thread::hardware_concurrency())),
      m_baseColorLayout(
          gpu::makeSetLayout(device, {{kTextureType}, vk::ShaderStageFlagBits::eFragment}, "texture set")),
      m_detailLayout(
          gpu::makeSetLayout(device, {kDetailTypes, vk::ShaderStageFlagBits::eFragment}, "detail set")),
      m_white(upload({}, "white texture", std::vector{image::ImageRgba8(1, 1, {255, 255, 255, 255})})) {}

vk::Sampler SceneTextures::samplerOf(const scene::Texture& texture) {
    const vk::SamplerCreateInfo info = samplerInfo(texture);
    const auto found = std::find_if(m_samplers.begin(), m_samplers.end(),
                                    [&](const Sampler& sampler) { return sampler.info == info; });
    if (found != m_samplers.end()) {
        return *found->made;
    }
    vk::UniqueSampler made = vk::Device(m_device.handle()).createSamplerUnique(info);
    return *m_samplers.emplace_back(Sampler{.info = info, .made = std::move(made)}).made;
}

SceneTextures::Uploaded SceneTextures::upload(const scene::Texture& texture, const std::string& name,
                                              std::span<const image::ImageRgba8> levels) {
    const vk::Format format = texture.content == scene::TextureContent::color ? vk::Format::eR8G8B8A8Srgb
                                                                              : vk::Format::eR8G8B8A8Unorm;
    std::vector<std::span<const std::byte>> bytes;
    for (const image::ImageRgba8& level : levels) {
        bytes.push_back(std::as_bytes(std::span(level.pixels)));
    }
    Uploaded uploaded{.image = gpu::uploadImage(m_device, {levels.front().width, levels.front().height},
                                                format, bytes, name),
                      .sampler = samplerOf(texture),
                      .set = {m_device, m_baseColorLayout}};
    uploaded.set.setImage(0, uploaded.image.view(), uploaded.sampler);
    return uploaded;
}

void SceneTextures::follow(const scene::Scene& scene, const Changed& changed, gpu::Retired& retired) {
    const std::vector<bool> isOther = flagsOf(changed, std::max(scene.textures.size(), m_textures.size()));
    for (std::size_t i = 0; i < m_textures.size(); ++i) {
        if (m_textures[i] && (isOther[i] || i >= scene.textures.size())) {
            retired.add(*std::exchange(m_textures[i], std::nullopt));
        }
    }
    m_textures.resize(scene.textures.size());
    std::erase_if(m_pairs, [&](const auto& pair) {
        return pair.second.expired() || isOther[pair.first.host] || isOther[pair.first.guest];
    });
}

void SceneTextures::uploadTexturesOf(const scene::Scene& scene, const scene::Material& material,
                                     Workers& workers) {
    for (const std::uint32_t i : texturesOf(material)) {
        if (!m_textures[i]) {
            m_textures[i] =
                upload(scene.textures[i], nameOfTexture(scene, i), workers.levelsOf(scene.textures[i]));
        }
    }
}

std::shared_ptr<const SceneTextures::Uploaded>
SceneTextures::uploadPair(const scene::Scene& scene, const PackedPair& pair, Workers& workers) {
    if (std::shared_ptr<const Uploaded> there = m_pairs[pair].lock()) {
        return there;
    }
    std::vector<image::ImageRgba8> levels = workers.levelsOf(scene.textures[pair.host]);
    putIntoAlpha(levels, workers.guestLevelsOf(scene.textures[pair.guest]), pair.channel);
    auto made = std::make_shared<const Uploaded>(
        upload(scene.textures[pair.host], nameOfTexture(scene, pair.host), levels));
    m_pairs[pair] = made;
    return made;
}

SceneTextures::Packed SceneTextures::pack(const scene::Scene& scene, const scene::Material& material,
                                          Workers& workers) {
    const auto [base, normal, emissive] = packedPairsOf(material);
    return {.base = uploadPair(scene, base, workers),
            .normal = uploadPair(scene, normal, workers),
            .emissive = uploadPair(scene, emissive, workers)};
}

void SceneTextures::followMaterials(const scene::Scene& scene, const Changed& changed,
                                    gpu::Retired& retired) {
    const std::vector<bool> isOther = flagsOf(changed, scene.materials.size());
    for (; m_details.size() > scene.materials.size(); m_details.pop_back()) {
        if (*m_details.back().set) {
            retired.add(std::move(m_details.back()));
        }
    }
    Workers workers{.threads = m_threads};
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (i >= m_details.size()) {
            m_details.emplace_back();
        } else if (!isOther[i]) {
            continue;
        }
        const scene::Material& material = scene.materials[i];
        std::optional<Packed> packed;
        if (isPackable(material, scene.textures)) {
            packed = pack(scene, material, workers);
        } else {
            uploadTexturesOf(scene, material, workers);
        }
        Detail made = scene::hasDetail(material) ? makeDetail(material, std::move(packed)) : Detail{};
        if (Detail before = std::exchange(m_details[i], std::move(made)); *before.set) {
            retired.add(std::move(before));
        }
    }
}

SceneTextures::Detail SceneTextures::makeDetail(const scene::Material& material,
                                                std::optional<Packed> packed) const {
    Detail made{.packed = std::move(packed),
                .record = {m_device, sizeof(shaders::DetailRecord), vk::BufferUsageFlagBits::eUniformBuffer,
                           gpu::MemoryUse::hostWrites, "detail of " + material.name},
                .set = {m_device, m_detailLayout}};
    made.record.as<shaders::DetailRecord>(1).front() = recordOf(material);
    made.record.flush();
    std::uint32_t binding = 0;
    for (const DetailPart& part : kDetailParts) {
        const auto& use = material.detail.*part.use;
        const Uploaded* texture = &m_white;
        if (made.packed) {
            texture = part.part == shaders::kDetailNormal     ? made.packed->normal.get()
                      : part.part == shaders::kDetailEmissive ? made.packed->emissive.get()
                                                              : texture; // not read
        } else if (use) {
            texture = &*m_textures[use->texture];
        }
        made.set.setImage(binding++, texture->image.view(), texture->sampler);
    }
    made.set.setBuffer(binding, made.record);
    return made;
}

vk::DescriptorSet SceneTextures::baseColorSet(const scene::Scene& scene, std::size_t material) const {
    const std::optional<std::uint32_t>& texture = scene.materials[material].baseColorTexture;
    if (const auto& packed = m_details[material].packed) {
        return *packed->base->set;
    }
    return texture ? *m_textures[*texture]->set : *m_white.set;
}

std::uint32_t SceneTextures::detailParts(const scene::Scene& scene, std::size_t material) const {
    return detailPartsOf(scene.materials[material]) |
           (m_details[material].packed ? shaders::kDetailPacked : 0u);
}

std::uint64_t SceneTextures::predictBytes(const scene::Scene& scene) {
    std::set<std::uint32_t> alone;
    std::set<PackedPair> pairs;
    for (const scene::Material& material : scene.materials) {
        if (isPackable(material, scene.textures)) {
            const std::array<PackedPair, 3> ofMaterial = packedPairsOf(material);
            pairs.insert(ofMaterial.begin(), ofMaterial.end());
        } else {
            const std::vector<std::uint32_t> textures = texturesOf(material);
            alone.insert(textures.begin(), textures.end());
        }
    }
    std::uint64_t bytes = 0;
    for (const std::uint32_t texture : alone) {
        bytes += bytesOf(scene.textures[texture]);
    }
    for (const PackedPair& pair : pairs) {
        bytes += bytesOf(scene.textures[pair.host]);
    }
    return bytes;
}

} // namespace cdr::render
