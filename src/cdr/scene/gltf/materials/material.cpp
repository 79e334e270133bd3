#include "material.h"

#include "../checks.h"
#include "../json.h"
#include "layer.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <string_view>
#include <vector>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr const char* kColorTexture = "baseColorTexture";

constexpr std::array kDetailTextures{"normalTexture", "occlusionTexture", "emissiveTexture"};

/// What messages call the texture of a member.
const char* keyOf(std::optional<TextureUse> MaterialDetail::*use) {
    return use == &MaterialDetail::metallicRoughness ? "metallicRoughnessTexture"
           : use == &MaterialDetail::normal          ? kDetailTextures[0]
           : use == &MaterialDetail::occlusion       ? kDetailTextures[1]
                                                     : kDetailTextures[2];
}

/// Most that a surface emits, of any colour: render's picture is white far below.
constexpr double kMaxEmission = 1e4;

constexpr std::array<std::string_view, 3> kAlphaModes{"OPAQUE", "MASK", "BLEND"};

AlphaMode alphaMode(const json& material, const std::string& where) {
    const std::string name = stringMember(material, "alphaMode").value_or("OPAQUE");
    if (const auto mode = valueOf<AlphaMode>(kAlphaModes, name)) {
        return *mode;
    }
    refuse("{}: alpha mode '{}' does not exist", where, oneLine(name));
}

/// glTF bounds its factors by 0 and 1.
float shareMember(const json& object, const char* key, const std::string& where) {
    return static_cast<float>(std::clamp(numberMember(object, key, where).value_or(1.0), 0.0, 1.0));
}

/// Emitted light, linear; the strength is an extension's.
glm::vec3 emissionOf(const json& material, const std::string& where) {
    const auto factor = numbersMember(material, "emissiveFactor", 3, where);
    if (!factor) {
        return glm::vec3(0.0f);
    }
    double strength = 1.0;
    if (const json* extension = extensionOf(material, "KHR_materials_emissive_strength")) {
        strength = numberMember(*extension, "emissiveStrength", where).value_or(1.0);
    }
    const glm::dvec3 emitted =
        glm::clamp(glm::dvec3((*factor)[0], (*factor)[1], (*factor)[2]), 0.0, 1.0) * strength;
    return {glm::clamp(emitted, 0.0, kMaxEmission)};
}

/// What a material does with the alpha of its base colour's texture. Its own factor multiplies that alpha, so the cutoff is
/// divided by it.
AlphaUse alphaUseOf(const Material& material) {
    AlphaUse use{.weighs = material.alphaMode != AlphaMode::opaque};
    const float factor = material.baseColorFactor.a;
    if (material.alphaMode == AlphaMode::mask && material.alphaCutoff > 0.0f &&
        material.alphaCutoff <= factor) {
        use.cutoff = material.alphaCutoff / factor;
    }
    return use;
}

/// Leaves of a material what points and lines show.
void showOnSolid(Ground ground, Material& material, UvPlaces& uv) {
    material.doubleSided = false; // a solid is closed, and blending would show its back
    if (ground != Ground::solidWithTangents) {
        material.detail.normal.reset();
        uv.tangents = UvPlaces::Tangents::none;
    }
    if (ground == Ground::solidAlone) {
        material.unlit = true;
        material.metallicRoughness.reset();
    }
}

} // namespace

bool mayHaveDetail(const json& root, int material) {
    const json& materials = arrayMember(root, "materials");
    if (material < 0 || static_cast<std::size_t>(material) >= materials.size()) {
        return false;
    }
    const json& source = materials[static_cast<std::size_t>(material)];
    const json* factors = member(source, "pbrMetallicRoughness");
    return (factors != nullptr && member(*factors, "metallicRoughnessTexture") != nullptr) ||
           std::any_of(kDetailTextures.begin(), kDetailTextures.end(),
                       [&](const char* key) { return member(source, key) != nullptr; });
}

MaterialImporter::MaterialImporter(const Sources& sources, Scene& scene)
    : m_sources(sources),
      m_scene(scene),
      m_textures(sources, scene) {}

const MaterialUse& MaterialImporter::use(int material, Ground ground) {
    const std::pair key(material, ground);
    const auto found = m_imported.find(key);
    return found != m_imported.end() ? found->second
                                     : m_imported.emplace(key, import(material, ground)).first->second;
}

