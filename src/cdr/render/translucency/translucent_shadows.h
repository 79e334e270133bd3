#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/render/drawn_scene.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/shadows/caster_draws.h>
#include <cdr/render/shadows/receiver_slices.h>
#include <cdr/render/shadows/shadow_map.h>
#include <cdr/render/shadows/shadows.h>
#include <cdr/shaders/translucent_shared.h>
#include <cdr/visibility/cull.h>

#include <cstdint>
#include <span>
#include <vector>

namespace cdr::render {

/// The shadow maps that translucent fragments look up themselves: a pixel has many, so there is no mask of them. Surfaces are
/// drawn slice by slice, and the maps of all lights of one slice lie in one image. Owned by one frame slot.
class TranslucentShadows {
  public:
    /// What the scene refers to must outlive this.
    TranslucentShadows(const gpu::Device& device, const DrawnScene& scene, const Shadows& options);

    /// Lays maps around translucent surfaces; the slot's last frame must have finished. base::RunError
    /// when they need more memory than there is.
    /// @param seen the visible translucent instances.
    void prepare(const FrameView& view, const visibility::VisibleList& seen, std::uint32_t subPixelBits,
                 platform::WorkerPool& workers);
    /// Points the set's bindings from `first` on at the map's two images and at the receivers. After each prepare().
    void bind(const gpu::DescriptorSet& set, std::uint32_t first, vk::Sampler sampler) const;

    /// Half-open ranges of view distances, nearest first, that hold each distance once. At least one.
    std::span<const shaders::TranslucentSlice> slices() const { return m_slices; }
    /// Draws a slice's maps and makes them ready to be read. Outside a rendering scope.
    void recordMaps(vk::CommandBuffer primary, const shaders::TranslucentSlice& slice) const;

    std::size_t maps() const { return m_views.size(); }
    std::size_t casters() const { return m_casters.draws(); }

  private:
    /// Of a side of a map, so that those of each slice fit into the image.
    std::uint32_t maxTexels(std::span<const ReceiverSlice> slices, const FrameView& view) const;
    void placeMaps();

    const gpu::Device& m_device;
    DrawnScene m_scene;
    Shadows m_options;
    CasterDraws m_casters;
    ShadowMap m_map; ///< of one slice
    gpu::Buffer m_receivers;
    std::vector<LightView> m_views;      ///< slice by slice
    std::vector<vk::Offset2D> m_corners; ///< of each view's map
    std::vector<shaders::TranslucentSlice> m_slices;
};

} // namespace cdr::render
