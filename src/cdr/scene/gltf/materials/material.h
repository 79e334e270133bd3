#pragma once

#include "../mesh.h"
#include "../solids/solids.h"
#include "../sources.h"
#include "../textures/importer.h"
#include "uv_places.h"

#include <cdr/scene/scene.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cdr::scene::gltf {

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

    /// A glTF material, or for -1 glTF's default one, as it is shown on a ground.
    const MaterialUse& use(int material, Ground ground);

    /// TextureImporter::decode(), once all materials are there.
    void decodeTextures(const GltfLimits& limits, ReadProgress& progress) {
        m_textures.decode(limits, progress);
    }

  private:
    MaterialUse import(int index, Ground ground);
    /// Where a material's textures want to be read.
    struct AskedPlaces {
        std::optional<UvSource> baseColor;
        std::vector<std::pair<std::optional<TextureUse> MaterialDetail::*, UvSource>> detail; ///< in order
    };
    /// The textures that a lit material has beside its base colour's, and what it emits. They are not placed yet.
    MaterialDetail detailOf(const nlohmann::json& material, const std::string& where, AskedPlaces& asked);
    /// What a material emits, and nothing else.
    MaterialDetail emissionOnly(const nlohmann::json& material, const std::string& where, AskedPlaces& asked);
    /// A texture that a member names; nothing where there is none.
    std::optional<TextureUse> textureOf(const nlohmann::json& object,
                                        std::optional<TextureUse> MaterialDetail::*use,
                                        TextureContent content, const std::string& where, AskedPlaces& asked);
    /// Chooses the places of vertices, and places the textures. A note names those that cannot be.
    UvPlaces place(const AskedPlaces& asked, MaterialDetail& detail, const std::string& where);

    Sources m_sources;
    Scene& m_scene;
    TextureImporter m_textures;
    std::map<std::pair<int, Ground>, MaterialUse> m_imported;
};

} // namespace cdr::scene::gltf
