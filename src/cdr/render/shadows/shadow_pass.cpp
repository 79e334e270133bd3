#include <cdr/gpu/commands.h>
#include <cdr/render/shadows/divided_view.h>
#include <cdr/render/shadows/light_shape.h>
#include <cdr/render/shadows/receiver_push.h>
#include <cdr/render/shadows/receiver_slices.h>
#include <cdr/render/shadows/shadow_pass.h>
#include <cdr/render/targets/gbuffer.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/receiver_facets_frag.h>
#include <cdr/shaders/receiver_frag.h>

#include <algorithm>
#include <array>

namespace cdr::render {

namespace {

constexpr auto kMaskFormat = vk::Format::eR8G8B8A8Unorm;
constexpr auto kImage = vk::DescriptorType::eCombinedImageSampler;
constexpr auto kBuffer = vk::DescriptorType::eStorageBuffer;
constexpr auto kTexels = vk::DescriptorType::eUniformTexelBuffer;

gpu::ImageOptions maskOptions(vk::Extent2D extent) {
    return {.extent = extent,
            .format = kMaskFormat,
            .usage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled |
                     vk::ImageUsageFlagBits::eTransferSrc};
}

bool isVisibility(const gpu::Image& gbuffer) {
    return gbuffer.options().format == kVisibilityFormat;
}

FullscreenPassOptions receiverOptions(const gpu::Image& gbuffer) {
    const bool facets = isVisibility(gbuffer);
    return {.name = "shadow receivers",
            .fragmentSpirv = facets ? gpu::Spirv(kReceiverFacetsFrag) : kReceiverFrag,
            .bindings = facets ? std::vector{kImage, kBuffer, kTexels, kImage, kImage}
                               : std::vector{kImage, kBuffer, kImage, kImage},
            .format = kMaskFormat,
            .pushBytes = sizeof(shaders::ReceiverPush),
            .blend = gpu::Blend::least};
}

} // namespace

ShadowPass::ShadowPass(const gpu::Device& device, const DrawnScene& scene, const gpu::Image& gbuffer,
                       const Shadows& options)
    : m_device(device),
      m_scene(scene),
      m_gbuffer(gbuffer),
      m_options(options),
      m_map(device, options.mostTexels),
      m_mask(device, maskOptions(gbuffer.options().extent), "shadow mask"),
      m_receivers(device, receiverOptions(gbuffer)) {}

ShadowPass::Slot ShadowPass::makeSlot(const ShadingInputs& shading) const {
    Slot slot{.inputs = m_receivers.makeInputs(),
              .casters = CasterDraws(m_device, m_scene),
              .views = {},
              .pushes = {}};
    const std::uint32_t map = isVisibility(m_gbuffer) ? 3 : 2;
    slot.inputs.setImage(0, m_gbuffer);
    slot.inputs.setBuffer(1, shading.lights());
    slot.inputs.setImage(map, m_map.depth());
    slot.inputs.setImage(map + 1, m_map.slope());
    return slot;
}

void ShadowPass::prepare(Slot& slot, const FrameView& view, const visibility::VisibleCells& visible,
                         std::uint32_t subPixelBits, host::WorkerPool& workers) const {
    const bool isPlain = m_options.method == ShadowMethod::plain;
    const std::vector<SeenSphere> spheres = seenSpheres(view.camera, visible);
    const std::vector<ReceiverSlice> slices = isPlain ? practicalSlices(view.camera, view.frustum, spheres)
                                                      : receiverSlices(view.camera, view.frustum, spheres);
    slot.views.clear();
    std::vector<std::size_t> lightOf;
    const std::size_t lights = std::min(m_scene.scene.lights.size(), kMostShadowLights);
    for (std::size_t i = 0; i < lights; ++i) {
        const scene::PointLight& light = m_scene.scene.lights[i];
        for (const ReceiverSlice& slice : slices) {
            for (const LightView& whole : lightViews(light, view.camera.position, slice,
                                                     view.frustum.footprintSlope, m_options.mostTexels)) {
                std::vector<LightView> views =
                    isPlain ? std::vector{whole}
                            : dividedView(whole, slice, view.camera.position, view.frustum.footprintSlope);
                std::erase_if(views, [&](const LightView& part) { return !isInCone(light, part); });
                slot.views.insert(slot.views.end(), views.begin(), views.end());
            }
            lightOf.resize(slot.views.size(), i);
        }
    }
    slot.casters.prepare(slot.views, workers);
    slot.pushes.clear();
    for (std::size_t i = 0; i < slot.views.size(); ++i) {
        shaders::ReceiverPush& push = slot.pushes.emplace_back(receiverPush(
            slot.views[i], view, {.light = lightOf[i], .isPlain = isPlain, .subPixelBits = subPixelBits}));
        push.mapLast = shaders::ivec2(static_cast<std::int32_t>(m_map.side()) - 1);
    }
}

void ShadowPass::record(vk::CommandBuffer primary, const Slot& slot) const {
    m_device.beginLabel(primary, "shadows");
    gpu::pipelineBarrier(primary, {attachBarrier(m_mask)});
    const vk::ClearValue reached{vk::ClearColorValue{std::array{1.0f, 1.0f, 1.0f, 1.0f}}};
    for (std::size_t i = 0; i < slot.views.size(); ++i) {
        const ShadowMapPart whole{.view = slot.views[i], .index = i};
        m_map.record(primary, {&whole, 1}, slot.casters);
        const FullscreenPass::Draw draw{.set = slot.inputs.set(),
                                        .push = std::as_bytes(std::span(&slot.pushes[i], 1))};
        if (i > 0) {
            gpu::pipelineBarrier(primary, {chainBarrier(m_mask)});
        }
        m_receivers.record(primary, {&draw, 1}, m_mask,
                           i == 0 ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad, reached);
    }
    if (slot.views.empty()) {
        m_receivers.record(primary, {}, m_mask, vk::AttachmentLoadOp::eClear, reached);
    }
    gpu::pipelineBarrier(primary, {readBarrier(m_mask)});
    m_device.endLabel(primary);
}

std::uint64_t ShadowPass::predictBytes(const gpu::Device& device, vk::Extent2D extent,
                                       const Shadows& options) {
    return ShadowMap::predictBytes(device, options.mostTexels) +
           gpu::predictBytes(device, maskOptions(extent));
}

} // namespace cdr::render
