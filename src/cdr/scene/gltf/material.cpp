#include "material.h"

#include "checks.h"

#include <algorithm>

namespace cdr::scene::gltf {

namespace {

AlphaMode alphaMode(const tinygltf::Material& material) {
    if (material.alphaMode == "OPAQUE") {
        return AlphaMode::opaque;
    }
    if (material.alphaMode == "MASK") {
        return AlphaMode::mask;
    }
    if (material.alphaMode == "BLEND") {
        return AlphaMode::blend;
    }
    refuse("material '{}': alpha mode '{}' does not exist", oneLine(material.name),
           oneLine(material.alphaMode));
}

void noteUnused(const tinygltf::Material& material, Notes& notes) {
    const std::string where = fmt::format("material '{}'", oneLine(material.name));
    if (material.emissiveFactor != std::vector<double>{0.0, 0.0, 0.0}) {
        notes.add("emissive factors are not drawn", where);
    }
    const auto note = [&](int index, const char* what) {
        if (index >= 0) {
            notes.add(fmt::format("{} textures are not used", what), where);
        }
    };
    note(material.normalTexture.index, "normal");
    note(material.occlusionTexture.index, "occlusion");
    note(material.emissiveTexture.index, "emissive");
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
        const tinygltf::Material& source = itemAt(m_sources.document.model.materials, index, "material");
        material.name = source.name;
        const std::vector<double>& factor = source.pbrMetallicRoughness.baseColorFactor;
        for (int c = 0; c < 4; ++c) {
            // glTF bounds the factors so; a renderer of 8-bit albedo relies on it.
            material.baseColorFactor[c] =
                static_cast<float>(std::clamp(factor.at(static_cast<std::size_t>(c)), 0.0, 1.0));
        }
        material.doubleSided = source.doubleSided;
        material.unlit = source.extensions.contains("KHR_materials_unlit");
        material.alphaMode = alphaMode(source);
        material.alphaCutoff = static_cast<float>(std::max(source.alphaCutoff, 0.0));
        setTexture(material, use.uv, source.pbrMetallicRoughness.baseColorTexture);
        material.shine = material.unlit ? std::nullopt : std::optional(shineOf(source));
        noteUnused(source, m_sources.notes);
    }
    use.index = static_cast<std::uint32_t>(m_scene.materials.size());
    m_scene.materials.push_back(std::move(material));
    return use;
}

Shine MaterialImporter::shineOf(const tinygltf::Material& material) {
    const tinygltf::PbrMetallicRoughness& source = material.pbrMetallicRoughness;
    glm::dvec2 factors(source.metallicFactor, source.roughnessFactor);
    factors = glm::clamp(factors, 0.0, 1.0);
    if (source.metallicRoughnessTexture.index >= 0) {
        if (const auto mean = m_textures.meanMetallicRoughness(source.metallicRoughnessTexture.index)) {
            factors *= *mean;
            m_sources.notes.add("metallic-roughness textures are drawn as their mean",
                                fmt::format("material '{}'", oneLine(material.name)));
        }
    }
    return {.metallic = static_cast<float>(factors.x), .roughness = static_cast<float>(factors.y)};
}

void MaterialImporter::setTexture(Material& material, UvSource& uv, const tinygltf::TextureInfo& info) {
    if (info.index < 0) {
        return;
    }
    material.baseColorTexture = m_textures.use(info.index);
    uv = uvSourceOf(info);
}

} // namespace cdr::scene::gltf
