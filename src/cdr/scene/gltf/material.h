#pragma once

#include "document.h"
#include "files.h"
#include "materials/uv_places.h"
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
    std::optional<std::uint32_t> use(int index, TextureContent content);

  private:
    /// The texture's image; nothing, with a note, when only an extension supplies it.
    std::optional<int> imageOf(int index);
    image::ImageRgba8 import(int imageIndex, std::string& name);

    /// Image, how it goes on along u and v, whether single texels show where large and where small, levels, what its
    /// channels are.
    using Key = std::tuple<int, int, int, bool, bool, TextureLevels, TextureContent>;

    Sources m_sources;
    Scene& m_scene;
    std::map<Key, std::uint32_t> m_imported;
    std::uint64_t m_pixels = 0;
};

/// A glTF material in the scene, and what its primitives must know of it.
struct MaterialUse {
    std::uint32_t index = 0; ///< into Scene::materials
    UvPlaces uv;
};

/// Whether a material names a texture beside its base colour's, so that vertices may need scene::VertexDetail. False for
/// one that does not exist.
bool mayHaveDetail(const nlohmann::json& root, int material);

/// Imports materials into a scene when they are first used, each once.
class MaterialImporter {
  public:
    MaterialImporter(const Sources& sources, Scene& scene);

    /// A glTF material, or for -1 glTF's default one.
    const MaterialUse& use(int material);

  private:
    MaterialUse import(int index);
    /// The textures that a lit material has beside its base colour's, and what it emits.
    MaterialDetail detailOf(const nlohmann::json& material, const std::string& where, UvPlaces& uv);
    /// A texture that a member names, and its UV; nothing where there is none.
    std::optional<TextureUse> textureOf(const nlohmann::json& object, const char* key, TextureContent content,
                                        const std::string& where, UvPlaces& uv);

    Sources m_sources;
    Scene& m_scene;
    TextureImporter m_textures;
    std::map<int, MaterialUse> m_imported;
};

} // namespace cdr::scene::gltf
