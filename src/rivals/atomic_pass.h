#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>

#include <rivals/key_scale.h>
#include <rivals/rival.h>
#include <rivals/visibility_pass.h>

namespace cdr::rivals {

/// A Rival: fragments take the least key of their pixel by atomics, into buffers.
class AtomicPass final : public VisibilityPass {
  public:
    /// base::InputError that names the features which the device lacks. base::RunError where a buffer of the picture is
    /// larger than the device's.
    AtomicPass(const gpu::Device& device, const Rival& rival, vk::Extent2D extent);

    void record(vk::CommandBuffer commands, const FrameDraws& draws) override;
    void recordReadback(vk::CommandBuffer commands) override;
    FramePixels fetch(const render::FrameView& view) const override;

  private:
    bool hasIdPass() const { return m_rival.key != Key::log40; }
    gpu::Pipeline makePipeline(const gpu::Device& device, const char* name, const gpu::Spirv& fragment,
                               std::uint32_t depthUse) const;
    void clear(vk::CommandBuffer commands) const;
    void beginScope(vk::CommandBuffer commands, vk::AttachmentLoadOp load) const;

    Rival m_rival;
    vk::Extent2D m_extent;
    vk::Format m_depthFormat; ///< undefined without a prepass, as Vulkan wants it of pipelines
    gpu::Buffer m_keys;
    gpu::Buffer m_ids; ///< this and the next are empty without a second pass
    gpu::Buffer m_idsOnHost;
    gpu::Buffer m_keysOnHost;
    gpu::Image m_depth; ///< empty without a prepass
    gpu::SetLayout m_setLayout;
    gpu::DescriptorSet m_set;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_prepass;
    gpu::Pipeline m_nearest;
    gpu::Pipeline m_whose;
};

} // namespace cdr::rivals
