#include <cdr/depth/view_constants.h>
#include <cdr/platform/stopwatch.h>
#include <cdr/render/draw_source.h>
#include <cdr/render/geometry/geometry_pipelines.h>
#include <cdr/render/view_transform.h>
#include <cdr/scene/camera.h>

#include <rivals/frame_draws.h>

#include <algorithm>
#include <array>
#include <utility>

namespace cdr::rivals {

namespace {

constexpr std::uint32_t kRecordBinding = 1;

/// Whether ids and distances of both may come from one draw command: materials do not matter.
bool drawAlike(const render::DrawKind& one, const render::DrawKind& other) {
    return one.mesh == other.mesh && one.doubleSided == other.doubleSided && one.mirrored == other.mirrored;
}

} // namespace

FrameDraws::FrameDraws(const gpu::Device& device, const render::DrawnScene& scene,
                       const depth::Technique& technique, vk::Extent2D extent, platform::WorkerPool& workers)
    : m_device(device),
      m_scene(scene),
      m_mapping(technique.mapping),
      m_extent(extent),
      m_workers(workers),
      m_split(technique) {}

void FrameDraws::prepare(const scene::Camera& camera, render::FrameStats& stats) {
    scene::requireUsable(camera);
    platform::Stopwatch watch;
    m_view.camera = camera;
    m_view.frustum = scene::frustumOf(camera, m_extent.width, m_extent.height);
    visibility::cullCells(m_scene.uploaded.cells(m_workers), camera, m_view.frustum, m_workers, m_visible);
    stats.times.cullMs = watch.lap();
    cut();
    stats.times.splitMs = watch.lap();
    const depth::Cascades clipRanges = m_view.clipRanges();
    m_binner.bin(m_visible, clipRanges, render::wideSpan(m_mapping, clipRanges.size()), m_workers, m_lists);
    stats.visible = m_lists.visible;
    stats.draws = m_lists.draws();
    stats.duplication = m_lists.duplication();
    stats.times.binMs = watch.lap();
    gpu::growRecords(m_device, m_records, m_lists.draws(), sizeof(shaders::VisibilityRecord), "draws");
    writeRecords();
}

void FrameDraws::cut() {
    const depth::Cascades ranges = m_split.cut(m_view.camera, m_view.frustum, std::array{&m_visible}, {});
    m_view.cascades = render::cascadeViews(m_mapping, ranges, ranges, m_split.farEnd(), m_extent);
    m_view.drawn = {0, ranges.size()};
}

void FrameDraws::writeRecords() {
    const auto records = m_records.as<shaders::VisibilityRecord>(m_lists.draws());
    const render::UploadedScene& scene = m_scene.uploaded;
    for (std::size_t cascade = 0; cascade < m_view.cascades.size(); ++cascade) {
        const double anchorView = m_view.cascades[cascade].terms.anchorView;
        render::DrawRecordMaker maker(m_view.camera, anchorView);
        const platform::IndexRange draws = m_lists.range(cascade);
        for (std::size_t i = draws.begin; i < draws.end; ++i) {
            const render::DrawSource& source = scene.sources()[m_lists.instance[i]];
            const shaders::DrawRecord record = maker.make(source, scene.materials()[source.material]);
            const double ahead = m_view.camera.viewDistance(source.position) - anchorView;
            records[i] = {.right = record.right,
                          .up = record.up,
                          .ahead = record.ahead,
                          .id = record.id & shaders::kIdMask,
                          .aheadRest = static_cast<float>(ahead - static_cast<double>(record.ahead.w)),
                          .unused0 = 0,
                          .unused1 = 0};
        }
    }
    m_records.flush();
}

void FrameDraws::begin(vk::CommandBuffer commands) const {
    commands.setViewport(0, vk::Viewport{0.0f, 0.0f, static_cast<float>(m_extent.width),
                                         static_cast<float>(m_extent.height), 0.0f, 1.0f});
    commands.setScissor(0, vk::Rect2D{{0, 0}, m_extent});
    commands.bindVertexBuffers(0, {m_scene.uploaded.vertices(), m_records.handle()}, {0, 0});
    commands.bindIndexBuffer(m_scene.uploaded.indices(), 0, vk::IndexType::eUint32);
}

void FrameDraws::record(vk::CommandBuffer commands, std::size_t cascade, const DrawPipelines& pipelines,
                        const shaders::RivalPush& push) const {
    const render::UploadedScene& scene = m_scene.uploaded;
    const auto kindOf = [&](std::size_t draw) { return scene.sources()[m_lists.instance[draw]].kind; };
    commands.pushConstants<shaders::CascadePush>(pipelines.layout, kStages, 0,
                                                 render::makeCascadePush(m_view, cascade));
    commands.pushConstants<shaders::RivalPush>(pipelines.layout, kStages, sizeof(shaders::CascadePush), push);
    const platform::IndexRange draws = m_lists.range(cascade);
    const std::size_t wideBegin = m_lists.wideBegin(cascade);
    vk::Pipeline bound;
    for (std::size_t first = draws.begin; first < draws.end;) {
        const bool isWide = first >= wideBegin;
        const std::size_t limit = isWide ? draws.end : std::min(wideBegin, draws.end);
        std::size_t end = first + 1;
        while (end < limit && (kindOf(end) == kindOf(first) ||
                               drawAlike(scene.kinds()[kindOf(end)], scene.kinds()[kindOf(first)]))) {
            ++end;
        }
        const vk::Pipeline pipeline = isWide ? pipelines.wide : pipelines.compact;
        if (pipeline != std::exchange(bound, pipeline)) {
            commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline);
        }
        const render::DrawKind& kind = scene.kinds()[kindOf(first)];
        commands.setCullMode(kind.doubleSided ? vk::CullModeFlagBits::eNone : vk::CullModeFlagBits::eBack);
        commands.setFrontFace(kind.mirrored ? vk::FrontFace::eClockwise : vk::FrontFace::eCounterClockwise);
        commands.drawIndexed(kind.mesh.indexCount, static_cast<std::uint32_t>(end - first),
                             kind.mesh.firstIndex, kind.mesh.vertexOffset, static_cast<std::uint32_t>(first));
        first = end;
    }
}

std::vector<vk::VertexInputBindingDescription> FrameDraws::bindings() {
    return {render::vertexBinding(),
            {.binding = kRecordBinding,
             .stride = sizeof(shaders::VisibilityRecord),
             .inputRate = vk::VertexInputRate::eInstance}};
}

std::vector<vk::VertexInputAttributeDescription> FrameDraws::attributes() {
    using shaders::VisibilityRecord;
    constexpr auto kRow = vk::Format::eR32G32B32A32Sfloat;
    return {render::vertexAttributes().front(), // the place alone
            {4, kRecordBinding, kRow, offsetof(VisibilityRecord, right)},
            {5, kRecordBinding, kRow, offsetof(VisibilityRecord, up)},
            {6, kRecordBinding, kRow, offsetof(VisibilityRecord, ahead)},
            {7, kRecordBinding, vk::Format::eR32G32Uint, offsetof(VisibilityRecord, id)}};
}

vk::PushConstantRange FrameDraws::pushRange() {
    return {.stageFlags = kStages, .size = sizeof(shaders::CascadePush) + sizeof(shaders::RivalPush)};
}

} // namespace cdr::rivals
