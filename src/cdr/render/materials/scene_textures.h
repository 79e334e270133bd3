#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/retired.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/scene/scene.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cdr::platform {
class WorkerPool;
}

namespace cdr::render {

/// A scene's textures on a device, and the descriptor sets by which draws read them.
class SceneTextures {
  public:
    /// @param threads that make smaller levels, at most; 0: one for each processor.
    SceneTextures(const gpu::Device& device, std::size_t threads);

    using Changed = std::optional<std::span<const std::uint32_t>>; ///< places; nothing: all may have changed

    /// Uploads what came, and what of those that were there changed.
    void follow(const scene::Scene& scene, const Changed& changed, gpu::Retired& retired);
    /// Makes the sets of materials with detail, of those that came or changed, of textures that are there. A texture that
    /// a material has stays as it is, so no other material has to be looked at.
    void followMaterials(const scene::Scene& scene, const Changed& changed, gpu::Retired& retired);

    /// Of baseColorSet().
    const gpu::SetLayout& baseColorLayout() const { return m_baseColorLayout; }
    /// Of detailSet(): four textures and a shaders::DetailRecord, as shaders/geometry/detail.glsl reads them.
    const gpu::SetLayout& detailLayout() const { return m_detailLayout; }
    /// A material's base colour texture; a white pixel for one without, so that every pipeline has a valid set.
    vk::DescriptorSet baseColorSet(const scene::Material& material) const;
    /// Null for a material without detail.
    vk::DescriptorSet detailSet(std::size_t material) const { return m_details[material].set; }

    /// Of all textures with their levels.
    static std::uint64_t predictBytes(const scene::Scene& scene);

  private:
    struct Uploaded {
        gpu::Image image;
        vk::UniqueSampler sampler;
        vk::UniqueDescriptorPool pool;
        vk::DescriptorSet set;
    };
    struct Detail {
        gpu::Buffer record;
        vk::UniqueDescriptorPool pool;
        vk::DescriptorSet set;
    };
    /// @param workers make its levels; null: the calling thread.
    Uploaded upload(const scene::Texture& texture, platform::WorkerPool* workers) const;
    Detail makeDetail(const scene::Material& material) const;

    const gpu::Device& m_device;
    std::size_t m_threads;
    gpu::SetLayout m_baseColorLayout;
    gpu::SetLayout m_detailLayout;
    Uploaded m_white;
    std::vector<Uploaded> m_textures; ///< the scene's
    std::vector<Detail> m_details;    ///< by material
};

/// Which parts of a material's detail its pipelines read: a sum of shaders::kDetailMetallicRoughness and its siblings; 0 for a
/// material without detail.
std::uint32_t detailPartsOf(const scene::Material& material);

} // namespace cdr::render
