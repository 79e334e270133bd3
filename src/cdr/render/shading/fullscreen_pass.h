#pragma once

#include <cdr/gpu/memory.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/gpu/vulkan_hpp.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cdr::render {

/// What a FullscreenPass is made from.
struct FullscreenPassOptions {
    std::string name;
    /// Covers the picture with one triangle; empty: and does nothing else.
    gpu::Spirv vertexSpirv{};
    gpu::Spirv fragmentSpirv{};
    std::vector<vk::DescriptorType>
        bindings; ///< of set 0, for both stages: combined image samplers, storage buffers and uniform texel buffers
    vk::Format format = vk::Format::eUndefined;
    vk::Format formatBeside = vk::Format::eUndefined; ///< of a second image that it writes too
    std::vector<std::uint32_t> constants{};           ///< specialisation constants 0, 1, ... of both stages
    std::uint32_t pushBytes = 0;                      ///< of push constants that the fragment shader reads
    gpu::Blend blend = gpu::Blend::none;
    vk::Format marks =
        vk::Format::eUndefined; ///< of a depth attachment with marks; with one, only marked pixels are drawn
    vk::Format depth =
        vk::Format::eUndefined; ///< of a depth attachment; with one, a draw shades pixels of its depth only
    /// Of a depth attachment whose every pixel is written, without colours: recordDepth().
    vk::Format writtenDepth = vk::Format::eUndefined;
    vk::Filter filter = vk::Filter::eNearest; ///< of images that are not fetched texel by texel
};

/// The descriptors a FullscreenPass reads in one draw.
class PassInputs : public gpu::DescriptorSet {
  public:
    PassInputs() = default;

    /// Points a binding at an image that will be in the shader read layout.
    void setImage(std::uint32_t binding, const gpu::Image& image) const;

  private:
    friend class FullscreenPass;
    PassInputs(const gpu::Device& device, const gpu::SetLayout& layout, vk::Sampler sampler)
        : DescriptorSet(device, layout),
          m_sampler(sampler) {}
    vk::Sampler m_sampler; ///< the pass' own
};

/// A pass whose fragment shader covers a whole picture.
class FullscreenPass {
  public:
    FullscreenPass(const gpu::Device& device, const FullscreenPassOptions& options);

    /// Inputs with nothing set; they must not outlive the pass.
    PassInputs makeInputs() const { return {m_device, m_setLayout, *m_sampler}; }
    /// With what most passes read first: an image at binding 0, a buffer at 1.
    PassInputs makeInputs(const gpu::Image& image, const gpu::Buffer& buffer) const;

    const gpu::SetLayout& setLayout() const { return m_setLayout; }

    /// One draw.
    struct Draw {
        vk::DescriptorSet set;
        std::span<const std::byte> push{}; ///< as many bytes as the options say
        float depth = 0.0f; ///< 0 to 1; that of the pixels to shade, where the options have a format of depth
        std::optional<vk::Rect2D> area{}; ///< of the picture, not empty; else all of it
    };
    /// What draws write, and what they are tested against. All images are in the layouts of attachments.
    struct Scope {
        const gpu::Image& into;
        vk::AttachmentLoadOp load = vk::AttachmentLoadOp::eDontCare;
        vk::ClearValue clear{};             ///< what vk::AttachmentLoadOp::eClear clears to
        const gpu::Image* marks = nullptr;  ///< null unless the options have their format
        const gpu::Image* depth = nullptr;  ///< likewise; it is not written
        const gpu::Image* beside = nullptr; ///< the second image, loaded and never cleared; likewise
    };
    /// One rendering scope that draws in order.
    void record(vk::CommandBuffer primary, std::span<const Draw> draws, const Scope& scope) const;
    /// The same with one draw that overwrites every pixel.
    void record(vk::CommandBuffer primary, const PassInputs& inputs, const gpu::Image& into) const;
    /// The same under a label. Takes the image over from whoever used it before and leaves it in shader read layout.
    void recordInto(vk::CommandBuffer primary, const char* label, const PassInputs& inputs,
                    const gpu::Image& into) const;
    /// One draw that overwrites the depth of every pixel. @param into a depth attachment
    void recordDepth(vk::CommandBuffer primary, const Draw& draw, vk::ImageView into,
                     vk::Extent2D extent) const;

  private:
    void recordDraw(vk::CommandBuffer primary, const Draw& draw, vk::Extent2D extent) const;
    void drawTriangle(vk::CommandBuffer primary, const Draw& draw) const;

    const gpu::Device& m_device;
    vk::UniqueSampler m_sampler;
    gpu::SetLayout m_setLayout;
    gpu::PipelineLayout m_layout;
    gpu::Pipeline m_pipeline;
};

} // namespace cdr::render
