#pragma once

#include <cdr/depth/occupancy.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/frame_view.h>
#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/shading/shading_pass.h>
#include <cdr/render/shadows/caster_draws.h>
#include <cdr/render/shadows/seen_slices.h>
#include <cdr/render/shadows/shadow_map.h>
#include <cdr/render/shadows/shadows.h>
#include <cdr/render/shadows/slice_depth.h>
#include <cdr/visibility/cull_cells.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cdr::render {

/// Finds which surfaces lights reach. The distances at which something is seen are cut into slices. Each light sees each
/// slice through a map of its own, one map at a time. So surfaces beyond 10^6 units get the same shadows as near ones, and
/// memory does not grow.
class ShadowPass {
  public:
    /// @param gbuffer or the visibility buffer.
    ShadowPass(const gpu::Device& device, const DrawnScene& scene, const gpu::Image& gbuffer,
               const Shadows& options, depth::Mapping mapping);
    /// One frame slot's.
    struct Slot {
        PassInputs inputs;
        CasterDraws casters;
        shaders::SlicePush slices{};
        std::size_t cascades = 0;
        std::optional<SeenSlices::Slot> seen{}; ///< where the device has conditional rendering
        std::vector<SlicePixels> pixels{};      ///< of each slice
        std::vector<LightView> views{};
        std::vector<shaders::ReceiverPush> receivers{}; ///< of each view
    };
    Slot makeSlot(const ShadingInputs& shading) const;

    /// What receives shadows.
    struct Seen {
        const visibility::VisibleCells& visible;     ///< of the scene
        std::span<const depth::Interval> occupied{}; ///< view distances of what a host draws
    };
    void prepare(Slot& slot, const FrameView& view, const Seen& seen, std::uint32_t subPixelBits,
                 platform::WorkerPool& workers) const;
    /// Reads the G-buffer in the shader read layout, and leaves mask() in it.
    void record(vk::CommandBuffer primary, const Slot& slot) const;

    /// A channel for each of scene::shadowLights(): 1 where it reaches a surface, else 0.
    const gpu::Image& mask() const { return m_mask; }
    static std::uint64_t predictBytes(const gpu::Device& device, vk::Extent2D extent, const Shadows& options);

  private:
    void recordView(vk::CommandBuffer primary, const Slot& slot, std::size_t index) const;
    std::vector<LightView> viewsOf(const scene::PointLight& light, const ReceiverSlice& slice,
                                   const FrameView& view) const;

    const gpu::Device& m_device;
    DrawnScene m_scene;
    const gpu::Image& m_gbuffer;
    Shadows m_options;
    ShadowMap m_map;
    gpu::Image m_mask;
    ByCascades<FullscreenPass> m_receivers;
    SliceDepth m_slices;
    std::optional<SeenSlices> m_seen; ///< as in Slot
};

} // namespace cdr::render
