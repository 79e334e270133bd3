#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/retired.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/image/image.h>
#include <cdr/render/materials/texture_packing.h>
#include <cdr/scene/scene.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
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

    /// Forgets what changed and what is gone.
    void follow(const scene::Scene& scene, const Changed& changed, gpu::Retired& retired);
    /// Uploads the textures of materials that came or changed, and makes the sets of those with detail. A texture that a material
    /// has stays as it is, so no other material has to be looked at.
    void followMaterials(const scene::Scene& scene, const Changed& changed, gpu::Retired& retired);

    /// Of baseColorSet().
    const gpu::SetLayout& baseColorLayout() const { return m_baseColorLayout; }
    /// Of detailSet(): four textures and a shaders::DetailRecord, as shaders/geometry/detail.glsl reads them.
    const gpu::SetLayout& detailLayout() const { return m_detailLayout; }
    /// A material's base colour texture; a white pixel for one without, so that every pipeline has a valid set.
    vk::DescriptorSet baseColorSet(const scene::Scene& scene, std::size_t material) const;
    /// detailPartsOf() it, and whether it is drawn from packed textures.
    std::uint32_t detailParts(const scene::Scene& scene, std::size_t material) const;
    /// Null for a material without detail.
    vk::DescriptorSet detailSet(std::size_t material) const { return *m_details[material].set; }

    /// Of all textures that materials read, with their levels.
    static std::uint64_t predictBytes(const scene::Scene& scene);

  private:
    struct Uploaded {
        gpu::Image image;
        vk::Sampler sampler; ///< of m_samplers
        gpu::DescriptorSet set;
    };
    /// The textures of a material that isPackable().
    struct Packed {
        std::shared_ptr<const Uploaded> base;
        std::shared_ptr<const Uploaded> normal;
        std::shared_ptr<const Uploaded> emissive;
    };
    struct Detail {
        std::optional<Packed> packed; ///< nothing: each texture is read by itself
        gpu::Buffer record;
        gpu::DescriptorSet set;
    };
    /// Threads that make levels, started for large textures alone: starting them takes time too.
    struct Workers;
    struct Sampler {
        vk::SamplerCreateInfo info;
        vk::UniqueSampler made;
    };
    /// Textures of the same options share one: a device may have as few as 4,000.
    vk::Sampler samplerOf(const scene::Texture& texture);
    /// @param name for messages
    Uploaded upload(const scene::Texture& texture, const std::string& name,
                    std::span<const image::ImageRgba8> levels);
    void uploadTexturesOf(const scene::Scene& scene, const scene::Material& material, Workers& workers);
    std::shared_ptr<const Uploaded> uploadPair(const scene::Scene& scene, const PackedPair& pair,
                                               Workers& workers);
    Packed pack(const scene::Scene& scene, const scene::Material& material, Workers& workers);
    Detail makeDetail(const scene::Material& material, std::optional<Packed> packed) const;

    const gpu::Device& m_device;
    std::size_t m_threads;
    gpu::SetLayout m_baseColorLayout;
    gpu::SetLayout m_detailLayout;
    std::vector<Sampler> m_samplers; ///< each of other options; at most 108, so all are kept
    Uploaded m_white;
    std::vector<std::optional<Uploaded>>
        m_textures; ///< the scene's; nothing where no material reads it by itself
    std::map<PackedPair, std::weak_ptr<const Uploaded>> m_pairs; ///< of all materials, which may share them
    std::vector<Detail> m_details;                               ///< by material
};

/// Which parts of a material's detail its pipelines read: a sum of shaders::kDetailMetallicRoughness and its siblings; 0 for a
/// material without detail.
std::uint32_t detailPartsOf(const scene::Material& material);

} // namespace cdr::render
