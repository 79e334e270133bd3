#include <cdr/gpu/commands.h>
#include <cdr/shaders/rivals.h>

#include <rivals/depth_test_pass.h>

#include <limits>

namespace cdr::rivals {

namespace {

using PipelineStage = vk::PipelineStageFlagBits2;
using Access = vk::AccessFlagBits2;

/// The bits of the distance beyond the anchor, and the id word.
constexpr auto kSurfaceFormat = vk::Format::eR32G32Uint;

struct SurfacePixel {
    float ahead;
    std::uint32_t id;
};
static_assert(sizeof(SurfacePixel) == 8);

constexpr auto kTestStages = PipelineStage::eEarlyFragmentTests | PipelineStage::eLateFragmentTests;
constexpr auto kTestAccess = Access::eDepthStencilAttachmentRead | Access::eDepthStencilAttachmentWrite;

} // namespace

DepthTestPass::DepthTestPass(const gpu::Device& device, const depth::Technique& technique,
                             vk::Extent2D extent)
    : m_mapping(technique.mapping),
      m_surfaces(device,
                 {.extent = extent,
                  .format = kSurfaceFormat,
                  .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferSrc},
                 "contender surfaces"),
      m_depth(device,
              {.extent = extent,
               .format = vk::Format(device.depthFormat(technique.format)),
               .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment,
               .aspect = vk::ImageAspectFlagBits::eDepth},
              "contender depth"),
      m_readback(device, extent, sizeof(SurfacePixel), "contender readback"),
      m_layout(gpu::makePipelineLayout(device, {{}, {FrameDraws::pushRange()}}, "contender layout")),
      m_compact(makePipeline(device, render::Span::compact)),
      m_wide(makePipeline(device, render::Span::wide)) {}

gpu::Pipeline DepthTestPass::makePipeline(const gpu::Device& device, render::Span span) const {
    const bool isWide = span == render::Span::wide;
    const std::uint32_t form = render::depthFormOf(m_mapping, span);
    return gpu::makeGraphicsPipeline(
        device, {.name = isWide ? "contender, wide" : "contender",
                 .vertexSpirv = kRivalViewVert,
                 .fragmentSpirv = form == shaders::kDepthFormLogFragment ? gpu::Spirv(kRivalDepthWrittenFrag)
                                                                         : gpu::Spirv(kRivalDepthTestFrag),
                 .constants = {form, 0u, 0u, isWide ? 1u : 0u, shaders::kDepthDecides},
                 .layout = m_layout,
                 .bindings = FrameDraws::bindings(),
                 .attributes = FrameDraws::attributes(),
                 .colorFormats = {kSurfaceFormat},
                 .depthFormat = m_depth.options().format,
                 .depthCompare = render::depthCompareOf(m_mapping)});
}

vk::ClearDepthStencilValue DepthTestPass::clearDepth() const {
    return {.depth = depth::isReversed(m_mapping) ? 0.0f : 1.0f};
}

void DepthTestPass::record(vk::CommandBuffer commands, const FrameDraws& draws) {
    gpu::pipelineBarrier(
        commands,
        {gpu::imageBarrier(m_surfaces.handle(), vk::ImageAspectFlagBits::eColor,
                           {PipelineStage::eCopy | PipelineStage::eColorAttachmentOutput,
                            Access::eColorAttachmentWrite, vk::ImageLayout::eUndefined},
                           {PipelineStage::eColorAttachmentOutput, Access::eColorAttachmentWrite,
                            vk::ImageLayout::eColorAttachmentOptimal}),
         gpu::imageBarrier(m_depth.handle(), vk::ImageAspectFlagBits::eDepth,
                           {kTestStages, Access::eDepthStencilAttachmentWrite, vk::ImageLayout::eUndefined},
                           {kTestStages, kTestAccess, vk::ImageLayout::eDepthAttachmentOptimal})});
    const vk::RenderingAttachmentInfo color{.imageView = m_surfaces.view(),
                                            .imageLayout = vk::ImageLayout::eColorAttachmentOptimal,
                                            .loadOp = vk::AttachmentLoadOp::eClear,
                                            .storeOp = vk::AttachmentStoreOp::eStore};
    const vk::RenderingAttachmentInfo depth{.imageView = m_depth.view(),
                                            .imageLayout = vk::ImageLayout::eDepthAttachmentOptimal,
                                            .loadOp = vk::AttachmentLoadOp::eClear,
                                            .storeOp = vk::AttachmentStoreOp::eDontCare,
                                            .clearValue = clearDepth()};
    const vk::Rect2D area{{0, 0}, draws.extent()};
    commands.beginRendering({.renderArea = area,
                             .layerCount = 1,
                             .colorAttachmentCount = 1,
                             .pColorAttachments = &color,
                             .pDepthAttachment = &depth});
    draws.begin(commands);
    const std::size_t cascades = draws.view().cascades.size();
    for (std::size_t i = cascades; i-- > 0;) { // far to near, so that nearer cascades draw over
        if (i + 1 < cascades) {
            const vk::ClearAttachment clear{.aspectMask = vk::ImageAspectFlagBits::eDepth,
                                            .clearValue = clearDepth()};
            commands.clearAttachments(clear, vk::ClearRect{.rect = area, .layerCount = 1});
        }
        draws.record(commands, i, {.layout = *m_layout, .compact = *m_compact, .wide = *m_wide});
    }
    commands.endRendering();
}

void DepthTestPass::recordReadback(vk::CommandBuffer commands) {
    gpu::pipelineBarrier(
        commands, {gpu::imageBarrier(
                      m_surfaces.handle(), vk::ImageAspectFlagBits::eColor,
                      {PipelineStage::eColorAttachmentOutput, Access::eColorAttachmentWrite,
                       vk::ImageLayout::eColorAttachmentOptimal},
                      {PipelineStage::eCopy, Access::eTransferRead, vk::ImageLayout::eTransferSrcOptimal})});
    m_readback.record(commands, m_surfaces);
}

FramePixels DepthTestPass::fetch(const render::FrameView& view) const {
    const image::Raster<SurfacePixel> pixels = m_readback.fetch<SurfacePixel>();
    FramePixels found{.ids = image::ImageU32(pixels.width, pixels.height),
                      .distanceView = image::Raster<double>(pixels.width, pixels.height,
                                                            std::numeric_limits<double>::infinity())};
    const std::vector<double> anchorsView = view.anchorsView();
    for (std::size_t i = 0; i < pixels.pixels.size(); ++i) {
        const SurfacePixel& pixel = pixels.pixels[i];
        if (pixel.id != 0) {
            const std::size_t cascade = (pixel.id >> shaders::kIdBits) & shaders::kCascadeMask;
            found.ids.pixels[i] = pixel.id & shaders::kIdMask;
            found.distanceView.pixels[i] = anchorsView.at(cascade) + static_cast<double>(pixel.ahead);
        }
    }
    return found;
}

} // namespace cdr::rivals
