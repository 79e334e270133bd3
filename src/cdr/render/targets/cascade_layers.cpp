#include <cdr/gpu/commands.h>
#include <cdr/render/targets/cascade_layers.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/targets.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace cdr::render {

namespace {

/// The options, once the memory for the accumulated G-buffer and `layers` is known to be there.
const TargetsOptions& checked(const gpu::Device& device, const TargetsOptions& options, std::size_t layers) {
    gpu::requireDeviceBytes(
        device,
        gpu::predictBytes(device, colorOptions(options.extent, options.format)) +
            layers * predictLayerBytes(device, options.extent, options.depthFormat, options.format),
        fmt::format("an accumulated G-buffer of {}x{} with {} layers", options.extent.width,
                    options.extent.height, layers));
    return options;
}

FullscreenPassOptions mergeOptions(const TargetsOptions& options) {
    FullscreenPassOptions merge{.name = "merge",
                                .fragmentSpirv = kMergeFrag,
                                .bindings = {vk::DescriptorType::eCombinedImageSampler},
                                .format = options.format};
    if (options.format == kVisibilityFormat) {
        merge.constants = {1};
    }
    if (options.emission) {
        merge.fragmentSpirv = kMergeEmissionFrag;
        merge.bindings.push_back(vk::DescriptorType::eCombinedImageSampler);
        merge.formatBeside = kEmissionFormat;
    }
    if (options.occlusionRadius > 0.0) {
        merge.fragmentSpirv = kMergeOccludedFrag;
        merge.pushBytes = sizeof(shaders::LayerPush);
    }
    return merge;
}

shaders::LayerPush makeLayerPush(const FrameView& view, std::size_t cascade, double radius) {
    return {.rayScale = glm::vec2(view.frustum.tanX, view.frustum.tanY),
            .anchorView = static_cast<float>(view.cascades[cascade].terms.anchorView),
            .radius = static_cast<float>(radius),
            .rayCentre = glm::vec2(view.frustum.centre)};
}

} // namespace

CascadeLayers::CascadeLayers(const gpu::Device& device, const TargetsOptions& options,
                             const LayerCount& count)
    : m_device(device),
      m_options(checked(device, options, count.first)),
      m_perCascade(count.perCascade),
      m_merge(device, mergeOptions(options)),
      m_accumulated(makeGBuffer(device, options.extent, "G-buffer", options.format)),
      m_accumulatedEmission(makeEmission(device, options, "emission")),
      m_zeroFill(makeZeroFill(device, options)) {
    grow(count.first);
}

void CascadeLayers::grow(std::size_t layers) {
    if (layers <= m_layers.size()) {
        return;
    }
    const std::size_t more = layers - m_layers.size();
    gpu::requireDeviceBytes(
        m_device,
        more * predictLayerBytes(m_device, m_options.extent, m_options.depthFormat, m_options.format),
        fmt::format("{} layer G-buffers of {}x{}", more, m_options.extent.width, m_options.extent.height));
    while (m_layers.size() < layers) {
        m_layers.push_back(makeLayer(m_layers.size()));
    }
}

CascadeLayers::Layer CascadeLayers::makeLayer(std::size_t number) const {
    const std::string name = fmt::format("layer {}", number);
    gpu::Image gbuffer = makeGBuffer(m_device, m_options.extent, name, m_options.format);
    PassInputs source = m_merge.makeInputs();
    source.setImage(0, gbuffer);
    std::unique_ptr<gpu::Image> emission = makeEmission(m_device, m_options, name + " emission");
    if (emission != nullptr) {
        source.setImage(1, *emission);
    }
    return {.gbuffer = std::move(gbuffer),
            .emission = std::move(emission),
            .depth = makeDepthBuffer(m_device, m_options.extent, m_options.depthFormat, name + " depth",
                                     m_options.format),
            .source = std::move(source)};
}

void CascadeLayers::record(CascadeCommands& commands, const FrameView& view) {
    if (m_perCascade) {
        grow(view.drawn.size());
    }
    const std::vector<std::size_t> drawn = commands.drawnCascades(view.cascades.size());
    auto load = vk::AttachmentLoadOp::eClear;
    for (std::size_t left = drawn.size(); left > 0;) {
        const std::size_t count = std::min(m_layers.size(), left);
        const std::span<const std::size_t> batch = std::span(drawn).subspan(left - count, count);
        drawLayers(commands, batch);
        std::vector<shaders::LayerPush> layers;
        std::transform(batch.rbegin(), batch.rend(), std::back_inserter(layers), [&](std::size_t cascade) {
            return makeLayerPush(view, cascade, m_options.occlusionRadius);
        });
        mergeLayers(commands.primary(), layers, load);
        left -= count;
        load = vk::AttachmentLoadOp::eLoad;
    }
}

void CascadeLayers::drawLayers(CascadeCommands& commands, std::span<const std::size_t> cascades) const {
    std::vector<GBufferScope> scopes;
    for (std::size_t layer = 0; layer < cascades.size(); ++layer) {
        scopes.push_back({.gbuffer = m_layers[layer].gbuffer,
                          .depth = m_layers[layer].depth,
                          .emission = m_layers[layer].emission.get(),
                          .reversedDepth = m_options.reversedDepth,
                          .zeroFill = m_zeroFill.get()});
    }
    commands.drawScopes(cascades, scopes);
}

void CascadeLayers::mergeLayers(vk::CommandBuffer primary, std::span<const shaders::LayerPush> layers,
                                vk::AttachmentLoadOp load) const {
    m_device.beginLabel(primary, fmt::format("merge {} layers", layers.size()).c_str());
    std::vector<FullscreenPass::Draw> draws;
    std::vector<vk::ImageMemoryBarrier2> barriers{
        load == vk::AttachmentLoadOp::eClear ? attachBarrier(m_accumulated) : chainBarrier(m_accumulated)};
    if (m_accumulatedEmission != nullptr) {
        barriers.push_back(load == vk::AttachmentLoadOp::eClear ? attachBarrier(*m_accumulatedEmission)
                                                                : chainBarrier(*m_accumulatedEmission));
    }
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        barriers.push_back(readBarrier(m_layers[layer].gbuffer));
        if (m_layers[layer].emission != nullptr) {
            barriers.push_back(readBarrier(*m_layers[layer].emission));
        }
        draws.push_back({.set = *m_layers[layer].source});
        if (m_options.occlusionRadius > 0.0) {
            draws.back().push = std::as_bytes(layers.subspan(layer, 1));
        }
    }
    gpu::pipelineBarrier(primary, barriers);
    m_merge.record(primary, draws,
                   {.into = m_accumulated, .load = load, .beside = m_accumulatedEmission.get()});
    m_device.endLabel(primary);
}

} // namespace cdr::render
