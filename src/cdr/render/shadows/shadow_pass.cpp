#include <cdr/gpu/commands.h>
#include <cdr/render/shadows/divided_view.h>
#include <cdr/render/shadows/light_shape.h>
#include <cdr/render/shadows/receiver_push.h>
#include <cdr/render/shadows/receiver_slices.h>
#include <cdr/render/shadows/shadow_pass.h>
#include <cdr/render/shadows/shadows.h>
#include <cdr/render/targets/gbuffer.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/shading.h>
#include <cdr/shaders/shadows.h>
#include <cdr/shaders/shared.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace cdr::render {

namespace {

constexpr auto kMaskFormat = vk::Format::eR8G8B8A8Unorm;
static_assert(shaders::kShadowChannels == kMaxShadowLights);
constexpr auto kImage = vk::DescriptorType::eCombinedImageSampler;
constexpr auto kBuffer = vk::DescriptorType::eStorageBuffer;
constexpr auto kTexels = vk::DescriptorType::eUniformTexelBuffer;

std::vector<vk::DescriptorType> receiverBindings(const gpu::Image& gbuffer) {
    return isVisibilityBuffer(gbuffer) ? std::vector{kImage, kBuffer, kTexels, kImage, kImage}
                                       : std::vector{kImage, kBuffer, kImage, kImage};
}

FullscreenPassOptions receiverOptions(const gpu::Image& gbuffer, AnchorForm anchors) {
    return {.name = "shadow receivers",
            .vertexSpirv = kFlatAnchorsVert,
            .fragmentSpirv = isVisibilityBuffer(gbuffer) ? gpu::Spirv(kReceiverFacetsFrag) : kReceiverFrag,
            .bindings = receiverBindings(gbuffer),
            .format = kMaskFormat,
            .constants = {static_cast<std::uint32_t>(anchors)},
            .pushBytes = sizeof(shaders::ReceiverPush),
            .blend = gpu::Blend::least,
            .depth = SliceDepth::kFormat};
}

/// Pixels of the picture where a slice's surfaces can be, and one around them.
vk::Rect2D areaOf(const ReceiverSlice& slice, const scene::Frustum& frustum, vk::Extent2D extent) {
    const glm::dvec2 size(extent.width, extent.height);
    const glm::dvec2 lens(frustum.tanX, -frustum.tanY);
    const glm::dvec2 one = ((slice.lowRay - frustum.centre) / lens * 0.5 + 0.5) * size;
    const glm::dvec2 other = ((slice.highRay - frustum.centre) / lens * 0.5 + 0.5) * size;
    // At least a pixel is left, wherever the slice is.
    const glm::dvec2 low = glm::clamp(glm::floor(glm::min(one, other)) - 1.0, glm::dvec2(0.0), size - 1.0);
    const glm::dvec2 high = glm::clamp(glm::ceil(glm::max(one, other)) + 1.0, low + 1.0, size);
    return {{static_cast<std::int32_t>(low.x), static_cast<std::int32_t>(low.y)},
            {static_cast<std::uint32_t>(high.x - low.x), static_cast<std::uint32_t>(high.y - low.y)}};
}

} // namespace

ShadowPass::ShadowPass(const gpu::Device& device, const DrawnScene& scene, const gpu::Image& gbuffer,
                       const Shadows& options, depth::Mapping mapping)
    : m_device(device),
      m_scene(scene),
      m_gbuffer(gbuffer),
      m_options(options),
      m_map(device, scene.uploaded.textureLayout(), options.maxTexels),
      m_mask(device, colorOptions(gbuffer.options().extent, kMaskFormat), "shadow mask"),
      m_receivers(ByCascades<FullscreenPass>::make(
          depth::isAnchored(mapping),
          [&](AnchorForm anchors) { return FullscreenPass(device, receiverOptions(gbuffer, anchors)); })),
      m_slices(device, gbuffer, receiverBindings(gbuffer), mapping) {
    if (device.info().hasConditionalRendering) {
        m_seen.emplace(device);
    }
}

ShadowPass::Slot ShadowPass::makeSlot(const ShadingInputs& shading) const {
    Slot slot{.inputs = m_receivers.few.makeInputs(m_gbuffer, shading.lights()),
              .casters = CasterDraws(m_device, m_scene)};
    const std::uint32_t map = isVisibilityBuffer(m_gbuffer) ? 3 : 2;
    slot.inputs.setImage(map, m_map.depth());
    slot.inputs.setImage(map + 1, m_map.slope());
    if (m_seen) {
        slot.seen = m_seen->makeSlot();
    }
    return slot;
}

