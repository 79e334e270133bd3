#pragma once

#include "document.h"
#include "files.h"
#include "mesh.h"
#include "notes.h"

#include <cdr/scene/scene.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace cdr::scene::gltf {

/// What the importer modules share; all but the scene is read.
struct Sources {
    const Document& document;
    const Buffers& buffers;
    Files& files;
    Notes& notes;
};

/// Imports textures into a scene when they are first used, each picture and wrapping once.
class TextureImporter {
  public:
    TextureImporter(const Sources& sources, Scene& scene);

    /// Index into Scene::textures of a glTF texture; nothing when only an extension supplies its picture.
    std::optional<std::uint32_t> use(int index);

    /// What a glTF metallic-roughness texture holds on average over its texels, each in [0, 1]: metallic
    /// (blue) and roughness (green). Nothing when only an extension supplies its picture.
    std::optional<glm::dvec2> meanMetallicRoughness(int index);

  private:
    /// The texture's image; nothing, with a note, when only an extension supplies it.
    std::optional<int> imageOf(int index);
    Texture import(int imageIndex);

    Sources m_sources;
    Scene& m_scene;
    std::map<std::tuple<int, bool, bool>, std::uint32_t> m_imported; ///< by image and repeat flags
    std::map<int, glm::dvec2> m_means;                               ///< by image
    std::uint64_t m_pixels = 0;
};

/// A glTF material in the scene, and what its primitives must know of it.
struct MaterialUse {
    std::uint32_t index = 0; ///< into Scene::materials
    UvSource uv;
};

/// Imports materials into a scene when they are first used, each once.
class MaterialImporter {
  public:
    MaterialImporter(const Sources& sources, Scene& scene);

    /// A glTF material, or for -1 glTF's default one.
    const MaterialUse& use(int material);

  private:
    MaterialUse import(int index);
    Shine shineOf(const nlohmann::json& factors, const std::string& where);

    Sources m_sources;
    Scene& m_scene;
    TextureImporter m_textures;
    std::map<int, MaterialUse> m_imported;
};

} // namespace cdr::scene::gltf
