#include <cdr/gpu/commands.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/rivals.h>

#include <rivals/depth_test_pass.h>

#include <limits>

namespace cdr::rivals {

namespace {

/// The bits of the distance beyond the anchor, and the id word.
constexpr auto kSurfaceFormat = vk::Format::eR32G32Uint;

struct SurfacePixel {
    float ahead;
    std::uint32_t id;
};
static_assert(sizeof(SurfacePixel) == 8);

} // namespace

DepthTestPass::DepthTestPass(const gpu::Device& device, const depth::Technique& technique,
                             vk::Extent2D extent)
    : m_mapping(technique.mapping),
      m_surfaces(render::makeGBuffer(device, extent, "contender surfaces", kSurfaceFormat)),
      m_depth(render::makeDepthBuffer(device, extent, technique.format, "contender depth")),
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

void DepthTestPass::record(vk::CommandBuffer commands, const FrameDraws& draws) {
    const render::GBufferScope scope{
        .gbuffer = m_surfaces, .depth = m_depth, .reversedDepth = depth::isReversed(m_mapping)};
    render::beginGBuffer(commands, scope);
    render::beginGBufferScope(commands, scope, {});
    const vk::ClearAttachment clear{
        .aspectMask = vk::ImageAspectFlagBits::eDepth,
        .clearValue = vk::ClearDepthStencilValue{.depth = scope.reversedDepth ? 0.0f : 1.0f}};
    const vk::ClearRect area{.rect = {{0, 0}, draws.extent()}, .layerCount = 1};
    draws.begin(commands);
    const std::size_t cascades = draws.view().cascades.size();
    for (std::size_t i = cascades; i-- > 0;) { // far to near, so that nearer cascades draw over
        if (i + 1 < cascades) {
            commands.clearAttachments(clear, area);
        }
        draws.record(commands, i, {.layout = *m_layout, .compact = *m_compact, .wide = *m_wide});
    }
    commands.endRendering();
}

void DepthTestPass::recordReadback(vk::CommandBuffer commands) {
    gpu::pipelineBarrier(commands, {render::copyBarrier(m_surfaces, render::kDrawnColor)});
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
