#include "frame_slot.h"

#include <cdr/gpu/commands.h>
#include <cdr/render/renderer_setup.h>
#include <cdr/render/targets/focus_layers.h>
#include <cdr/visibility/blended.h>

#include <fmt/format.h>

#include <utility>

namespace cdr::render {

namespace {

double millisecondsBetween(host::Trace::Clock::time_point begin, host::Trace::Clock::time_point end) {
    return std::chrono::duration<double, std::milli>(end - begin).count();
}

/// Times one stage after the other.
class Stopwatch {
  public:
    explicit Stopwatch(host::Trace* trace) : m_trace(trace) {}

    /// Milliseconds since the last call; they were `stage`.
    double lap(const char* stage) {
        const auto now = host::Trace::Clock::now();
        const auto last = std::exchange(m_last, now);
        if (m_trace != nullptr) {
            m_trace->addStage(stage, last, now);
        }
        return millisecondsBetween(last, now);
    }

  private:
    host::Trace* m_trace;
    host::Trace::Clock::time_point m_last = host::Trace::Clock::now();
};

} // namespace

Renderer::Renderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
                   const RenderOptions& options)
    : m_device(device),
      m_blended(visibility::blendedInstances(scene)),
      m_drawn{.scene = scene, .uploaded = gpuScene, .blended = m_blended},
      m_options(options),
      m_extent(checkedExtent(device, options, !m_blended.empty())),
      m_workers(options.threads, options.placement),
      m_lostShine(losesShine(gpuScene, options)),
      m_shiny(gpuScene.isShiny() && !m_lostShine),
      m_paths(device, m_drawn, options, m_shiny),
      m_picture(device, pictureOptions(m_extent, options, !m_blended.empty())),
      m_ownTargets(makeOwnTargets()),
      m_targets(std::visit([](const auto& own) -> Targets& { return *own; }, m_ownTargets)),
      m_cutter(options, m_targets),
      m_shading(device, m_targets.gbuffer(), m_picture.lit(),
                {.effects = options.effects,
                 .shiny = m_shiny,
                 .anchored = depth::isAnchored(options.technique.mapping),
                 .lights = static_cast<std::uint32_t>(scene.lights.size())}),
      m_translucent(m_blended.empty()
                        ? nullptr
                        : std::make_unique<TranslucentPass>(device, m_drawn, m_targets.gbuffer(),
                                                            m_picture.lit(), options.translucency)),
      m_colorCopy(device, m_extent, sizeof(image::Rgba8), "color copy"),
      m_gbufferCopy(device, m_extent, sizeof(GBufferPixel), "G-buffer copy") {
    m_workers.setTrace(options.trace);
    for (std::size_t slot = 0; slot < options.framesInFlight; ++slot) {
        Slot& made = m_slots.emplace_back();
        made.path = m_paths.make(m_workers, fmt::format("frame slot {}", slot));
        made.shading = m_shading.makeInputs(scene);
        if (m_translucent != nullptr) {
            made.translucent.emplace(m_translucent->makeSlot(made.shading));
        }
        made.done = device.handle().createFenceUnique({});
    }
}

Renderer::~Renderer() {
    try {
        finish();
    } catch (...) {
        // Nobody waits for these frames any more; a lost device is reported where somebody does.
    }
}

Renderer::OwnedTargets Renderer::makeOwnTargets() const {
    const TargetsOptions options = targetsOptions(m_extent, m_options);
    if (!m_options.focus.isOn()) {
        return makeTargets(m_device, m_options.targets, options);
    }
    return std::make_unique<FocusLayers>(m_device, options, m_picture.lit(),
                                         FocusLayersOptions{.effects = m_options.effects,
                                                            .background = m_drawn.scene.background,
                                                            .fades = m_options.focus.blend,
                                                            .shiny = m_shiny});
}

void Renderer::cull(const FrameView& view) {
    visibility::cullSpheres(m_drawn.scene.instances, view.camera, view.frustum, m_workers, m_visible);
    if (!m_blended.empty()) {
        visibility::removeInstances(m_blended, m_visible);
    }
}

Renderer::Slot& Renderer::nextSlot() {
    Slot& slot = m_slots[m_frames++ % m_slots.size()];
    settle(slot);
    return slot;
}

void Renderer::launch(Slot& slot, Destination destination) {
    Stopwatch watch(m_options.trace);
    slot.destination = destination;
    slot.path->bin(slot.view, m_visible, slot.stats);
    slot.stats.times.binMs = watch.lap("bin");
    slot.path->begin(slot.view);
    m_targets.record(*slot.path, slot.view);
    shade(slot);
    if (slot.translucent) {
        m_translucent->record(slot.path->primary(), *slot.translucent);
    }
    m_picture.finish(slot.path->primary());
    if (destination != Destination::device) {
        recordReadback(slot.path->primary(), destination);
    }
    const std::span<const vk::CommandBuffer> commands = slot.path->end(slot.view);
    slot.stats.times.recordMs = watch.lap("record");
    slot.submitted = host::Trace::Clock::now();
    gpu::submit(m_device, commands, *slot.done);
    slot.isPending = true;
}

