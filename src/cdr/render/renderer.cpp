#include "frame_slot.h"

#include <cdr/base/error.h>
#include <cdr/gpu/commands.h>
#include <cdr/host/stage_watch.h>
#include <cdr/render/choose_facets.h>
#include <cdr/render/output/host_commands.h>
#include <cdr/render/renderer_setup.h>
#include <cdr/render/shading/finish.h>
#include <cdr/visibility/cull_cells.h>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace cdr::render {

namespace {

/// Whether surfaces are drawn by facets: for whoever reads them also where they are lit while they are drawn.
bool hasFacets(const RenderOptions& options) {
    return options.surface != SurfacePath::gbuffer;
}

const GpuScene& fixed(const GpuScene& gpuScene, const scene::Scene& scene) {
    if (gpuScene.isLive()) {
        throw base::InputError(
            "the scene of a world changes: give its GpuScene to the renderer without its scene");
    }
    if (&gpuScene.scene() != &scene) {
        throw base::InputError("the GpuScene was made of another scene than the renderer is to draw");
    }
    return gpuScene;
}

/// Up to date, so that what is made from it is.
const GpuScene& followed(GpuScene& live) {
    live.update();
    return live;
}

std::variant<std::unique_ptr<Targets>, std::unique_ptr<FocusLayers>>
makeOwnTargets(const gpu::Device& device, const DrawnScene& drawn, const RenderOptions& options,
               const KeptSurfaces& kept, const Picture& picture) {
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

/// Of the materials that a renderer is prepared for.
std::vector<std::uint32_t> blendedVariants(const PrepareFor& prepared) {
    std::vector<scene::Material> blended;
    std::copy_if(
        prepared.materials.begin(), prepared.materials.end(), std::back_inserter(blended),
        [](const scene::Material& material) { return material.alphaMode == scene::AlphaMode::blend; });
    return variantsOf(blended);
}

} // namespace

Renderer::Passes::Passes(const gpu::Device& device, const DrawnScene& drawn, const RenderOptions& options,
                         const Needs& needs)
    : extent(checkedExtent(device, options, needs.traits())),
      litTargets(makeLitTargets(device, extent, options)),
      picture(device, pictureOptions(extent, options, needs.traits(), daylightIf(needs.sky || needs.air)),
              litTargets != nullptr ? &litTargets->gbuffer() : nullptr),
      ownTargets(makeOwnTargets(device, drawn, options, {needs.metallicRoughness, needs.emission}, picture)),
      targets(std::visit([](const auto& own) -> Targets& { return *own; }, ownTargets)),
      cutter(options, targets),
      shadows(options.shadows.isOn()
                  ? std::make_unique<ShadowPass>(device, drawn, targets.gbuffer(), options.shadows)
                  : nullptr),
      shading(device, targets.gbuffer(), picture.lit(),
              {.effects = options.effects,
               .metallicRoughness = needs.metallicRoughness,
               .anchored = depth::isAnchored(options.technique.mapping),
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
      resolve(hasFacets(options) ? std::make_unique<ResolvePass>(device, targets.gbuffer()) : nullptr),
      translucent(needs.blended ? std::make_unique<TranslucentPass>(
                                      device, drawn, targets.gbuffer(), picture.lit(), options.translucency,
                                      options.shadows, blendedVariants(options.prepareFor))
                                : nullptr),
      motion(options.motion ? std::make_unique<MotionPass>(device, gbuffer()) : nullptr),
      readback(device, extent, options) {}

Renderer::Renderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
                   const RenderOptions& options)
    : Renderer(device, scene, fixed(gpuScene, scene), nullptr, options) {}

Renderer::Renderer(const gpu::Device& device, GpuScene& live, const RenderOptions& options)
    : Renderer(device, live.scene(), followed(live), &live, options) {}

Renderer::Renderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
                   GpuScene* live, const RenderOptions& options)
    : m_device(device),
      m_live(live),
      m_drawn{.scene = scene, .uploaded = gpuScene},
      m_options(options),
      m_workers(options.threads, options.placement),
      m_needs(needs()),
      m_revision(gpuScene.revision()),
      m_motion(options.motion ? std::make_unique<MotionHistory>() : nullptr),
      m_visible(std::make_unique<visibility::VisibleCells>()) {
    m_workers.setTrace(options.trace);
    if (options.schedule) {
        m_workers.setSchedule(*options.schedule);
    }
    checkedExtent(device, options, m_needs.traits());
    if (options.motion && live != nullptr) {
        live->keepLastVertices();
    }
    m_paths = std::make_unique<DrawPathFactory>(device, m_drawn, chooseFacets(m_drawn, options), options,
                                                KeptSurfaces{m_needs.metallicRoughness, m_needs.emission});
    makePasses();
}

void Renderer::makePasses() {
    auto made = std::make_unique<Passes>(m_device, m_drawn, m_options, m_needs);
    made->lightRoom = std::max<std::size_t>(m_drawn.scene.lights.size(), m_options.prepareFor.lights);
    if (m_options.occlusionCulling && m_options.submission == Submission::gpuDriven) {
        made->occlusion = m_paths->makeDeviceOcclusion(m_options.technique, made->extent);
    } else if (m_options.occlusionCulling) {
        made->occlusion = std::make_unique<OcclusionCulling>(m_device, m_drawn, m_options.technique,
                                                             made->extent, m_paths->makeOccluders(m_workers));
    }
    std::swap(m_passes, made);
    const std::size_t framesBefore = std::exchange(m_frames, 0);
    try {
        for (std::size_t slot = 0; slot < m_options.framesInFlight; ++slot) {
            Slot& begun = m_passes->slots.emplace_back();
            begun.path = m_paths->make(m_workers, findIn<DeviceOcclusion>(m_passes->occlusion),
                                       fmt::format("frame slot {}", slot));
            if (m_passes->litTargets != nullptr) {
                begun.readPath = std::move(begun.path);
                begun.path = m_paths->makeLit(m_workers, fmt::format("lit frame slot {}", slot));
            }
            begun.done = vk::Device(m_device.handle()).createFenceUnique({});
            if (m_options.deviceClock && gpu::DeviceClock::isThere(m_device)) {
                begun.clock.emplace(m_device, fmt::format("frame slot {}", slot));
            }
            begun.inputs = makeInputs(m_passes->lightRoom);
        }
    } catch (...) {
        std::swap(m_passes, made);
        m_frames = framesBefore;
        throw;
    }
}

std::unique_ptr<Renderer::SlotInputs> Renderer::makeInputs(std::size_t lightRoom) const {
    auto made = std::make_unique<SlotInputs>();
    made->shading = m_passes->shading.makeInputs(lightRoom);
    if (m_passes->resolve != nullptr) {
        made->resolve = m_passes->resolve->makeInputs(made->shading);
    }
    if (m_passes->shadows != nullptr) {
        made->shadows.emplace(m_passes->shadows->makeSlot(made->shading));
    }
    if (m_passes->motion != nullptr) {
        made->motion.emplace(m_passes->motion->makeInputs(made->shading));
    }
    if (m_passes->translucent != nullptr) {
        made->translucent.emplace(m_passes->translucent->makeSlot(made->shading));
    }
    return made;
}

Renderer::~Renderer() {
    try {
        finish();
    } catch (...) {
        // Nobody waits for these frames any more; a lost device is reported where somebody does.
    }
}

void Renderer::forgetFrames() {
    m_passes->cutter.forget();
    if (auto* byCpu = findIn<OcclusionCulling>(m_passes->occlusion)) {
        byCpu->forget();
    }
    if (auto* byDevice = findIn<DeviceOcclusion>(m_passes->occlusion)) {
        byDevice->forget();
    }
    if (m_motion != nullptr) {
        m_motion->forget();
    }
    if (m_passes->translucent != nullptr) {
        m_passes->translucent->forget();
    }
}

void Renderer::skip(const scene::Camera& camera) {
    scene::requireUsable(camera);
    followScene();
    if (m_motion != nullptr) {
        m_motion->follow(m_drawn, camera);
    }
    if (m_passes->cutter.needsVisible()) {
        FrameView view = m_passes->cutter.look(camera);
        cull(view);
        m_passes->cutter.cut(view, *m_visible);
    }
}

void Renderer::cull(const FrameView& view) {
    visibility::cullCells(m_drawn.uploaded.cells(m_workers), view.camera, view.frustum, m_workers,
                          *m_visible);
}

bool Renderer::readsVisible(const Slot& slot) const {
    return slot.path->needsVisible() || m_passes->cutter.needsVisible() || slot.inputs->shadows;
}

Renderer::Slot& Renderer::slotOf(std::size_t frame) const {
    return m_passes->slots[frame % m_passes->slots.size()];
}

void Renderer::settle(Slot& slot) {
    while (slot.isPending) {
        if (slot.recorded) {
            gpu::waitForTimeline(m_device, slot.recorded->timeline, slot.recorded->value);
        } else {
            gpu::waitAndReset(m_device, *slot.done);
            if (slot.clock) {
                slot.stats.times.deviceMs = slot.clock->lastMs();
            }
        }
        slot.isPending = false;
        // A frame that was submitted without a wait cannot be drawn again once the scene changed. It must not
        // be drawn over the images of a later one. One that a host recorded has gone into the host's images.
        const bool isCurrent = m_drawn.uploaded.isCurrent() && slot.revision == m_drawn.uploaded.revision();
        const bool isLast = &slot == &slotOf(m_frames - 1);
        if (!hasRoomSufficed(slot) && isCurrent && isLast && !slot.recorded) {
            if (slot.path->needsVisible()) {
                cull(slot.view); // by now the list may be a later frame's
            }
            if (slot.inputs->translucent) {
                m_passes->translucent->prepareAgain(*slot.inputs->translucent, slot.view, m_workers);
            }
            launch(slot, {.destination = slot.destination});
        }
    }
}

bool Renderer::hasRoomSufficed(Slot& slot) {
    const bool opaqueSufficed = slot.path->settle(slot.stats);
    const bool blendedSufficed =
        !slot.inputs->translucent ||
        m_passes->translucent->settle(*slot.inputs->translucent, slot.stats.translucency);
    return opaqueSufficed && blendedSufficed;
}

Renderer::Slot& Renderer::run(const scene::Camera& camera, const Delivery& delivery) {
    Slot& slot = prepare(camera, delivery);
    try {
        launch(slot, delivery);
    } catch (...) {
        abandon(slot);
        throw;
    }
    commit(slot);
    return slot;
}

void Renderer::commit(Slot& slot) {
    slot.before = {};
    ++m_frames;
}

void Renderer::abandon(Slot& slot) {
    slot.view = std::move(slot.before.view);
    slot.stats = slot.before.stats;
    slot.destination = slot.before.destination;
    m_passes->cutter.takeBack(std::move(slot.before.cut));
    if (slot.before.isMotionFollowed) {
        m_motion->forget();
    }
}

Renderer::Slot& Renderer::prepare(const scene::Camera& camera, const Delivery& delivery) {
    m_mayDrop = false;
    scene::requireUsable(camera);
    followScene();
    Slot& slot = slotOf(m_frames);
    settle(slot);
    slot.before = {.view = std::move(slot.view),
                   .stats = slot.stats,
                   .destination = slot.destination,
                   .cut = m_passes->cutter.previous(),
                   .isMotionFollowed = false};
    try {
        decide(slot, camera, delivery);
    } catch (...) {
        abandon(slot);
        throw;
    }
    return slot;
}

void Renderer::decide(Slot& slot, const scene::Camera& camera, const Delivery& delivery) {
    slot.revision = m_revision;
    host::StageWatch watch(m_options.trace);
    slot.view = m_passes->cutter.look(camera);
    if (delivery.shared == nullptr && readsVisible(slot)) {
        cull(slot.view);
    }
    slot.stats = {};
    slot.stats.lostMetallicRoughness =
        m_drawn.uploaded.hasMetallicRoughness() && !keepsMetallicRoughness(m_options);
    slot.stats.lostEmission = m_drawn.uploaded.hasEmission() && !keepsEmission(m_options);
    slot.stats.times.cullMs = watch.lap("cull");
    if (delivery.shared != nullptr) {
        m_passes->cutter.take(slot.view, *delivery.shared);
    } else {
        m_passes->cutter.cut(slot.view, *m_visible,
                             delivery.host != nullptr
                                 ? std::span<const depth::Interval>(delivery.host->occupied)
                                 : std::span<const depth::Interval>());
    }
    slot.inputs->shading.update(m_drawn.scene, camera, slot.view.frustum, slot.view.anchorsView());
    if (slot.inputs->motion) {
        slot.before.isMotionFollowed = true;
        m_passes->motion->update(*slot.inputs->motion, m_drawn, slot.view, m_motion->follow(m_drawn, camera));
    }
    slot.stats.times.splitMs = watch.lap("split");
    if (slot.inputs->shadows) {
        m_passes->shadows->prepare(*slot.inputs->shadows, slot.view, *m_visible,
                                   subPixelBits(m_device, m_options), m_workers);
        slot.stats.shadows = {.maps = slot.inputs->shadows->views.size(),
                              .casters = slot.inputs->shadows->casters.draws()};
        slot.stats.times.shadowsMs = watch.lap("shadows");
    }
    if (auto* byCpu = findIn<OcclusionCulling>(m_passes->occlusion)) {
        slot.stats.occluders = byCpu->drop(slot.view, m_workers, *m_visible);
        slot.stats.times.occludersMs = watch.lap("occluders");
    }
    if (slot.inputs->translucent) {
        using AfterRefusal = TranslucentPass::AfterRefusal;
        m_passes->translucent->prepare(*slot.inputs->translucent, slot.view,
                                       delivery.isAwaited ? AfterRefusal::sorted : AfterRefusal::weighted,
                                       subPixelBits(m_device, m_options), m_workers);
        if (slot.inputs->translucent->shadows) {
            slot.stats.shadows.maps += slot.inputs->translucent->shadows->maps();
            slot.stats.shadows.casters += slot.inputs->translucent->shadows->casters();
        }
        slot.stats.times.translucentMs = watch.lap("translucent draws");
    }
}

Frame Renderer::render(const scene::Camera& camera, FrameCopy copy) {
    Slot& slot =
        run(camera, {.destination = copy == FrameCopy::color ? Destination::hostColor : Destination::host,
                     .isAwaited = true});
    waitFor(slot);
    return fetch(slot);
}

FrameStats Renderer::draw(const scene::Camera& camera) {
    Slot& slot = run(camera, {.isAwaited = true});
    waitFor(slot);
    return slot.stats;
}

void Renderer::submit(const scene::Camera& camera, const FrameSync& sync) {
    run(camera, {.sync = sync});
}

void Renderer::requireRecordable(const HostFrame& frame) {
    render::requireRecordable(m_device, m_options, frame);
    followScene(); // what was added may emit light
    if (frame.draw && m_needs.emission) {
        throw base::InputError(
            "a host cannot draw beside surfaces that emit light or have occlusion textures");
    }
}

void Renderer::record(const scene::Camera& camera, const HostFrame& frame) {
    m_mayDrop = false; // the frame before was submitted
    requireRecordable(frame);
    run(camera, {.host = &frame});
}

void Renderer::resize(std::uint32_t width, std::uint32_t height) {
    finish();
    RenderOptions resized = m_options;
    resized.width = width;
    resized.height = height;
    remake(m_needs, resized);
}

void Renderer::finish() {
    const std::size_t slots = m_passes->slots.size();
    for (std::size_t age = slots; age-- > 0;) { // in the order in which they were submitted
        if (age < m_frames) {
            settle(slotOf(m_frames - 1 - age));
        }
    }
}

void Renderer::waitFor(Slot& slot) {
    settle(slot);
    const auto done = host::Trace::Clock::now();
    slot.stats.times.executeMs = host::millisecondsBetween(slot.submitted, done);
    if (m_options.trace != nullptr) {
        m_options.trace->addStage("execute", slot.submitted, done);
    }
}

} // namespace cdr::render
