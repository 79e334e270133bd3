#include <cdr/gpu/commands.h>
#include <cdr/render/shading/finish.h>
#include <cdr/render/shading/picture.h>
#include <cdr/render/targets/focus_layers.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/shading.h>
#include <cdr/shaders/targets.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace cdr::render {

namespace {

constexpr auto kImage = vk::DescriptorType::eCombinedImageSampler;
constexpr auto kBuffer = vk::DescriptorType::eStorageBuffer;

/// How the surfaces of a cascade fade where the next one has begun. They are whole through the first half of
/// what both draw, and gone at its end. So the soft rim of the farther layer stays hidden.
shaders::LayerFade fadeInto(const CascadeView& cascade, const CascadeView& next) {
    const double farView = cascade.clipRange.farView;
    const double shared = farView - next.clipRange.nearView;
    if (!(shared > 0.0)) {
        return {};
    }
    return {.beginAhead = static_cast<float>(farView - 0.5 * shared - cascade.terms.anchorView),
            .perUnit = static_cast<float>(2.0 / shared)};
}

bool drawsFog(const Effects& effects) {
    return effects.fog.visibility > 0.0;
}

vk::ClearValue clearTo(const glm::vec3& color) {
    return vk::ClearColorValue{std::array{color.r, color.g, color.b, 1.0f}};
}

/// Of shading.frag: layers have anchor planes and no marks, and a later step finishes their colours.
std::vector<std::uint32_t> lightConstants(const FocusLayersOptions& focus) {
    constexpr std::uint32_t kAnyLights = 0;
    const auto [finish, exposure] = finishLaterConstants();
    return {drawsFog(focus.effects) ? 1u : 0u,
            focus.metallicRoughness ? 1u : 0u,
            kAnyLights,
            1u,
            0u,
            finish,
            exposure,
            focus.sky ? 1u : 0u};
}

/// The options, once the memory for the merged G-buffer is known to be there.
const TargetsOptions& checked(const gpu::Device& device, const TargetsOptions& options) {
    gpu::requireDeviceBytes(
        device, gpu::predictBytes(device, colorOptions(options.extent, kGBufferFormat)),
        fmt::format("a merged G-buffer of {}x{}", options.extent.width, options.extent.height));
    return options;
}

} // namespace

FocusLayers::FocusLayers(const gpu::Device& device, const TargetsOptions& options, const gpu::Image& into,
                         const FocusLayersOptions& focus)
    : m_device(device),
      m_options(checked(device, options)),
      m_into(into),
      m_background(drawsFog(focus.effects) ? focus.effects.fog.color : focus.background),
      m_fades(focus.fades),
      m_merge(device, {.name = "merge scaled",
                       .fragmentSpirv = kMergeScaledFrag,
                       .bindings = {kImage},
                       .format = kGBufferFormat,
                       .pushBytes = sizeof(shaders::PictureSize)}),
      m_light(device, {.name = "shading of a layer",
                       .fragmentSpirv = kShadingLayerFrag,
                       .bindings = {kImage, kBuffer},
                       .format = kLitFormat,
                       .constants = lightConstants(focus),
                       .pushBytes = sizeof(shaders::LayerFade)}),
      m_compose(device, {.name = "compose layers",
                         .fragmentSpirv = kFocusComposeFrag,
                         .bindings = {kImage},
                         .format = into.options().format,
                         .pushBytes = sizeof(shaders::PictureSize),
                         .blend = gpu::Blend::over,
                         .filter = vk::Filter::eLinear}),
      m_merged(makeGBuffer(device, options.extent, "G-buffer")) {}

FocusLayers::Layer FocusLayers::makeLayer(vk::Extent2D extent, const std::string& name) const {
    Layer layer{.gbuffer = makeGBuffer(m_device, extent, name),
                .depth = makeDepthBuffer(m_device, extent, m_options.depthFormat, name + " depth"),
                .lit = {m_device, colorOptions(extent, kLitFormat), name + " lit"},
                .merged = m_merge.makeInputs(),
                .laid = m_compose.makeInputs()};
    layer.merged.setImage(0, layer.gbuffer);
    layer.laid.setImage(0, layer.lit);
    return layer;
}

FocusLayers::LayerKey FocusLayers::keyOf(const FrameView& view, std::size_t cascade) {
    const vk::Extent2D extent = view.cascades[cascade].extent;
    return {static_cast<std::uint32_t>(cascade), extent.width, extent.height};
}