void ShadowPass::prepare(Slot& slot, const FrameView& view, const Seen& seen, std::uint32_t subPixelBits,
                         platform::WorkerPool& workers) const {
    std::vector<SeenSphere> spheres = seenSpheres(view.camera, seen.visible);
    addOccupied(spheres, view.camera, view.frustum, seen.occupied);
    const std::vector<ReceiverSlice> slices = slicesOf(m_options.method, view.camera, view.frustum, spheres);
    slot.slices = slicePush(slices, m_options.method);
    slot.cascades = view.cascades.size();
    slot.views.clear();
    slot.receivers.clear();
    slot.pixels.clear();
    for (std::size_t i = 0; i < slices.size(); ++i) {
        slot.pixels.push_back({sliceDepth(slices, i, m_options.method),
                               areaOf(slices[i], view.frustum, m_gbuffer.options().extent)});
    }
    const std::vector<std::uint32_t> lights = scene::shadowLights(m_scene.scene.lights);
    for (std::size_t channel = 0; channel < lights.size(); ++channel) {
        for (std::size_t i = 0; i < slices.size(); ++i) {
            for (const LightView& made : viewsOf(m_scene.scene.lights[lights[channel]], slices[i], view)) {
                slot.views.push_back(made);
                slot.views.back().slice = i;
                slot.views.back().channel = channel;
            }
        }
    }
    slot.casters.prepare(view, slices, slot.views, workers); // finds where views begin
    const bool isPlain = m_options.method == ShadowMethod::plain;
    for (const LightView& made : slot.views) {
        slot.receivers.push_back(
            receiverPush(made, view, {.isPlain = isPlain, .subPixelBits = subPixelBits}));
    }
}

std::vector<LightView> ShadowPass::viewsOf(const scene::PointLight& light, const ReceiverSlice& slice,
                                           const FrameView& view) const {
    const glm::dvec3& camera = view.camera.position;
    const double footprint = view.frustum.footprintSlope;
    std::vector<LightView> views;
    for (const LightView& whole : lightViews(light, camera, slice, footprint, m_options.maxTexels)) {
        const std::vector<LightView> parts = m_options.method == ShadowMethod::plain
                                                 ? std::vector{whole}
                                                 : dividedView(whole, slice, camera, footprint);
        std::copy_if(parts.begin(), parts.end(), std::back_inserter(views),
                     [&](const LightView& part) { return isInCone(light, part); });
    }
    return views;
}

void ShadowPass::record(vk::CommandBuffer primary, const Slot& slot) const {
    m_device.beginLabel(primary, "shadows");
    m_slices.record(primary, *slot.inputs, slot.slices, slot.cascades);
    if (m_seen) {
        m_seen->record(primary, *slot.seen, slot.pixels, m_slices.image());
    }
    gpu::pipelineBarrier(primary, {attachBarrier(m_mask)});
    // Of its own, since a view may be skipped.
    m_receivers.of(slot.cascades)
        .record(primary, {},
                {.into = m_mask,
                 .load = vk::AttachmentLoadOp::eClear,
                 .clear = vk::ClearColorValue{std::array{1.0f, 1.0f, 1.0f, 1.0f}},
                 .depth = &m_slices.image()});
    for (std::size_t i = 0; i < slot.views.size(); ++i) {
        if (m_seen) {
            SeenSlices::begin(primary, *slot.seen, slot.views[i].slice);
        }
        recordView(primary, slot, i);
        if (m_seen) {
            SeenSlices::end(primary);
        }
    }
    gpu::pipelineBarrier(primary, {readBarrier(m_mask)});
    m_device.endLabel(primary);
}

void ShadowPass::recordView(vk::CommandBuffer primary, const Slot& slot, std::size_t index) const {
    const LightView& view = slot.views[index];
    const ShadowMapPart whole{.view = view, .index = index};
    m_map.record(primary, {&whole, 1}, slot.casters);
    const SlicePixels& pixels = slot.pixels[view.slice];
    const FullscreenPass::Draw draw{.set = *slot.inputs,
                                    .push = std::as_bytes(std::span(&slot.receivers[index], 1)),
                                    .depth = pixels.depth,
                                    .area = pixels.area};
    gpu::pipelineBarrier(primary, {chainBarrier(m_mask)});
    m_receivers.of(slot.cascades)
        .record(primary, {&draw, 1},
                {.into = m_mask, .load = vk::AttachmentLoadOp::eLoad, .depth = &m_slices.image()});
}

std::uint64_t ShadowPass::predictBytes(const gpu::Device& device, vk::Extent2D extent,
                                       const Shadows& options) {
    return ShadowMap::predictBytes(device, options.maxTexels) +
           gpu::predictBytes(device, colorOptions(extent, kMaskFormat)) +
           SliceDepth::predictBytes(device, extent);
}

} // namespace cdr::render
