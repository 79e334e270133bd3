#include <cdr/base/error.h>
#include <cdr/gpu/pipeline.h>
#include <cdr/render/renderer.h>
#include <cdr/render/view_transform.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cdr::render {

namespace {

/// Times one stage after the other.
class Stopwatch {
  public:
    explicit Stopwatch(base::Trace* trace) : m_trace(trace) {}

    /// Milliseconds since the last call; they were `stage`.
    double lap(const char* stage) {
        const auto now = base::Trace::Clock::now();
        const auto last = std::exchange(m_last, now);
        if (m_trace != nullptr) {
            m_trace->addStage(stage, last, now);
        }
        return std::chrono::duration<double, std::milli>(now - last).count();
    }

  private:
    base::Trace* m_trace;
    base::Trace::Clock::time_point m_last = base::Trace::Clock::now();
};

vk::Extent2D checkedExtent(const gpu::Device& device, const RenderOptions& options) {
    const std::uint32_t most = device.info().maxImageSide;
    for (const std::uint32_t side : {options.width, options.height}) {
        if (side < 1 || side > most) {
            throw base::InputError(fmt::format("size {}x{}: each side must be 1 to {} pixels on {}",
                                               options.width, options.height, most, device.info().name));
        }
    }
    const vk::Extent2D extent{options.width, options.height};
    constexpr std::uint64_t kDepthBytes = 4;
    gpu::requireDeviceBytes(device,
                            predictGBufferBytes(extent) + ShadingPass::predictBytes(extent) +
                                std::uint64_t{extent.width} * extent.height * kDepthBytes,
                            fmt::format("a {}x{} picture", extent.width, extent.height));
    return extent;
}

std::vector<double> anchorsOf(const std::vector<CascadeDraws>& cascades) {
    std::vector<double> anchors;
    for (const CascadeDraws& cascade : cascades) {
        anchors.push_back(cascade.anchorView);
    }
    return anchors;
}

} // namespace

struct Renderer::Staged {
    Lens lens;
    depth::Cascades cascades;
    std::vector<CascadeDraws> draws;
};

Renderer::Renderer(const gpu::Device& device, const scene::Scene& scene, const GpuScene& gpuScene,
                   const RenderOptions& options)
    : m_device(device),
      m_scene(scene),
      m_gpuScene(gpuScene),
      m_options(options),
      m_extent(checkedExtent(device, options)),
      m_aspect(static_cast<double>(options.width) / static_cast<double>(options.height)),
      m_split(options.technique, options.height),
      m_workers(options.threads),
      m_geometry(device, gpuScene, options.technique),
      m_targets(makeTargets(device, options.targets,
                            {.extent = m_extent,
                             .depthFormat = m_geometry.depthFormat(),
                             .reversedDepth = depth::isReversed(options.technique.mapping)})),
      m_shading(device, scene, m_targets->gbuffer(), m_extent),
      m_colorCopy(device, m_extent, sizeof(image::Rgba8), "color copy"),
      m_surfaceCopy(device, m_extent, sizeof(Surface), "surface copy"),
      m_recorder(device, options.threads, "frame"),
      m_primaryPool(device, vk::CommandBufferLevel::ePrimary, "frame") {
    m_workers.setTrace(options.trace);
}

void Renderer::stage(const scene::Camera& camera, Staged& staged, FrameStats& stats) {
    Stopwatch watch(m_options.trace);
    scene::cullSpheres(m_scene.instances, camera, m_aspect, m_workers, m_visible);
    stats.times.cullMs = watch.lap("cull");

    staged.lens = lensOf(camera, m_aspect);
    staged.cascades = m_split.cut(camera, m_visible);
    depth::Cascades clipRanges;
    for (std::size_t i = 0; i < staged.cascades.size(); ++i) {
        clipRanges.push_back(depth::clipRange(m_options.technique.mapping, staged.cascades, i));
        const depth::ClipTerms terms =
            clipTerms(depthRange(m_options.technique.mapping, staged.cascades, i, m_split.farEnd()));
        const DepthSlice slice = m_targets->depthSlice(i, staged.cascades.size());
        staged.draws.push_back({.anchorView = terms.anchorView,
                                .push = makeCascadePush(terms, clipRanges[i], staged.lens, slice,
                                                        static_cast<std::uint32_t>(i))});
    }
    stats.times.splitMs = watch.lap("split");

    scene::binByDistance(m_visible, clipRanges, m_geometry.wideSpan(staged.cascades.size()), m_workers,
                         m_lists);
    stats.times.binMs = watch.lap("bin");
    stats.visible = m_lists.visible;
    stats.draws = m_lists.draws();
    stats.duplication = m_lists.duplication();
}

