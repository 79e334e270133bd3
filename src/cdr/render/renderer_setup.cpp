#include <cdr/base/format_error.h>
#include <cdr/render/materials/material_words.h>
#include <cdr/render/occluders/device_occlusion.h>
#include <cdr/render/occluders/occlusion_culling.h>
#include <cdr/render/output/frame_readback.h>
#include <cdr/render/output/motion_pass.h>
#include <cdr/render/renderer_setup.h>
#include <cdr/render/shadows/shadow_pass.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cdr::render {

namespace {

void requireFocusable(const RenderOptions& options) {
    requireUsable(options.focus);
    if (!options.focus.isOn()) {
        return;
    }
    if (options.targets.kind != TargetsKind::layers) {
        throw base::inputError("a lens with a focus needs targets layers, not {}", nameOf(options.targets));
    }
    if (options.effects.occlusion.radius > 0.0) {
        throw base::InputError("a lens with a focus does without ambient occlusion");
    }
    if (options.motion) {
        throw base::InputError("a lens with a focus shows no motion");
    }
    if (options.occlusionCulling) { // what is behind a blurred rim shows through
        throw base::InputError("a lens with a focus does without occlusion culling");
    }
}

void requireDetail(const RenderOptions& options) {
    visibility::requireUsable(options.detail);
    if (options.detail.mode == visibility::DetailMode::perCluster &&
        options.submission == Submission::gpuDriven) {
        throw base::InputError("levels of detail by cluster are chosen by the CPU: not with gpu-driven "
                               "submission");
    }
}

void requireDepthBias(const LayerOptions& layers) {
    if (!std::isfinite(layers.slopeFactor) || !std::isfinite(layers.constantFactor)) {
        throw base::inputError("the slope and constant factor of layers must be finite, not {} and {}",
                               layers.slopeFactor, layers.constantFactor);
    }
}

std::uint64_t predictOcclusionBytes(const gpu::Device& device, vk::Extent2D extent,
                                    const RenderOptions& options) {
    if (!options.occlusionCulling) {
        return 0;
    }
    return options.submission == Submission::gpuDriven ? DeviceOcclusion::predictBytes(device, extent)
                                                       : OcclusionCulling::predictBytes(device, extent);
}

/// Beside the picture, which they are drawn into.
std::uint64_t predictLitBytes(const gpu::Device& device, vk::Extent2D extent, const RenderOptions& options) {
    return options.surface == SurfacePath::lit
               ? gpu::predictBytes(
                     device, depthBufferOptions(device, extent, options.technique.format, kPictureFormat))
               : 0;
}

void requireShadows(const RenderOptions& options) {
    if (!options.shadows.isOn()) {
        return;
    }
    const std::uint32_t texels = options.shadows.maxTexels;
    if (texels < kMinShadowTexels || texels > kMaxShadowTexels) {
        throw base::inputError("shadow maps have sides of {} to {} texels, not {}", kMinShadowTexels,
                               kMaxShadowTexels, texels);
    }
    if (options.focus.isOn()) {
        throw base::InputError("a lens with a focus does without shadows");
    }
    if (!castsShadows(options.detail.mode)) {
        throw base::InputError("levels of detail by cascade or cluster do without shadows");
    }
}

/// Vulkan asks each device to read D32_SFLOAT, but to draw to it only those without D24.
void requireFloatDepth(const gpu::Device& device, const RenderOptions& options) {
    const vk::FormatProperties has =
        vk::PhysicalDevice(device.physical()).getFormatProperties(vk::Format::eD32Sfloat);
    if (has.optimalTilingFeatures & vk::FormatFeatureFlagBits::eDepthStencilAttachment) {
        return;
    }
    for (const auto& [isOn, what] : {std::pair{options.shadows.isOn(), "shadows need"},
                                     {options.occlusionCulling, "occlusion culling needs"}}) {
        if (isOn) {
            throw base::inputError("{} a depth buffer of D32_SFLOAT, which {} lacks", what,
                                   device.info().name);
        }
    }
}

} // namespace

PictureOptions pictureOptions(vk::Extent2D extent, const RenderOptions& options, const SceneTraits& scene,
                              Daylight daylight) {
    return {.extent = extent,
            .hasSteps = scene.blended || options.focus.isOn(),
            .keepsLinear = options.linear,
            .antialias = options.effects.antialias,
            .finish = options.effects.finish,
            .daylight = daylight};
}

TargetsOptions targetsOptions(vk::Extent2D extent, vk::Format format, const RenderOptions& options) {
    return {.extent = extent,
            .format = format,
            .depthFormat = options.technique.format,
            .reversedDepth = depth::isReversed(options.technique.mapping),
            .occlusionRadius = options.effects.occlusion.perLayer ? options.effects.occlusion.radius : 0.0};
}

