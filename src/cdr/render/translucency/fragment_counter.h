#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/image/image.h>
#include <cdr/render/output/readback.h>

namespace cdr::render {

/// Counts the translucent fragments of each pixel that lie at or in front of its opaque surface. Each adds one
/// to an attachment. Exact up to 2048.
class FragmentCounter {
  public:
    FragmentCounter(const gpu::Device& device, vk::Extent2D extent);

    static constexpr vk::Format kFormat = vk::Format::eR16Sfloat;

    /// Clears it; afterwards it is an attachment. Outside a rendering scope.
    void begin(vk::CommandBuffer primary) const;
    /// As an attachment of a scope that keeps what earlier ones counted.
    vk::RenderingAttachmentInfo attachment() const;
    /// Lets a further scope follow one that ended.
    vk::ImageMemoryBarrier2 nextScope() const;
    /// Copies the counts to main memory; recordHostBarrier() must follow.
    void recordReadback(vk::CommandBuffer primary) const;
    image::ImageU32 fetch() const;

  private:
    gpu::Image m_image;
    Readback m_copy;
};

} // namespace cdr::render
