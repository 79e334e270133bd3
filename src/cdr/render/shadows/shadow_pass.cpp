#include <cdr/gpu/commands.h>
#include <cdr/render/shadows/receiver_slices.h>
#include <cdr/render/shadows/shadow_pass.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/shaders/receiver_facets_frag.h>
#include <cdr/shaders/receiver_frag.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

FullscreenPassOptions receiverOptions(bool facets) {
    return {.name = "shadow receivers",
            .fragmentSpirv = facets ? gpu::Spirv(kReceiverFacetsFrag) : kReceiverFrag,
            .bindings = facets ? std::vector{kImage, kBuffer, kTexels, kImage, kImage}
                               : std::vector{kImage, kBuffer, kImage, kImage},
            .format = kMaskFormat,
            .pushBytes = sizeof(shaders::ReceiverPush),
            .blend = gpu::Blend::least};
}

/// Of a distance, which may be beyond the range of floats.
float toFloat(double distance) {
    return static_cast<float>(std::min(distance, static_cast<double>(std::numeric_limits<float>::max())));
}

/// Of a view of the light that has this channel of the mask.
/// @param isPlain whether places are taken from the camera.
shaders::ReceiverPush pushOf(const LightView& view, const FrameView& frame, bool isPlain, std::size_t light) {
    const scene::Camera& camera = frame.camera;
    const float referenceView = isPlain ? 0.0f : toFloat(camera.viewDistance(view.origin));
    const glm::dvec3 place =
        view.toLight((camera.position - view.origin) - camera.back * static_cast<double>(referenceView));
    const auto row = [&](const glm::dvec3& axis, double offset) {
        return glm::vec4(glm::dot(axis, camera.right), glm::dot(axis, camera.up),
                         -glm::dot(axis, camera.back), offset);
    };
    return {.right = row(view.right, place.x),
            .up = row(view.up, place.y),
            .ahead = row(view.ahead, place.z),
            .low = view.low,
            .nearView = toFloat(view.nearView),
            .farView = toFloat(view.farView),
            .referenceView = referenceView,
            .lens = view.lens(),
            .snap = 0.0f,
            .mapSnap = 0.0f,
            .channel = static_cast<std::uint32_t>(light),
            .isPlain = isPlain ? 1u : 0u};
}

} // namespace

ShadowPass::ShadowPass(const gpu::Device& device, const DrawnScene& scene, const gpu::Image& gbuffer,
                       bool facets, const Shadows& options)
    : m_device(device),
      m_scene(scene),
      m_gbuffer(gbuffer),
      m_facets(facets),
      m_options(options),
      m_map(device, options.mostTexels),
      m_mask(device, maskOptions(gbuffer.options().extent), "shadow mask"),
      m_receivers(device, receiverOptions(facets)) {}

ShadowPass::Slot ShadowPass::makeSlot(const ShadingInputs& shading) const {
    Slot slot{.inputs = m_receivers.makeInputs(),
              .casters = CasterDraws(m_device, m_scene),
              .views = {},
              .pushes = {}};
    const std::uint32_t map = m_facets ? 3 : 2;
    slot.inputs.setImage(0, m_gbuffer);
    slot.inputs.setBuffer(1, shading.lights());
    slot.inputs.setImage(map, m_map.depth());
    slot.inputs.setImage(map + 1, m_map.slope());
    return slot;
}

void ShadowPass::prepare(Slot& slot, const FrameView& view, const visibility::VisibleCells& visible,
                         std::uint32_t subPixelBits, host::WorkerPool& workers) const {
    slot.views.clear();
    slot.pushes.clear();
    const bool isPlain = m_options.method == ShadowMethod::plain;
    const std::vector<ReceiverSlice> slices = isPlain ? practicalSlices(view.camera, view.frustum, visible)
                                                      : receiverSlices(view.camera, view.frustum, visible);
    const std::vector<scene::PointLight>& lights = m_scene.scene.lights;
    std::vector<std::size_t> lightOf;
    for (std::size_t light = 0; light < std::min(lights.size(), kMostShadowLights); ++light) {
        for (const ReceiverSlice& slice : slices) {
            const std::vector<LightView> views =
                lightViews(lights[light].position, view.camera.position, slice, view.frustum.footprintSlope,
                           m_options.mostTexels);
            slot.views.insert(slot.views.end(), views.begin(), views.end());
            lightOf.resize(slot.views.size(), light);
        }
    }
    slot.casters.prepare(slot.views, workers);
    for (std::size_t i = 0; i < slot.views.size(); ++i) {
        shaders::ReceiverPush& push =
            slot.pushes.emplace_back(pushOf(slot.views[i], view, isPlain, lightOf[i]));
        const double halfStep = std::exp2(-1.0 - subPixelBits); // pixels, and texels
        push.snap = static_cast<float>(view.frustum.footprintSlope * halfStep);
        push.mapSnap = static_cast<float>(halfStep);
    }
}

void ShadowPass::record(vk::CommandBuffer primary, const Slot& slot) const {
    m_device.beginLabel(primary, "shadows");
    gpu::pipelineBarrier(primary, {attachBarrier(m_mask)});
    const vk::ClearValue reached{vk::ClearColorValue{std::array{1.0f, 1.0f, 1.0f, 1.0f}}};
    for (std::size_t i = 0; i < slot.views.size(); ++i) {
        m_map.record(primary, slot.views[i], slot.casters, i);
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
