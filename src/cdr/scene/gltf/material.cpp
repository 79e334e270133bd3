#include "material.h"

#include "checks.h"
#include "json.h"
#include "layer.h"

#include <algorithm>
#include <vector>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr const char* kColorTexture = "baseColorTexture";
constexpr const char* kShineTexture = "metallicRoughnessTexture";

AlphaMode alphaMode(const json& material, const std::string& where) {
    const std::string mode = stringMember(material, "alphaMode").value_or("OPAQUE");
    if (mode == "OPAQUE") {
        return AlphaMode::opaque;
    }
    if (mode == "MASK") {
        return AlphaMode::mask;
    }
    if (mode == "BLEND") {
        return AlphaMode::blend;
    }
    refuse("{}: alpha mode '{}' does not exist", where, oneLine(mode));
}

void noteUnused(const json& material, const std::string& where, Notes& notes) {
    const auto emissive = numbersMember(material, "emissiveFactor", 3, where);
    if (emissive && *emissive != std::vector<double>{0.0, 0.0, 0.0}) {
        notes.add("emissive factors are not drawn", where);
    }
    for (const char* what : {"normal", "occlusion", "emissive"}) {
        if (member(material, fmt::format("{}Texture", what).c_str()) != nullptr) {
            notes.add(fmt::format("{} textures are not used", what), where);
        }
    }
}

} // namespace

MaterialImporter::MaterialImporter(const Sources& sources, Scene& scene)
    : m_sources(sources),
      m_scene(scene),
      m_textures(sources, scene) {}

const MaterialUse& MaterialImporter::use(int material) {
    const auto found = m_imported.find(material);
    return found != m_imported.end() ? found->second
                                     : m_imported.emplace(material, import(material)).first->second;
}

MaterialUse MaterialImporter::import(int index) {
    MaterialUse use;
    Material material;
    material.name = "default";
    material.shine = Shine{}; // glTF's defaults
    if (index >= 0) {
        const json& source = itemAt(m_sources.document.root, "materials", index, "material");
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
        material.alphaCutoff =
            static_cast<float>(std::max(numberMember(source, "alphaCutoff", where).value_or(0.5), 0.0));
        if (member(factors, kColorTexture) != nullptr) {
            const json& info = objectMember(factors, kColorTexture, where);
            material.baseColorTexture = m_textures.use(requiredIndex(info, "index", where));
            use.uv = uvSourceOf(info);
        }
        material.shine = material.unlit ? std::nullopt : std::optional(shineOf(factors, where));
        material.layer = layerOf(source, where, m_sources.notes).value_or(0.0f);
        noteUnused(source, where, m_sources.notes);
    }
    use.index = static_cast<std::uint32_t>(m_scene.materials.size());
    m_scene.materials.push_back(std::move(material));
    return use;
}

Shine MaterialImporter::shineOf(const json& factors, const std::string& where) {
    glm::dvec2 shine(numberMember(factors, "metallicFactor", where).value_or(1.0),
                     numberMember(factors, "roughnessFactor", where).value_or(1.0));
    shine = glm::clamp(shine, 0.0, 1.0);
    if (member(factors, kShineTexture) != nullptr) {
        const json& info = objectMember(factors, kShineTexture, where);
        if (const auto mean = m_textures.meanMetallicRoughness(requiredIndex(info, "index", where))) {
            shine *= *mean;
            m_sources.notes.add("metallic-roughness textures are drawn as their mean", where);
        }
    }
    return {.metallic = static_cast<float>(shine.x), .roughness = static_cast<float>(shine.y)};
}

} // namespace cdr::scene::gltf
