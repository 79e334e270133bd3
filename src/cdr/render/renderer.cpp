#include "frame_slot.h"

#include <cdr/gpu/commands.h>
#include <cdr/render/renderer_setup.h>
#include <cdr/render/submit/binning_pass.h>
#include <cdr/render/submit/gpu_driven_path.h>
#include <cdr/render/submit/primary_path.h>
#include <cdr/render/submit/secondary_path.h>
#include <cdr/render/targets/focus_layers.h>
#include <cdr/render/view_transform.h>

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

std::optional<scene::Instances> opaqueWhereBlended(const scene::Scene& scene) {
    return visibility::hasBlended(scene) ? std::optional(visibility::withoutBlended(scene)) : std::nullopt;
}

} // namespace

Renderer::Renderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
                   const RenderOptions& options)
    : m_device(device),
      m_scene(scene),
      m_opaque(opaqueWhereBlended(scene)),
      m_options(options),
      m_extent(checkedExtent(device, options, m_opaque.has_value())),
      m_aspect(static_cast<double>(options.width) / static_cast<double>(options.height)),
      m_split(options.technique, options.height),
      m_workers(options.threads, options.placement),
      m_note(noteOnShine(gpuScene, options)),
      m_shiny(gpuScene.isShiny() && m_note.empty()),
      m_geometry(device, gpuScene, options.technique, options.batching, m_shiny),
      m_binning(options.submission == Submission::gpuDriven
                    ? std::make_unique<BinningPass>(device, opaque(), gpuScene, options.detail.mode)
                    : nullptr),
      m_picture(device, pictureOptions(m_extent, options, m_opaque.has_value())),
      m_focus(options.focus.isOn() ? makeFocusLayers() : nullptr),
      m_plain(m_focus ? nullptr : makeTargets(device, options.targets, targetsOptions(m_extent, options))),
      m_targets(m_focus ? *m_focus : *m_plain),
      m_shading(device, m_targets.gbuffer(), m_picture.lit(),
                {.effects = options.effects,
                 .shiny = m_shiny,
                 .lights = static_cast<std::uint32_t>(scene.lights.size())}),
      m_translucent(m_opaque ? std::make_unique<TranslucentPass>(device, scene, gpuScene, m_targets.gbuffer(),
                                                                 m_picture.lit(), options.translucency)
                             : nullptr),
      m_colorCopy(device, m_extent, sizeof(image::Rgba8), "color copy"),
      m_gbufferCopy(device, m_extent, sizeof(GBufferPixel), "G-buffer copy") {
    m_workers.setTrace(options.trace);
    for (std::size_t slot = 0; slot < options.framesInFlight; ++slot) {
        Slot& made = m_slots.emplace_back();
        made.path = makePath(fmt::format("frame slot {}", slot));
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

std::unique_ptr<FocusLayers> Renderer::makeFocusLayers() const {
    return std::make_unique<FocusLayers>(m_device, targetsOptions(m_extent, m_options), m_picture.lit(),
                                         m_options.effects, m_scene.background, m_options.focus.blend,
                                         m_shiny);
}

std::unique_ptr<DrawPath> Renderer::makePath(const std::string& name) {
    if (m_binning != nullptr) {
        return std::make_unique<GpuDrivenPath>(m_device, *m_binning, m_geometry, name);
    }
    HostDraws draws(m_device, m_scene, m_geometry, m_workers, m_options.trace);
    if (m_options.submission == Submission::primaries) {
        return std::make_unique<PrimaryPath>(m_device, std::move(draws), name);
    }
    return std::make_unique<SecondaryPath>(m_device, std::move(draws), name);
}

void Renderer::cull(const scene::Camera& camera) {
    visibility::cullSpheres(opaque(), camera, m_aspect, m_workers, m_visible);
}

void Renderer::cut(const scene::Camera& camera, Slot& slot) {
    slot.camera = camera;
    slot.lens = lensOf(camera, m_aspect);
    slot.cascades = m_split.cut(camera, m_visible);
    std::optional<FocusLens> focus;
    if (m_focus) {
        focus.emplace(m_options.focus, slot.lens.tanY, m_extent.height);
    }
    const depth::Mapping mapping = m_options.technique.mapping;
    const depth::Cascades ranges =
        focus && m_options.focus.blend ? focus->overlapping(slot.cascades) : slot.cascades;
    slot.clipRanges.clear();
    slot.draws.clear();
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        slot.clipRanges.push_back(depth::clipRange(mapping, ranges, i));
        const depth::ClipTerms terms = clipTerms(depthRange(mapping, ranges, i, m_split.farEnd()));
        const DepthSlice slice = m_targets.depthSlice(i, ranges.size());
        slot.draws.push_back(
            {.anchorView = terms.anchorView,
             .push =
                 makeCascadePush(terms, slot.clipRanges[i], slot.lens, slice, static_cast<std::uint32_t>(i)),
             .extent = focus ? shrunk(m_extent, focus->scaleOf(slot.cascades[i])) : m_extent});
    }
}

Renderer::Slot& Renderer::nextSlot() {
    Slot& slot = m_slots[m_frames++ % m_slots.size()];
    settle(slot);
    return slot;
}

void Renderer::launch(Slot& slot, Destination destination) {
    Stopwatch watch(m_options.trace);
    const CutView view{.camera = slot.camera,
                       .aspect = m_aspect,
                       .visible = m_visible,
                       .clipRanges = slot.clipRanges,
                       .cascades = slot.draws,
                       .levels = visibility::levelRule(m_options.detail, slot.camera, m_extent.height)};
    slot.destination = destination;
    slot.path->bin(view, slot.stats);
    slot.stats.times.binMs = watch.lap("bin");
    slot.path->begin(view);
    m_targets.record(*slot.path, slot.draws);
    shade(slot);
    if (slot.translucent) {
        m_translucent->record(slot.path->primary(), *slot.translucent);
    }
    m_picture.finish(slot.path->primary());
    if (destination != Destination::device) {
        recordReadback(slot.path->primary(), destination);
    }
    const std::span<const vk::CommandBuffer> commands = slot.path->end(view);
    slot.stats.times.recordMs = watch.lap("record");
    slot.submitted = host::Trace::Clock::now();
    gpu::submit(m_device, commands, *slot.done);
    slot.isPending = true;
}

void Renderer::shade(Slot& slot) {
    if (m_focus) {
        m_focus->light(slot.path->primary(), slot.shading, slot.focus);
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
                cull(slot.camera); // by now the list may be a later frame's
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
    if (slot.path->needsVisible() || m_split.needsVisible()) {
        cull(camera);
    }
    slot.stats = {};
    slot.stats.note = m_note;
    slot.stats.times.cullMs = watch.lap("cull");
    cut(camera, slot);
    slot.shading.update(m_scene, camera, slot.lens, slot.anchorsView());
    slot.stats.times.splitMs = watch.lap("split");
    if (slot.translucent) {
        m_translucent->prepare(*slot.translucent, camera, slot.cascades, m_workers);
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
    frame.camera = slot.camera;
    frame.cascades = slot.cascades;
    frame.anchorsView = slot.anchorsView();
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
