#include <cdr/base/format_error.h>
#include <cdr/gpu/commands.h>
#include <cdr/render/shading/air_record.h>
#include <cdr/render/shading/finish.h>
#include <cdr/render/shading/seen_lights.h>
#include <cdr/render/shading/shading_pass.h>
#include <cdr/render/targets/gbuffer_rendering.h>
#include <cdr/render/view_transform.h>
#include <cdr/shaders/shading.h>

#include <algorithm>
#include <array>
#include <vector>

namespace cdr::render {

namespace {

constexpr auto kImage = vk::DescriptorType::eCombinedImageSampler;
constexpr auto kBuffer = vk::DescriptorType::eStorageBuffer;

bool isOccluded(const Effects& effects) {
    return effects.occlusion.radius > 0.0;
}

bool isOccludedPerLayer(const Effects& effects) {
    return isOccluded(effects) && effects.occlusion.perLayer;
}

using gpu::Spirv;

Spirv fragmentOf(const ShadingOptions& shading) {
    const Effects& effects = shading.effects;
    const auto either = [&](const Spirv& lit, const Spirv& shadowed) {
        return shading.shadows != nullptr ? shadowed : lit;
    };
    if (shading.facets) {
        return either(kShadingFacetsFrag, kShadingFacetsShadowedFrag);
    }
    if (isOccludedPerLayer(effects)) {
        return either(kShadingLayersOccludedFrag, kShadingLayersOccludedShadowedFrag);
    }
    if (isOccluded(effects)) {
        return shading.emission != nullptr
                   ? either(kShadingEmissionOccludedFrag, kShadingEmissionOccludedShadowedFrag)
                   : either(kShadingOccludedFrag, kShadingOccludedShadowedFrag);
    }
    return shading.emission != nullptr ? either(kShadingEmissionFrag, kShadingEmissionShadowedFrag)
                                       : either(kShadingFrag, kShadingShadowedFrag);
}

/// What the fragment shader reads beside surfaces and lights, from binding 2 on.
enum class ImageUse : std::uint8_t { facets, occlusion, emission, shadows };

std::vector<ImageUse> imagesOf(const ShadingOptions& shading) {
    std::vector<ImageUse> uses;
    if (shading.facets) {
        uses.push_back(ImageUse::facets);
    } else if (isOccluded(shading.effects) && !isOccludedPerLayer(shading.effects)) {
        uses.push_back(ImageUse::occlusion);
    }
    if (shading.emission != nullptr) {
        uses.push_back(ImageUse::emission);
    }
    if (shading.shadows != nullptr) {
        uses.push_back(ImageUse::shadows);
    }
    return uses;
}

FullscreenPassOptions passOptions(vk::Format format, const ShadingOptions& shading, std::uint32_t lightForm,
                                  AnchorForm anchorForm) {
    const Effects& effects = shading.effects;
    const auto [finish, exposure] =
        shading.finishes ? finishConstants(effects.finish, daylightIf(shading.sky || shading.air))
                         : finishLaterConstants();
    FullscreenPassOptions options{
        .name = "shading",
        .vertexSpirv = kShadingVert,
        .bindings = {kImage, kBuffer},
        .format = format,
        .constants = {effects.fog.visibility > 0.0 ? 1u : 0u, shading.metallicRoughness ? 1u : 0u, lightForm,
                      static_cast<std::uint32_t>(anchorForm), shading.marks != nullptr ? 1u : 0u, finish,
                      exposure, shading.sky ? 1u : 0u, shading.air ? 1u : 0u}};
    if (shading.marks != nullptr) {
        options.marks = shading.marks->options().format;
    }
    options.fragmentSpirv = fragmentOf(shading);
    for (const ImageUse use : imagesOf(shading)) {
        options.bindings.push_back(use == ImageUse::facets ? vk::DescriptorType::eUniformTexelBuffer
                                                           : kImage);
    }
    return options;
}

} // namespace

std::uint32_t lightFormOf(const scene::Scene& scene) {
    return std::any_of(scene.lights.begin(), scene.lights.end(), scene::isShaped)
               ? shaders::kShapedLights
               : static_cast<std::uint32_t>(std::min<std::size_t>(scene.lights.size(), shaders::kManyLights));
}

ShadingPass::ShadingPass(const gpu::Device& device, const gpu::Image& gbuffer, const gpu::Image& into,
                         const ShadingOptions& options)
    : m_device(device),
      m_gbuffer(gbuffer),
      m_into(into),
      m_options(options),
      m_occlusion(isOccluded(options.effects) && !isOccludedPerLayer(options.effects)
                      ? std::make_unique<OcclusionPass>(device, gbuffer, options.mapping)
                      : nullptr) {
    // A fitted split gives a frame one cascade or several, so both forms are made.
    passFor(options.lightForm, 1);
    passFor(options.lightForm, shaders::kFlatLights);
    if (options.preparedLights > 0) {
        for (std::uint32_t lights = 0; lights <= std::min(options.preparedLights, shaders::kManyLights);
             ++lights) {
            prepare(lights);
        }
    }
    if (options.preparedShapes) {
        prepare(shaders::kShapedLights);
    }
}

void ShadingPass::prepare(std::uint32_t lightForm) {
    for (const std::size_t cascades : {1u, shaders::kFlatLights, shaders::kFlatLights + 1u}) {
        passFor(lightForm, cascades);
    }
}

FullscreenPass& ShadingPass::passFor(std::uint32_t lightForm, std::size_t cascades) {
    const Form form{.lights = lightForm,
                    .anchors = anchorFormOf(depth::isAnchored(m_options.mapping), cascades)};
    const auto found = m_passes.find(form);
    return found != m_passes.end()
               ? found->second
               : m_passes
                     .try_emplace(form, m_device,
                                  passOptions(m_into.options().format, m_options, form.lights, form.anchors))
                     .first->second;
}

std::size_t ShadingPass::maxLights(const gpu::Device& device) {
    return (device.info().maxStorageBufferBytes - sizeof(shaders::ShadingHeader)) /
           sizeof(shaders::LightRecord);
}

ShadingInputs ShadingPass::makeInputs(std::size_t lights) const {
    if (lights > maxLights(m_device)) {
        throw base::runError("the scene has {} lights, and a buffer of {} has room for {}", lights,
                             m_device.info().name, maxLights(m_device));
    }
    ShadingInputs inputs;
    inputs.m_lights =
        gpu::Buffer(m_device, sizeof(shaders::ShadingHeader) + lights * sizeof(shaders::LightRecord),
                    vk::BufferUsageFlagBits::eStorageBuffer, gpu::MemoryUse::hostWrites, "lights");
    inputs.m_inputs = m_passes.begin()->second.makeInputs(m_gbuffer, inputs.m_lights);
    std::uint32_t binding = 2;
    for (const ImageUse use : imagesOf(m_options)) {
        const gpu::Image* image = use == ImageUse::facets      ? nullptr // setFacets(), frame by frame
                                  : use == ImageUse::occlusion ? &m_occlusion->image()
                                  : use == ImageUse::emission  ? m_options.emission
                                                               : m_options.shadows;
        if (image != nullptr) {
            inputs.m_inputs.setImage(binding, *image);
        }
        ++binding;
    }
    if (m_occlusion) {
        inputs.m_occlusion = m_occlusion->makeInputs(inputs.m_lights);
    }
    return inputs;
}

void ShadingPass::update(ShadingInputs& inputs, const scene::Scene& scene, const FrameView& view) const {
    const scene::Camera& camera = view.camera;
    const scene::Frustum& frustum = view.frustum;
    const std::vector<double> anchorsView = view.anchorsView();
    const vk::Extent2D extent = m_gbuffer.options().extent;
    shaders::ShadingHeader& header = inputs.m_lights.as<shaders::ShadingHeader>(1).front();
    header.ambient = scene.ambient;
    const Effects& effects = m_options.effects;
    const Fog& fog = effects.fog;
    const bool isFoggy = fog.visibility > 0.0;
    inputs.m_background = isFoggy ? fog.color : scene.background;
    // With air, the shader does this: air is between the camera and the background, and comes before the finish.
    if (m_options.finishes && !scene.air) {
        inputs.m_background =
            shownBackground(inputs.m_background, effects.finish, daylightIf(scene.sky.has_value()));
    }
    header.shownBackground = glm::vec4(inputs.m_background, 1.0f);
    header.background = isFoggy ? fog.color : inputs.m_background;
    header.occlusionRadius = static_cast<float>(effects.occlusion.radius);
    header.rayScale = glm::vec2(frustum.tanX, frustum.tanY);
    header.rayCentre = glm::vec2(frustum.centre);
    header.pictureSize = glm::vec2(extent.width, extent.height);
    inputs.m_lightForm = lightFormOf(scene);
    inputs.m_cascades = anchorsView.size();
    const std::vector<std::uint32_t> seen = seenLights(scene.lights, camera, frustum);
    header.lightCount = static_cast<std::uint32_t>(seen.size());
    header.fog = glm::vec4(fog.color, fog.extinction());
    if (scene.sky) {
        header.skyUp = glm::vec4(glm::vec3(directionInView(camera, scene.sky->up)), 0.0f);
        header.skyZenith = glm::vec4(scene.sky->zenith, 0.0f);
        header.skyHorizon = glm::vec4(scene.sky->horizon, 0.0f);
        header.skyGround = glm::vec4(scene.sky->ground, 0.0f);
    }
    if (scene.air) {
        header.air = makeAirRecord(*scene.air, camera);
    }
    std::transform(anchorsView.begin(), anchorsView.end(), header.anchors, splitDouble);
    auto* lights = reinterpret_cast<shaders::LightRecord*>(&header + 1);
    for (const std::uint32_t light : seen) {
        *lights++ = makeLightRecord(scene.lights[light], camera);
    }
    inputs.m_lights.flush();
}

void ShadingPass::begin(vk::CommandBuffer primary, const ShadingInputs& inputs) const {
    std::vector<vk::ImageMemoryBarrier2> barriers{readBarrier(m_gbuffer), attachBarrier(m_into)};
    if (m_options.emission != nullptr) {
        barriers.push_back(readBarrier(*m_options.emission));
    }
    if (m_options.marks != nullptr) {
        barriers.push_back(marksBarrier(*m_options.marks));
    }
    gpu::pipelineBarrier(primary, barriers);
    if (m_occlusion) {
        m_occlusion->record(primary, inputs.m_occlusion, inputs.m_cascades);
    }
}

void ShadingPass::record(vk::CommandBuffer primary, const ShadingInputs& inputs) {
    m_device.beginLabel(primary, "shading");
    const FullscreenPass::Draw draw{.set = *inputs.m_inputs};
    const glm::vec3& background = inputs.m_background;
    // Where marks leave background out, it is what the clear makes it.
    const auto load =
        m_options.marks != nullptr ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eDontCare;
    passFor(inputs.m_lightForm, inputs.m_cascades)
        .record(primary, {&draw, 1},
                {.into = m_into,
                 .load = load,
                 .clear = vk::ClearColorValue{std::array{background.r, background.g, background.b, 1.0f}},
                 .marks = m_options.marks});
    m_device.endLabel(primary);
}

std::uint64_t ShadingPass::predictBytes(vk::Extent2D extent, const Effects& effects) {
    return isOccluded(effects) && !isOccludedPerLayer(effects) ? OcclusionPass::predictBytes(extent) : 0;
}

} // namespace cdr::render