void Renderer::shade(Slot& slot) {
    if (const auto* focus = std::get_if<std::unique_ptr<FocusLayers>>(&m_ownTargets)) {
        (*focus)->light(slot.path->primary(), slot.shading, slot.focus);
    } else {
        m_shading.record(slot.path->primary(), slot.shading);
    }
}

void Renderer::settle(Slot& slot) {
    while (slot.isPending) {
        gpu::waitAndReset(m_device, *slot.done);
        slot.isPending = false;
        if (!hasRoomSufficed(slot)) {
            if (slot.path->needsVisible()) {
                cull(slot.view); // by now the list may be a later frame's
            }
            launch(slot, slot.destination);
        }
    }
}

bool Renderer::hasRoomSufficed(Slot& slot) {
    const bool opaqueSufficed = slot.path->settle(slot.stats);
    const bool blendedSufficed =
        !slot.translucent || m_translucent->settle(*slot.translucent, slot.stats.translucency);
    return opaqueSufficed && blendedSufficed;
}

Renderer::Slot& Renderer::run(const scene::Camera& camera, Destination destination) {
    scene::requireUsable(camera);
    Slot& slot = nextSlot();
    Stopwatch watch(m_options.trace);
    slot.view = m_cutter.look(camera);
    if (slot.path->needsVisible() || m_cutter.needsVisible()) {
        cull(slot.view);
    }
    slot.stats = {};
    slot.stats.lostShine = m_lostShine;
    slot.stats.times.cullMs = watch.lap("cull");
    m_cutter.cut(slot.view, m_visible);
    slot.shading.update(m_drawn.scene, camera, slot.view.frustum, slot.view.anchorsView());
    slot.stats.times.splitMs = watch.lap("split");
    if (slot.translucent) {
        m_translucent->prepare(*slot.translucent, slot.view, m_workers);
        slot.stats.times.translucentMs = watch.lap("translucent draws");
    }
    launch(slot, destination);
    return slot;
}

Frame Renderer::render(const scene::Camera& camera, FrameCopy copy) {
    Slot& slot = run(camera, copy == FrameCopy::color ? Destination::hostColor : Destination::host);
    waitFor(slot);
    return fetch(slot);
}

FrameStats Renderer::draw(const scene::Camera& camera) {
    Slot& slot = run(camera, Destination::device);
    waitFor(slot);
    return slot.stats;
}

void Renderer::submit(const scene::Camera& camera) {
    run(camera, Destination::device);
}

void Renderer::finish() {
    for (Slot& slot : m_slots) {
        settle(slot);
    }
}

void Renderer::waitFor(Slot& slot) {
    settle(slot);
    const auto done = host::Trace::Clock::now();
    slot.stats.times.executeMs = millisecondsBetween(slot.submitted, done);
    if (m_options.trace != nullptr) {
        m_options.trace->addStage("execute", slot.submitted, done);
    }
}

void Renderer::recordReadback(vk::CommandBuffer primary, Destination destination) const {
    const gpu::Image& gbuffer = m_targets.gbuffer();
    m_device.beginLabel(primary, "read-back");
    m_colorCopy.record(primary, m_picture.encoded());
    if (destination == Destination::host) {
        gpu::pipelineBarrier(
            primary, {gpu::imageBarrier(
                         gbuffer.handle(), vk::ImageAspectFlagBits::eColor,
                         vk::PipelineStageFlagBits2::eFragmentShader, vk::AccessFlagBits2::eShaderSampledRead,
                         vk::PipelineStageFlagBits2::eCopy, vk::AccessFlagBits2::eTransferRead,
                         vk::ImageLayout::eShaderReadOnlyOptimal, vk::ImageLayout::eTransferSrcOptimal)});
        m_gbufferCopy.record(primary, gbuffer);
    }
    if (m_translucent != nullptr) {
        m_translucent->recordReadback(primary);
    }
    recordHostBarrier(primary);
    m_device.endLabel(primary);
}

Frame Renderer::fetch(const Slot& slot) const {
    Frame frame;
    frame.camera = slot.view.camera;
    frame.cascades = slot.view.ranges();
    frame.anchorsView = slot.view.anchorsView();
    frame.color = m_colorCopy.fetch<image::Rgba8>();
    if (slot.destination == Destination::host) {
        frame.gbuffer = m_gbufferCopy.fetch<GBufferPixel>();
    }
    if (m_translucent != nullptr) {
        frame.fragmentCounts = m_translucent->fragmentCounts();
    }
    frame.stats = slot.stats;
    return frame;
}

} // namespace cdr::render