MaterialUse MaterialImporter::import(int index, Ground ground) {
    MaterialUse use;
    Material material;
    AskedPlaces asked;
    material.name = "default";
    material.metallicRoughness = MetallicRoughness{}; // glTF's defaults
    if (index >= 0) {
        const json& source = itemAt(m_sources.document, "materials", index, "material");
        const std::string where = fmt::format("material '{}'", nameOf(source));
        const json& factors = objectMember(source, "pbrMetallicRoughness", where);
        material.name = fullNameOf(source);
        if (const auto factor = numbersMember(factors, "baseColorFactor", 4, where)) {
            for (int c = 0; c < 4; ++c) {
                // glTF bounds the factors so; a renderer of 8-bit albedo relies on it.
                material.baseColorFactor[c] =
                    static_cast<float>(std::clamp((*factor)[static_cast<std::size_t>(c)], 0.0, 1.0));
            }
        }
        material.doubleSided = boolMember(source, "doubleSided", where);
        material.unlit = extensionOf(source, "KHR_materials_unlit") != nullptr;
        material.alphaMode = alphaMode(source, where);
        material.alphaCutoff = static_cast<float>(
            std::clamp(numberMember(source, "alphaCutoff", where).value_or(0.5), 0.0, double{FLT_MAX}));
        if (member(factors, kColorTexture) != nullptr) {
            const json& info = objectMember(factors, kColorTexture, where);
            material.baseColorTexture = m_textures.use(requiredIndex(info, "index", where),
                                                       TextureContent::color, alphaUseOf(material));
            asked.baseColor = uvSourceOf(info);
        }
        if (!material.unlit) {
            material.metallicRoughness =
                MetallicRoughness{.metallic = shareMember(factors, "metallicFactor", where),
                                  .roughness = shareMember(factors, "roughnessFactor", where)};
            material.detail = ground == Ground::solidAlone ? emissionOnly(source, where, asked)
                                                           : detailOf(source, where, asked);
        } else {
            material.metallicRoughness.reset();
        }
        use.uv = place(asked, material.detail, where);
        material.layer = layerOf(source, where, m_sources.notes).value_or(0.0f);
    }
    if (ground != Ground::surface) {
        showOnSolid(ground, material, use.uv);
    }
    use.index = static_cast<std::uint32_t>(m_scene.materials.size());
    m_scene.materials.push_back(std::move(material));
    return use;
}

MaterialDetail MaterialImporter::emissionOnly(const json& material, const std::string& where,
                                              AskedPlaces& asked) {
    MaterialDetail detail;
    detail.emission = emissionOf(material, where);
    if (detail.emission != glm::vec3(0.0f)) {
        detail.emissive = textureOf(material, &MaterialDetail::emissive, TextureContent::color, where, asked);
    }
    return detail;
}

MaterialDetail MaterialImporter::detailOf(const json& material, const std::string& where,
                                          AskedPlaces& asked) {
    MaterialDetail detail;
    const json& factors = objectMember(material, "pbrMetallicRoughness", where);
    detail.metallicRoughness =
        textureOf(factors, &MaterialDetail::metallicRoughness, TextureContent::data, where, asked);
    detail.normal = textureOf(material, &MaterialDetail::normal, TextureContent::data, where, asked);
    detail.occlusion = textureOf(material, &MaterialDetail::occlusion, TextureContent::data, where, asked);
    const MaterialDetail emitted = emissionOnly(material, where, asked);
    detail.emission = emitted.emission;
    detail.emissive = emitted.emissive;
    if (detail.normal) {
        const double scale =
            numberMember(objectMember(material, "normalTexture", where), "scale", where).value_or(1.0);
        detail.normalScale =
            static_cast<float>(std::clamp(scale, -double{kMaxNormalScale}, double{kMaxNormalScale}));
    }
    if (detail.occlusion) {
        detail.occlusionStrength =
            shareMember(objectMember(material, "occlusionTexture", where), "strength", where);
    }
    return detail;
}

std::optional<TextureUse> MaterialImporter::textureOf(const json& object,
                                                      std::optional<TextureUse> MaterialDetail::*use,
                                                      TextureContent content, const std::string& where,
                                                      AskedPlaces& asked) {
    const char* key = keyOf(use);
    if (member(object, key) == nullptr) {
        return {};
    }
    const json& info = objectMember(object, key, where);
    const std::optional<std::uint32_t> texture = m_textures.use(requiredIndex(info, "index", where), content);
    if (!texture) {
        return {};
    }
    asked.detail.emplace_back(use, uvSourceOf(info));
    return TextureUse{.texture = *texture};
}

UvPlaces MaterialImporter::place(const AskedPlaces& asked, MaterialDetail& detail, const std::string& where) {
    std::vector<UvSource> sources;
    if (asked.baseColor) {
        sources.push_back(*asked.baseColor);
    }
    const UvSource* normal = nullptr;
    for (const auto& [use, source] : asked.detail) {
        sources.push_back(source);
        normal = use == &MaterialDetail::normal ? &source : normal;
    }
    UvPlaces places = choosePlaces(sources, normal);
    for (const auto& [use, source] : asked.detail) {
        const std::optional<TextureUse> at =
            useAt(places, source, &source == normal ? Kept::tangents : Kept::nothing);
        if (!at) {
            m_sources.notes.add(
                fmt::format("{} is drawn where another texture is: no place of its vertices leads to its own",
                            keyOf(use)),
                where);
        }
        TextureUse placed = at.value_or(TextureUse{.second = true});
        placed.texture = (detail.*use)->texture;
        detail.*use = placed;
    }
    if (detail.normal) {
        places.tangents = detail.normal->second ? UvPlaces::Tangents::second : UvPlaces::Tangents::first;
    }
    return places;
}

} // namespace cdr::scene::gltf