void FocusLayers::provideLayers(const FrameView& view) {
    std::vector<std::size_t> missing;
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < view.cascades.size(); ++i) {
        if (!m_layers.contains(keyOf(view, i))) {
            missing.push_back(i);
            const vk::Extent2D extent = view.cascades[i].extent;
            bytes += predictLayerBytes(m_device, extent, m_options.depthFormat) +
                     gpu::predictBytes(m_device, colorOptions(extent, kLitFormat));
        }
    }
    if (missing.empty()) {
        return;
    }
    gpu::requireDeviceBytes(m_device, bytes, fmt::format("the layers of {} cascades", missing.size()));
    for (const std::size_t i : missing) {
        m_layers.try_emplace(keyOf(view, i), makeLayer(view.cascades[i].extent, fmt::format("layer {}", i)));
    }
}

void FocusLayers::record(CascadeCommands& commands, const FrameView& view) {
    provideLayers(view);
    const std::vector<CascadeView>& cascades = view.cascades;
    const std::vector<std::size_t> drawn = commands.drawnCascades(cascades.size());
    m_drawn.clear();
    std::transform(drawn.rbegin(), drawn.rend(), std::back_inserter(m_drawn), [&](std::size_t i) {
        const bool fades = m_fades && i + 1 < cascades.size();
        return Drawn{.layer = &m_layers.at(keyOf(view, i)),
                     .fade = fades ? fadeInto(cascades[i], cascades[i + 1]) : shaders::LayerFade{}};
    });
    std::vector<GBufferScope> scopes;
    for (const auto& [layer, fade] : m_drawn) {
        scopes.push_back(
            {.gbuffer = layer->gbuffer, .depth = layer->depth, .reversedDepth = m_options.reversedDepth});
    }
    commands.drawScopes(drawn, scopes);
    mergeGBuffers(commands.primary());
}

void FocusLayers::mergeGBuffers(vk::CommandBuffer primary) const {
    m_device.beginLabel(primary, "merge G-buffers");
    const shaders::PictureSize size{glm::vec2(m_options.extent.width, m_options.extent.height)};
    std::vector<FullscreenPass::Draw> draws;
    std::vector<vk::ImageMemoryBarrier2> barriers{attachBarrier(m_merged)};
    for (const Drawn& drawn : m_drawn) {
        barriers.push_back(readBarrier(drawn.layer->gbuffer));
        draws.push_back({.set = *drawn.layer->merged, .push = std::as_bytes(std::span(&size, 1))});
    }
    gpu::pipelineBarrier(primary, barriers);
    m_merge.record(primary, draws, {.into = m_merged, .load = vk::AttachmentLoadOp::eClear});
    m_device.endLabel(primary);
}

void FocusLayers::light(vk::CommandBuffer primary, const ShadingInputs& shading, FocusInputs& inputs) const {
    lightLayers(primary, shading, inputs);
    m_device.beginLabel(primary, "compose layers");
    const shaders::PictureSize size{glm::vec2(m_options.extent.width, m_options.extent.height)};
    std::vector<FullscreenPass::Draw> draws;
    std::vector<vk::ImageMemoryBarrier2> barriers{readBarrier(m_merged), attachBarrier(m_into)};
    for (const Drawn& drawn : m_drawn) {
        barriers.push_back(readBarrier(drawn.layer->lit));
        draws.push_back({.set = *drawn.layer->laid, .push = std::as_bytes(std::span(&size, 1))});
    }
    gpu::pipelineBarrier(primary, barriers);
    m_compose.record(primary, draws,
                     {.into = m_into, .load = vk::AttachmentLoadOp::eClear, .clear = clearTo(m_background)});
    m_device.endLabel(primary);
}

vk::DescriptorSet FocusLayers::setOf(const Layer& layer, const ShadingInputs& shading,
                                     FocusInputs& inputs) const {
    const auto found = inputs.m_ofLayer.find(&layer.gbuffer);
    if (found != inputs.m_ofLayer.end()) {
        return *found->second;
    }
    PassInputs made = m_light.makeInputs(layer.gbuffer, shading.lights()); // first, since this may throw
    return *inputs.m_ofLayer.try_emplace(&layer.gbuffer, std::move(made)).first->second;
}

void FocusLayers::lightLayers(vk::CommandBuffer primary, const ShadingInputs& shading,
                              FocusInputs& inputs) const {
    m_device.beginLabel(primary, "shading of layers");
    std::vector<vk::ImageMemoryBarrier2> barriers;
    for (const Drawn& drawn : m_drawn) {
        barriers.push_back(attachBarrier(drawn.layer->lit));
    }
    gpu::pipelineBarrier(primary, barriers);
    for (const Drawn& drawn : m_drawn) {
        const FullscreenPass::Draw draw{.set = setOf(*drawn.layer, shading, inputs),
                                        .push = std::as_bytes(std::span(&drawn.fade, 1))};
        m_light.record(primary, {&draw, 1}, {.into = drawn.layer->lit});
    }
    m_device.endLabel(primary);
}

} // namespace cdr::render
