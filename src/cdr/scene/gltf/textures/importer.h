#pragma once

#include "../bytes/read_progress.h"
#include "../sources.h"
#include "budget.h"
#include "picture_source.h"

#include <cdr/scene/gltf/gltf.h>
#include <cdr/scene/scene.h>

#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace cdr::scene::gltf {

/// What a material does with a texture's alpha, for its smaller levels.
struct AlphaUse {
    bool weighs = false;           ///< as Texture::alphaWeighs
    std::optional<float> cutoff{}; ///< as Texture::cutoff
};

/// Imports textures into a scene, each picture and way to read it once. Pictures are decoded last, and all at once.
class TextureImporter {
  public:
    TextureImporter(const Sources& sources, Scene& scene);

    /// Index into Scene::textures of a glTF texture; nothing when only an extension supplies its picture. It has no
    /// pixels yet.
    std::optional<std::uint32_t> use(int index, TextureContent content, const AlphaUse& alpha = {});

    /// Decodes what textures show. The first picture that is damaged, in the order of use(), is the one refused.
    /// Leaves out the largest levels of some, with a note, where GltfLimits::textureMemory asks for it.
    /// @param progress is told of pictures on the calling thread.
    void decode(const GltfLimits& limits, ReadProgress& progress);

  private:
    /// A picture, and which of the scene's textures show it.
    struct Shown {
        PictureSource source;
        std::vector<std::uint32_t> textures;
    };

    /// The texture's image; nothing, with a note, when only an extension supplies it.
    std::optional<int> imageOf(int index);
    Shown& shownOf(int image);
    /// By texture, how many of its largest levels are left out. Refuses what takes too much even so.
    std::vector<std::uint32_t> dropLevels(const std::optional<std::uint64_t>& bytes);
    /// Gives a picture to the textures that show it.
    void fill(const Shown& shown, const std::vector<std::uint32_t>& dropped);

    /// Image, wrapping along u and v, magnification and minification filter, levels, content of the channels, and both
    /// members of AlphaUse.
    using Key = std::tuple<int, WrapMode, WrapMode, Filter, Filter, TextureLevels, TextureContent, bool,
                           std::optional<float>>;

    Sources m_sources;
    Scene& m_scene;
    std::map<Key, std::uint32_t> m_imported;
    std::map<int, std::size_t> m_shownOf; ///< by image
    std::vector<Shown> m_shown;           ///< in the order of use()
    std::vector<TextureNeed> m_needs;     ///< by texture of the scene
};

} // namespace cdr::scene::gltf
