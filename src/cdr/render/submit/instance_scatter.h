#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/shaders/binning_shared.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace cdr::render {

/// Puts what changed of instances where they stand in the buffers of a gpu-driven scene (shaders/binning/scatter.comp). A
/// graphics card takes some microseconds for each region of a copy, and changed instances may stand anywhere.
class InstanceScatter {
  public:
    explicit InstanceScatter(const gpu::Device& device);

    /// One frame slot's changes, and where they go.
    struct Slot {
        gpu::DescriptorSet set;
        gpu::Buffer changes{};
        std::uint32_t count = 0;
    };
    Slot makeSlot() const { return {.set = {m_device, m_setLayout}}; }

    /// How many changes a frame may have.
    std::size_t most() const;

    struct Changes {
        std::span<const std::uint32_t> instances;         ///< ascending, most() at most
        std::span<const shaders::InstanceSphere> spheres; ///< of all instances
        std::span<const shaders::InstanceLook> looks;
    };
    struct Buffers {
        const gpu::Buffer& spheres;
        const gpu::Buffer& looks;
    };
    /// Writes changes for the device. The last frame that used the slot must have finished. base::RunError
    /// when the device's memory does not suffice.
    void stage(const Changes& changes, const Buffers& buffers, Slot& slot) const;
    /// Without barriers. Of a slot that has changes.
    void record(vk::CommandBuffer commands, const Slot& slot) const;

  private:
    const gpu::Device& m_device;
    gpu::SetLayout m_setLayout;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_pipeline;
};

} // namespace cdr::render
