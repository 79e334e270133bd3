#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>
#include <cdr/render/shadows/slice_depth.h>

#include <cstddef>
#include <span>

namespace cdr::render {

/// Asks the device which slices have a pixel. Commands that only pixels of a slice need are skipped if it has none, though the
/// CPU does not know that when it records them.
class SeenSlices {
  public:
    /// @param device that has conditional rendering.
    explicit SeenSlices(const gpu::Device& device);

    /// One frame slot's.
    struct Slot {
        vk::UniqueQueryPool queries;
        gpu::Buffer counts; ///< of pixels, for each slice; more than 0 where there are some
    };
    Slot makeSlot() const;

    /// @param slices all of the frame. @param depth SliceDepth::image(), as an attachment.
    void record(vk::CommandBuffer primary, const Slot& slot, std::span<const SlicePixels> slices,
                const gpu::Image& depth) const;
    /// What is recorded from here to end() is skipped if the slice has no pixel. After record().
    static void begin(vk::CommandBuffer primary, const Slot& slot, std::size_t slice);
    static void end(vk::CommandBuffer primary);

  private:
    const gpu::Device& m_device;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_pipeline;
};

} // namespace cdr::render