PreparedSurfaces preparedSurfaces(const UploadedScene& uploaded, const PrepareFor& prepared) {
    PreparedSurfaces surfaces{
        .kept = {.metallicRoughness = uploaded.hasMetallicRoughness() || prepared.metallicRoughness,
                 .emission = uploaded.hasEmission() || prepared.emission},
        .blended = uploaded.hasBlended() || prepared.blended};
    KeptSurfaces& kept = surfaces.kept;
    for (const scene::Material& material : prepared.materials) {
        kept.metallicRoughness = kept.metallicRoughness || isMetallicRoughness(material);
        surfaces.blended = surfaces.blended || material.alphaMode == scene::AlphaMode::blend;
        kept.emission = kept.emission || scene::hasEmission(material);
    }
    return surfaces;
}

bool keepsMetallicRoughness(const RenderOptions& options) {
    const Occlusion& occlusion = options.effects.occlusion;
    return !(occlusion.radius > 0.0 && occlusion.perLayer);
}

bool keepsEmission(const RenderOptions& options) {
    return keepsMetallicRoughness(options) && !options.focus.isOn();
}

std::uint64_t predictPictureBytes(const gpu::Device& device, const RenderOptions& options,
                                  const SceneTraits& scene) {
    const vk::Extent2D extent{options.width, options.height};
    const bool hasFacets = options.surface != SurfacePath::gbuffer;
    return predictLayerBytes(device, extent, options.technique.format,
                             hasFacets ? kVisibilityFormat : kGBufferFormat) +
           (hasFacets ? gpu::predictBytes(device, colorOptions(extent, kGBufferFormat)) : 0) +
           predictLitBytes(device, extent, options) + FrameReadback::predictBytes(device, extent, options) +
           Picture::predictBytes(device, pictureOptions(extent, options, scene)) +
           ShadingPass::predictBytes(extent, options.effects) +
           (options.motion ? MotionPass::predictBytes(device, extent) : 0) +
           predictOcclusionBytes(device, extent, options) +
           (options.shadows.isOn() ? ShadowPass::predictBytes(device, extent, options.shadows) : 0);
}

std::uint32_t subPixelBits(const gpu::Device& device, const RenderOptions& options) {
    const std::uint32_t ofDevice = device.info().subPixelBits;
    return options.snapBits > 0 ? std::min(options.snapBits, ofDevice) : ofDevice;
}

void requireCompatible(const RenderOptions& options) {
    if (const auto problem = depth::splitProblem(options.technique.split)) {
        throw base::InputError(problem->message);
    }
    requireUsable(options.effects);
    requireFocusable(options);
    requireShadows(options);
    requireDepthBias(options.layers);
    if (options.effects.occlusion.perLayer && !hasLayers(options.targets.kind)) {
        throw base::inputError("ambient occlusion per cascade needs layered targets "
                               "(accumulate, pool or layers), not {}",
                               nameOf(options.targets.kind));
    }
    requireDetail(options);
}

vk::Extent2D checkedExtent(const gpu::Device& device, const RenderOptions& options,
                           const SceneTraits& scene) {
    if (options.framesInFlight < 1 || options.framesInFlight > kMaxFramesInFlight) {
        throw base::inputError("frames in flight must be 1 to {}, not {}", kMaxFramesInFlight,
                               options.framesInFlight);
    }
    if (options.snapBits > kMaxSnapBits) {
        throw base::inputError("vertices are rounded to 0 (not) to {} sub-pixel bits, not {}", kMaxSnapBits,
                               options.snapBits);
    }
    if (options.prepareFor.lights > kMaxPreparedLights) {
        throw base::inputError("a renderer is prepared for at most {} lights, not {}", kMaxPreparedLights,
                               options.prepareFor.lights);
    }
    if (options.part != CascadePart{}) {
        requireDivisible(options, scene);
    }
    requireCompatible(options);
    requireFloatDepth(device, options);
    const std::uint32_t most = device.info().maxImageSide;
    for (const std::uint32_t side : {options.width, options.height}) {
        if (side < 1 || side > most) {
            throw base::inputError("size {}x{}: each side must be 1 to {} pixels on {}", options.width,
                                   options.height, most, device.info().name);
        }
    }
    const vk::Extent2D extent{options.width, options.height};
    if (options.occlusionCulling && options.submission == Submission::gpuDriven) {
        DeviceOcclusion::requireLimits(device, extent);
    }
    gpu::requireDeviceBytes(device, predictPictureBytes(device, options, scene),
                            fmt::format("a {}x{} picture", extent.width, extent.height));
    return extent;
}

} // namespace cdr::render
