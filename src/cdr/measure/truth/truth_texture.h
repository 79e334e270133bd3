#pragma once

#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <deque>
#include <mutex>
#include <vector>

namespace cdr::measure {

/// How a place in a texture changes from a pixel to the next.
struct UvSteps {
    glm::dvec2 right{0.0};
    glm::dvec2 down{0.0};
};

/// A texture's value, linear, bilinear between texel centres unless it shows single texels; each texel of a colour is
/// linearised first.
glm::dvec4 sampleTexture(const scene::Texture& texture, const glm::dvec2& uv);

/// A scene's textures as pixels see them: where texels are smaller than pixels, by averages over squares of them, in
/// linear light. Which level that is follows from the longer of the two steps in texels, as the Vulkan specification
/// says. Drivers may take up to half a level less where steps run across texels. Threads may share it.
class TruthTextures {
  public:
    /// @param scene must outlive this and stay as it is.
    explicit TruthTextures(const scene::Scene& scene);

    /// Linear.
    /// @param texture index into Scene::textures; std::out_of_range where there is none.
    glm::dvec4 sample(std::uint32_t texture, const glm::dvec2& uv, const UvSteps& steps) const;

  private:
    /// A smaller level; its texels are linear.
    using Level = image::Raster<glm::vec4>;
    struct Filtered {
        const scene::Texture* texture = nullptr;
        std::once_flag once; ///< of `levels`, which are made when they are first read
        std::vector<Level> levels;
    };
    glm::dvec4 sampleLevel(const Filtered& filtered, std::size_t level, const glm::dvec2& uv) const;

    mutable std::deque<Filtered> m_textures;
};

} // namespace cdr::measure
