#include <cdr/render/translucency/translucent_draws.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace cdr::render {

namespace {

/// What a draw has bound.
class Binder {
  public:
    /// @param layerSlope pixels by which two vertices are rounded apart.
    Binder(const TranslucentPipelines& pipelines, vk::CommandBuffer commands, float layerSlope)
        : m_pipelines(pipelines),
          m_commands(commands),
          m_layerSlope(layerSlope) {}

    void bind(const DrawKind& kind) {
        const vk::Pipeline pipeline = m_pipelines.pipeline(kind);
        if (pipeline != m_pipeline) {
            m_commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline);
            m_pipeline = pipeline;
        }
        m_commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, m_pipelines.layout(), 0,
                                      kind.textureSet, {});
        if (kind.detailSet) {
            m_commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, m_pipelines.layout(),
                                          m_pipelines.detailSet(), kind.detailSet, {});
        }
        if (kind.layer != m_layer) {
            m_commands.pushConstants<float>(m_pipelines.layout(), TranslucentPipelines::kStages,
                                            offsetof(shaders::TranslucentPush, layerOffset),
                                            {kind.layer.offset, kind.layer.rank * m_layerSlope});
            m_layer = kind.layer;
        }
        m_commands.setCullMode(kind.doubleSided ? vk::CullModeFlagBits::eNone : vk::CullModeFlagBits::eBack);
        m_commands.setFrontFace(kind.mirrored ? vk::FrontFace::eClockwise : vk::FrontFace::eCounterClockwise);
    }

  private:
    const TranslucentPipelines& m_pipelines;
    vk::CommandBuffer m_commands;
    float m_layerSlope;
    vk::Pipeline m_pipeline;
    LayerPlace m_layer; ///< as pushOf() has it
};

/// Whether distances and a slice may have some in common: those of fragments are floats, and may be rounded across an end.
bool haveCommon(const depth::Interval& distances, const shaders::TranslucentSlice& slice) {
    constexpr double kRounding = 1e-6;
    return distances.farView * (1.0 + kRounding) >= static_cast<double>(slice.nearView) &&
           distances.nearView * (1.0 - kRounding) <= static_cast<double>(slice.farView);
}

} // namespace

depth::Cascades translucentRanges(const FrameView& view, Translucency method) {
    if (method == Translucency::sorted) {
        return {{view.camera.nearView, view.camera.farView}};
    }
    depth::Cascades ranges;
    double nearView = view.camera.nearView;
    for (std::size_t i = 0; i < view.cascades.size(); ++i) {
        const bool isLast = i + 1 == view.cascades.size();
        const double farView = isLast ? view.camera.farView : view.cascades[i + 1].range.nearView;
        ranges.push_back({nearView, farView});
        nearView = farView;
    }
    return ranges;
}

TranslucentDraws::TranslucentDraws(const gpu::Device& device, const DrawnScene& scene)
    : m_device(device),
      m_scene(scene) {}

void TranslucentDraws::prepare(const FrameView& view, Translucency method, std::uint32_t subPixelBits,
                               platform::WorkerPool& workers) {
    m_subPixelBits = subPixelBits;
    m_ranges = translucentRanges(view, method);
    m_frustum = view.frustum;
    m_nearView = view.camera.nearView;
    visibility::cullSpheres(m_scene.scene.instances, m_scene.uploaded.blended(), view.camera, view.frustum,
                            m_visible);
    visibility::binByDistance(m_visible, m_ranges, std::numeric_limits<double>::infinity(), workers, m_lists);
    gpu::growRecords(m_device, m_records, m_lists.draws(), sizeof(shaders::TranslucentRecord),
                     "translucent draws");
    writeRecords(view.camera);
}

bool TranslucentDraws::meets(std::size_t range, const shaders::TranslucentSlice& slice) const {
    return haveCommon({m_ranges[range].nearView, m_ranges[range].farView}, slice);
}

bool TranslucentDraws::isIn(std::size_t draw, const shaders::TranslucentSlice* slice) const {
    return slice == nullptr || haveCommon(m_extents[draw], *slice);
}

