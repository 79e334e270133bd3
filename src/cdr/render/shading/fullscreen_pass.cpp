#include <cdr/gpu/commands.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/shading/fullscreen_pass.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/shading.h>

#include <array>

namespace cdr::render {

namespace {

constexpr auto kStage = vk::ShaderStageFlagBits::eFragment;
constexpr auto kSetStages = vk::ShaderStageFlagBits::eVertex | kStage;

std::vector<vk::PushConstantRange> pushRanges(std::uint32_t bytes) {
    return bytes == 0 ? std::vector<vk::PushConstantRange>{}
                      : std::vector<vk::PushConstantRange>{{.stageFlags = kStage, .size = bytes}};
}

bool writesDepth(const FullscreenPassOptions& options) {
    return options.writtenDepth != vk::Format::eUndefined;
}

std::vector<vk::Format> colorFormatsOf(const FullscreenPassOptions& options) {
    std::vector<vk::Format> formats{options.format, options.formatBeside};
    std::erase(formats, vk::Format::eUndefined);
    return formats;
}

/// One of the three at most is there.
vk::Format depthFormatOf(const FullscreenPassOptions& options) {
    if (writesDepth(options)) {
        return options.writtenDepth;
    }
    return options.depth != vk::Format::eUndefined ? options.depth : options.marks;
}

vk::ImageView viewOf(const gpu::Image* image) {
    return image != nullptr ? image->view() : vk::ImageView();
}

} // namespace

void PassInputs::setImage(std::uint32_t binding, const gpu::Image& image) const {
    DescriptorSet::setImage(binding, image.view(), m_sampler);
}

FullscreenPass::FullscreenPass(const gpu::Device& device, const FullscreenPassOptions& options)
    : m_device(device),
      m_sampler(vk::Device(device.handle())
                    .createSamplerUnique({.magFilter = options.filter,
                                          .minFilter = options.filter,
                                          .addressModeU = vk::SamplerAddressMode::eClampToEdge,
                                          .addressModeV = vk::SamplerAddressMode::eClampToEdge})),
      m_setLayout(gpu::makeSetLayout(device, {options.bindings, kSetStages}, options.name + " set")),
      m_layout(gpu::makePipelineLayout(device, {{m_setLayout}, pushRanges(options.pushBytes)},
                                       options.name + " layout")),
      m_pipeline(gpu::makeGraphicsPipeline(
          device,
          {.name = options.name,
           .vertexSpirv =
               options.vertexSpirv.words.empty() ? gpu::Spirv(kFullscreenVert) : options.vertexSpirv,
           .fragmentSpirv = options.fragmentSpirv,
           .constants = options.constants,
           .layout = m_layout,
           .colorFormats = colorFormatsOf(options),
           .depthFormat = depthFormatOf(options),
           .stencil = options.marks != vk::Format::eUndefined ? gpu::Stencil::testsMarks : gpu::Stencil::none,
           .writesDepth = writesDepth(options),
           .depthCompare = writesDepth(options) ? vk::CompareOp::eAlways : vk::CompareOp::eEqual,
           .blend = options.blend})) {}

PassInputs FullscreenPass::makeInputs(const gpu::Image& image, const gpu::Buffer& buffer) const {
    PassInputs inputs = makeInputs();
    inputs.setImage(0, image);
    inputs.setBuffer(1, buffer);
    return inputs;
}

void FullscreenPass::record(vk::CommandBuffer primary, std::span<const Draw> draws,
                            const Scope& scope) const {
    const std::array colors{colorAttachment(scope.into.view(), scope.load, scope.clear),
                            colorAttachment(viewOf(scope.beside), vk::AttachmentLoadOp::eLoad)};
    const vk::RenderingAttachmentInfo stencil{.imageView = viewOf(scope.marks),
                                              .imageLayout = vk::ImageLayout::eAttachmentOptimal,
                                              .loadOp = vk::AttachmentLoadOp::eLoad,
                                              .storeOp = vk::AttachmentStoreOp::eNone};
    const auto depth =
        depthAttachment(viewOf(scope.depth), vk::AttachmentLoadOp::eLoad, vk::AttachmentStoreOp::eNone);
    const vk::Extent2D extent = scope.into.options().extent;
    beginRendering(primary, extent, std::span(colors).first(scope.beside != nullptr ? 2 : 1),
                   scope.depth != nullptr ? &depth : nullptr, scope.marks != nullptr ? &stencil : nullptr);
    gpu::bindFullscreenPipeline(primary, *m_pipeline, extent);
    for (const Draw& draw : draws) {
        recordDraw(primary, draw, extent);
    }
    primary.endRendering();
}

void FullscreenPass::recordDraw(vk::CommandBuffer primary, const Draw& draw, vk::Extent2D extent) const {
    // The triangle lies at depth 0, which becomes the viewport's least.
    primary.setViewport(0, vk::Viewport{0.0f, 0.0f, static_cast<float>(extent.width),
                                        static_cast<float>(extent.height), draw.depth, draw.depth});
    primary.setScissor(0, draw.area.value_or(vk::Rect2D{{0, 0}, extent}));
    drawTriangle(primary, draw);
}

void FullscreenPass::drawTriangle(vk::CommandBuffer primary, const Draw& draw) const {
    primary.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *m_layout, 0, draw.set, {});
    if (!draw.push.empty()) {
        primary.pushConstants<std::byte>(*m_layout, kStage, 0, draw.push);
    }
    primary.draw(3, 1, 0, 0);
}

void FullscreenPass::record(vk::CommandBuffer primary, const PassInputs& inputs,
                            const gpu::Image& into) const {
    const Draw draw{.set = *inputs};
    record(primary, {&draw, 1}, {.into = into});
}

void FullscreenPass::recordInto(vk::CommandBuffer primary, const char* label, const PassInputs& inputs,
                                const gpu::Image& into) const {
    m_device.beginLabel(primary, label);
    gpu::pipelineBarrier(primary, {attachBarrier(into)});
    record(primary, inputs, into);
    gpu::pipelineBarrier(primary, {readBarrier(into)});
    m_device.endLabel(primary);
}

void FullscreenPass::recordDepth(vk::CommandBuffer primary, const Draw& draw, vk::ImageView into,
                                 vk::Extent2D extent) const {
    const auto depth = depthAttachment(into, vk::AttachmentLoadOp::eDontCare);
    beginRendering(primary, extent, {}, &depth);
    gpu::bindFullscreenPipeline(primary, *m_pipeline, extent);
    drawTriangle(primary, draw);
    primary.endRendering();
}

} // namespace cdr::render
