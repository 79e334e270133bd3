#pragma once

#include <cdr/depth/mapping.h>
#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/shading/anchor_form.h>
#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/shadows/receiver_slices.h>
#include <cdr/render/shadows/shadows.h>
#include <cdr/shaders/shadows_shared.h>

#include <cstdint>
#include <span>
#include <vector>

namespace cdr::render {

/// A depth image that says which slice each pixel's surface is in. A pass that tests for equal depth before it shades then
/// shades the pixels of its slice alone, of however many slices there are.
class SliceDepth {
  public:
    /// @param gbuffer or the visibility buffer.
    /// @param bindings of the set that it reads; the first are those of seen.glsl.
    SliceDepth(const gpu::Device& device, const gpu::Image& gbuffer,
               const std::vector<vk::DescriptorType>& bindings, depth::Mapping mapping);

    /// Reads the G-buffer in the shader read layout. Leaves image() a depth attachment.
    /// @param cascades of the frame.
    void record(vk::CommandBuffer primary, vk::DescriptorSet set, const shaders::SlicePush& push,
                std::size_t cascades) const;
    const gpu::Image& image() const { return m_depth; }
    static constexpr auto kFormat = vk::Format::eD16Unorm; ///< an attachment on every device

    static std::uint64_t predictBytes(const gpu::Device& device, vk::Extent2D extent);

  private:
    ByCascades<FullscreenPass> m_passes;
    gpu::Image m_depth;
};

/// Where a slice's pixels are.
struct SlicePixels {
    float depth = 0.0f; ///< what SliceDepth holds there, and nowhere else
    vk::Rect2D area{};  ///< of the picture; there are none beside it
};

/// The ends of slices, for shaders.
/// @param slices all of a frame, nearest first. @param method that they were made for.
shaders::SlicePush slicePush(std::span<const ReceiverSlice> slices, ShadowMethod method);
/// What SliceDepth holds where a surface is in that slice.
float sliceDepth(std::span<const ReceiverSlice> slices, std::size_t slice, ShadowMethod method);

} // namespace cdr::render