void Renderer::growRecords(std::size_t draws) {
    const std::size_t capacity = m_records.size() / sizeof(shaders::DrawRecord);
    if (m_recordSet && draws <= capacity) {
        return;
    }
    // Half as many again, so that a camera that turns does not make a new buffer at every frame.
    const std::size_t bytes = std::max<std::size_t>(draws + draws / 2, 1024) * sizeof(shaders::DrawRecord);
    if (bytes > m_device.info().maxStorageBufferBytes) {
        throw base::RunError(fmt::format("{} draws need a {} byte buffer, {} allows {}", draws, bytes,
                                         m_device.info().name, m_device.info().maxStorageBufferBytes));
    }
    m_records = gpu::Buffer(m_device, bytes, vk::BufferUsageFlagBits::eStorageBuffer,
                            gpu::MemoryUse::hostWrites, "draw records");
    m_recordPool = gpu::makeDescriptorPool(m_device, 1, 1, {vk::DescriptorType::eStorageBuffer});
    m_recordSet = m_geometry.makeRecordSet(m_device, *m_recordPool, m_records.handle());
}

vk::CommandBuffer Renderer::recordPrimary(std::size_t cascades, Destination destination) {
    m_primaryPool.reset();
    const vk::CommandBuffer primary = m_primaryPool.next();
    primary.begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    m_targets->record(primary, m_recorder, cascades);
    m_shading.record(primary);
    if (destination == Destination::host) {
        recordReadback(primary);
    }
    primary.end();
    return primary;
}

void Renderer::recordReadback(vk::CommandBuffer primary) const {
    const gpu::Image& gbuffer = m_targets->gbuffer();
    m_device.beginLabel(primary, "read-back");
    gpu::pipelineBarrier(
        primary, {gpu::imageBarrier(
                     gbuffer.handle(), vk::ImageAspectFlagBits::eColor,
                     vk::PipelineStageFlagBits2::eFragmentShader, vk::AccessFlagBits2::eShaderSampledRead,
                     vk::PipelineStageFlagBits2::eCopy, vk::AccessFlagBits2::eTransferRead,
                     vk::ImageLayout::eShaderReadOnlyOptimal, vk::ImageLayout::eTransferSrcOptimal)});
    m_colorCopy.record(primary, m_shading.picture());
    m_surfaceCopy.record(primary, gbuffer);
    recordHostBarrier(primary);
    m_device.endLabel(primary);
}

Frame Renderer::render(const scene::Camera& camera) {
    Staged staged;
    const FrameStats stats = run(camera, staged, Destination::host);
    Frame frame = fetch(staged);
    frame.camera = camera;
    frame.stats = stats;
    return frame;
}

FrameStats Renderer::draw(const scene::Camera& camera) {
    Staged staged;
    return run(camera, staged, Destination::device);
}

FrameStats Renderer::run(const scene::Camera& camera, Staged& staged, Destination destination) {
    scene::requireUsable(camera);
    FrameStats stats;
    stage(camera, staged, stats);
    growRecords(m_lists.draws());
    m_shading.update(m_scene, camera, staged.lens, anchorsOf(staged.draws));

    Stopwatch watch(m_options.trace);
    m_recorder.record(m_workers, m_geometry,
                      {.camera = camera,
                       .lists = m_lists,
                       .cascades = staged.draws,
                       .records = m_records.as<shaders::DrawRecord>(m_lists.draws()),
                       .recordSet = m_recordSet,
                       .extent = m_extent,
                       .batching = m_options.batching,
                       .trace = m_options.trace});
    m_records.flush();
    const vk::CommandBuffer primary = recordPrimary(staged.cascades.size(), destination);
    stats.times.recordMs = watch.lap("record");
    gpu::submitAndWait(m_device, primary);
    stats.times.executeMs = watch.lap("execute");
    return stats;
}

Frame Renderer::fetch(const Staged& staged) const {
    Frame frame;
    frame.cascades = staged.cascades;
    frame.anchorsView = anchorsOf(staged.draws);
    frame.color = m_colorCopy.fetch<image::Rgba8>();
    frame.surfaces = m_surfaceCopy.fetch<Surface>();
    return frame;
}

} // namespace cdr::render
