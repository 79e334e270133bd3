#include <cdr/base/error.h>
#include <cdr/render/frame/frame_passes.h>
#include <cdr/render/renderer_setup.h>
#include <cdr/shaders/shading.h>

#include <algorithm>
#include <iterator>

namespace cdr::render {

namespace {

/// Whether surfaces are drawn by facets: for whoever reads them also where they are lit while they are drawn.
bool hasFacets(const RenderOptions& options) {
    return options.surface != SurfacePath::gbuffer;
}

FramePasses::OwnedTargets makeOwnTargets(const gpu::Device& device, const DrawnScene& drawn,
                                         const RenderOptions& options, const KeptSurfaces& kept,
                                         const Picture& picture) {
    TargetsOptions targets = targetsOptions(picture.lit().options().extent,
                                            hasFacets(options) ? kVisibilityFormat : kGBufferFormat, options);
    targets.emission = kept.emission;
    if (!options.focus.isOn()) {
        return makeTargets(device, options.targets, targets);
    }
    if (drawn.scene.air) {
        throw base::InputError("a lens with a focus does without air, which the scene has");
    }
    return std::make_unique<FocusLayers>(device, targets, picture.lit(),
                                         FocusLayersOptions{.effects = options.effects,
                                                            .background = drawn.scene.background,
                                                            .fades = options.focus.blend,
                                                            .sky = drawn.scene.sky.has_value(),
                                                            .metallicRoughness = kept.metallicRoughness});
}

/// Whose G-buffer is the picture; null unless surfaces are lit while they are drawn.
std::unique_ptr<Targets> makeLitTargets(const gpu::Device& device, vk::Extent2D extent,
                                        const RenderOptions& options) {
    return options.surface == SurfacePath::lit
               ? makeTargets(device, options.targets, targetsOptions(extent, kPictureFormat, options))
               : nullptr;
}

/// Null unless surfaces are drawn by facets.
std::unique_ptr<ResolvePass> makeResolve(const gpu::Device& device, vk::Extent2D extent,
                                         const RenderOptions& options) {
    using Type = vk::DescriptorType;
    if (!hasFacets(options)) {
        return nullptr;
    }
    return std::make_unique<ResolvePass>(ResolvePass{
        .gbuffer = makeGBuffer(device, extent, "resolved G-buffer"),
        .pass = {device,
                 {.name = "resolve",
                  .fragmentSpirv = kResolveFrag,
                  .bindings = {Type::eCombinedImageSampler, Type::eStorageBuffer, Type::eUniformTexelBuffer},
                  .format = kGBufferFormat}}});
}

/// Of the materials that a renderer is prepared for.
std::vector<std::uint32_t> blendedVariants(const PrepareFor& prepared) {
    std::vector<scene::Material> blended;
    std::copy_if(
        prepared.materials.begin(), prepared.materials.end(), std::back_inserter(blended),
        [](const scene::Material& material) { return material.alphaMode == scene::AlphaMode::blend; });
    return variantsOf(blended);
}

} // namespace

FramePasses::FramePasses(const gpu::Device& device, const DrawnScene& drawn, const RenderOptions& options,
                         const SceneNeeds& needs, const DrawPathFactory& paths, platform::WorkerPool& workers)
    : extent(checkedExtent(device, options, needs.traits())),
      litTargets(makeLitTargets(device, extent, options)),
      picture(device, pictureOptions(extent, options, needs.traits(), daylightIf(needs.sky || needs.air)),
              litTargets != nullptr ? &litTargets->gbuffer() : nullptr),
      ownTargets(makeOwnTargets(device, drawn, options, needs.kept, picture)),
      targets(std::visit([](const auto& own) -> Targets& { return *own; }, ownTargets)),
      cutter(options, targets),
      shadows(options.shadows.isOn()
                  ? std::make_unique<ShadowPass>(device, drawn, targets.gbuffer(), options.shadows,
                                                 options.technique.mapping)
                  : nullptr),
      shading(device, targets.gbuffer(), picture.lit(),
              {.effects = options.effects,
               .metallicRoughness = needs.kept.metallicRoughness,
               .mapping = options.technique.mapping,
               .sky = needs.sky,
               .air = needs.air,
               .finishes = !needsLit(pictureOptions(extent, options, needs.traits())),
               .emission = targets.emission(),
               .facets = hasFacets(options),
               .marks = needs.air ? nullptr : targets.marks(), // the background has air too
               .shadows = shadows != nullptr ? &shadows->mask() : nullptr,
               .lightForm = lightFormOf(drawn.scene),
               .preparedLights = options.prepareFor.lights,
               .preparedShapes = options.prepareFor.shapedLights}),
      resolve(makeResolve(device, targets.gbuffer().options().extent, options)),
      translucent(needs.blended ? std::make_unique<TranslucentPass>(
                                      device, drawn, targets.gbuffer(), picture.lit(), options.translucency,
                                      options.shadows, blendedVariants(options.prepareFor))
                                : nullptr),
      motion(options.motion ? std::make_unique<MotionPass>(device, gbuffer(), subPixelBits(device, options))
                            : nullptr),
      readback(device, extent, options) {
    if (options.occlusionCulling && options.submission == Submission::gpuDriven) {
        occlusion = paths.makeDeviceOcclusion(options.technique, extent);
    } else if (options.occlusionCulling) {
        occlusion = std::make_unique<OcclusionCulling>(device, drawn, options.technique, extent,
                                                       paths.makeOccluders(workers));
    }
}

std::unique_ptr<SlotInputs> FramePasses::makeInputs(std::size_t lightRoom) const {
    auto made = std::make_unique<SlotInputs>();
    made->shading = shading.makeInputs(lightRoom);
    if (resolve != nullptr) {
        made->resolve = resolve->pass.makeInputs(targets.gbuffer(), made->shading.lights());
    }
    if (shadows != nullptr) {
        made->shadows.emplace(shadows->makeSlot(made->shading));
    }
    if (motion != nullptr) {
        made->motion.emplace(motion->makeInputs(made->shading));
    }
    if (translucent != nullptr) {
        made->translucent.emplace(translucent->makeSlot(made->shading));
    }
    return made;
}

void FramePasses::forgetFrames() {
    cutter.split().forget();
    if (auto* byCpu = findIn<OcclusionCulling>(occlusion)) {
        byCpu->forget();
    }
    if (auto* byDevice = findIn<DeviceOcclusion>(occlusion)) {
        byDevice->forget();
    }
    if (translucent != nullptr) {
        translucent->forget();
    }
}

} // namespace cdr::render