void TranslucentDraws::writeRecords(const scene::Camera& camera) {
    const auto records = m_records.as<shaders::TranslucentRecord>(m_lists.draws());
    DrawRecordMaker maker(camera, 0.0);
    m_extents.resize(m_lists.draws());
    for (std::size_t range = 0; range < m_ranges.size(); ++range) {
        const platform::IndexRange draws = m_lists.range(range);
        for (std::size_t i = draws.begin; i < draws.end; ++i) {
            const DrawSource& source = m_scene.uploaded.sources()[m_lists.instance[i]];
            const shaders::DrawRecord record =
                maker.make(source, m_scene.uploaded.materials()[source.material]);
            const double centre = camera.viewDistance(source.position);
            const auto radius = static_cast<double>(m_scene.scene.instances.radius[m_lists.instance[i]]);
            m_extents[i] = {centre - radius, centre + radius};
            records[i] = {.right = record.right,
                          .up = record.up,
                          .ahead = record.ahead,
                          .centreRange = glm::vec4(splitDouble(centre),
                                                   static_cast<float>(m_ranges[range].nearView - centre),
                                                   static_cast<float>(m_ranges[range].farView - centre)),
                          .id = record.id,
                          .baseColorRg = record.baseColorRg,
                          .baseColorBa = record.baseColorBa,
                          .metallicRoughness =
                              record.cutoffAndMetallicRoughness & shaders::kMetallicRoughnessMask};
        }
    }
    m_records.flush();
}

shaders::TranslucentPush TranslucentDraws::pushOf(std::size_t range, vk::Extent2D extent,
                                                  std::uint32_t capacity) const {
    const depth::Cascade& ends = m_ranges[range];
    const glm::vec2 lens = clipLensShift(m_frustum);
    return {.projectionX = static_cast<float>(1.0 / m_frustum.tanX),
            .projectionY = static_cast<float>(-1.0 / m_frustum.tanY),
            .behind = static_cast<float>(0.5 * m_nearView),
            .nearView = static_cast<float>(ends.nearView),
            .spread = static_cast<float>(1.0 / std::log(ends.farView / ends.nearView)),
            .width = extent.width,
            .capacity = capacity,
            .layerOffset = 0.0f,
            .layerSlope = 0.0f,
            .lensX = lens.x,
            .lensY = lens.y};
}

void TranslucentDraws::record(vk::CommandBuffer commands, std::size_t range,
                              const TranslucentPipelines& pipelines, vk::Extent2D extent,
                              std::uint32_t capacity, const shaders::TranslucentSlice* slice) const {
    commands.setViewport(0, vk::Viewport{0.0f, 0.0f, static_cast<float>(extent.width),
                                         static_cast<float>(extent.height), 0.0f, 1.0f});
    commands.setScissor(0, vk::Rect2D{{0, 0}, extent});
    const UploadedScene& scene = m_scene.uploaded;
    commands.bindVertexBuffers(0, {scene.vertices(), m_records.handle()}, {0, 0});
    if (const vk::Buffer details = scene.details()) {
        commands.bindVertexBuffers(kDetailBinding, details, vk::DeviceSize{0});
    }
    commands.bindIndexBuffer(scene.indices(), 0, vk::IndexType::eUint32);
    commands.pushConstants<shaders::TranslucentPush>(pipelines.layout(), TranslucentPipelines::kStages, 0,
                                                     pushOf(range, extent, capacity));
    if (slice != nullptr) {
        commands.pushConstants<shaders::TranslucentSlice>(pipelines.layout(), TranslucentPipelines::kStages,
                                                          sizeof(shaders::TranslucentPush), *slice);
    }
    Binder binder(pipelines, commands, layerSlope(m_subPixelBits));
    const auto kindOf = [&](std::size_t draw) { return scene.sources()[m_lists.instance[draw]].kind; };
    const platform::IndexRange draws = m_lists.range(range);
    for (std::size_t first = draws.begin; first < draws.end;) {
        std::size_t end = first + 1;
        if (!isIn(first, slice)) {
            first = end;
            continue;
        }
        while (end < draws.end && kindOf(end) == kindOf(first) && isIn(end, slice)) {
            ++end;
        }
        const DrawKind& kind = scene.kinds()[kindOf(first)];
        binder.bind(kind);
        commands.drawIndexed(kind.mesh.indexCount, static_cast<std::uint32_t>(end - first),
                             kind.mesh.firstIndex, kind.mesh.vertexOffset, static_cast<std::uint32_t>(first));
        first = end;
    }
}

} // namespace cdr::render
