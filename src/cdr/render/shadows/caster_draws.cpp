#include <cdr/render/draw_source.h>
#include <cdr/render/materials/material_words.h>
#include <cdr/render/shadows/caster_draws.h>
#include <cdr/render/shadows/cull_casters.h>
#include <cdr/visibility/level_choice.h>

#include <algorithm>
#include <utility>

namespace cdr::render {

namespace {

/// Of the numbers that a vertex' place is made from: a few roundings in the vertex shader, and those of setting up a
/// triangle.
constexpr double kRounding = 0x1p-22;

} // namespace

CasterDraws::CasterDraws(const gpu::Device& device, const DrawnScene& scene)
    : m_device(device),
      m_scene(scene) {}

void CasterDraws::prepare(const FrameView& frame, std::span<const ReceiverSlice> slices,
                          std::vector<LightView>& views, platform::WorkerPool& workers) {
    const visibility::InstanceCells& cells = m_scene.uploaded.cells(workers);
    std::vector<Found> found(views.size());
    workers.run(views.size(), [&](std::size_t view, std::size_t) {
        found[view] = find(cells, frame, slices[views[view].slice], views[view]);
    });
    m_casters.clear();
    m_batches.clear();
    m_runs.clear();
    m_views.clear();
    for (const Found& some : found) {
        const std::size_t first = m_casters.size();
        m_views.push_back({m_batches.size(), m_batches.size() + some.batches.size()});
        m_casters.insert(m_casters.end(), some.casters.begin(), some.casters.end());
        for (Batch batch : some.batches) {
            batch.casters = {first + batch.casters.begin, first + batch.casters.end};
            if (batch.runs) {
                batch.runs = {m_runs.size() + batch.runs->begin, m_runs.size() + batch.runs->end};
            }
            m_batches.push_back(batch);
        }
        m_runs.insert(m_runs.end(), some.runs.begin(), some.runs.end());
    }
    gpu::growRecords(m_device, m_records, m_casters.size(), sizeof(shaders::CasterRecord), "shadow casters");
    workers.run(views.size(), [&](std::size_t view, std::size_t) {
        for (std::size_t i = m_views[view].begin; i < m_views[view].end; ++i) {
            writeRecords(views[view], m_batches[i].casters);
        }
    });
    m_records.flush();
}

CasterDraws::Found CasterDraws::find(const visibility::InstanceCells& cells, const FrameView& frame,
                                     const ReceiverSlice& slice, LightView& view) const {
    Found found;
    const ReceiverCells receivers(view, slice, frame.camera.position);
    const CasterTest test(view, receivers);
    view.nearAhead = cullCasters(cells, view, test, found.casters);
    // What becomes one draw lies together, in the scene's order.
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    order.reserve(found.casters.size());
    for (const std::uint32_t caster : found.casters) {
        order.emplace_back(drawOf(batchOf(caster, frame, view)), caster);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto& [draw, caster] = order[i];
        Batch batch = batchOf(caster, frame, view);
        batch.runs = cut(batch, caster, view, test, found.runs);
        if (i == 0 || draw != order[i - 1].first || batch.runs || found.batches.back().runs) {
            batch.casters.begin = i;
            found.batches.push_back(batch);
        }
        found.batches.back().casters.end = i + 1;
        found.casters[i] = caster;
    }
    return found;
}

/// What is drawn of a large mesh, where that is not all. Appends its runs.
std::optional<CasterDraws::Range> CasterDraws::cut(const Batch& batch, std::uint32_t caster,
                                                   const LightView& view, const CasterTest& test,
                                                   std::vector<visibility::IndexRun>& runs) const {
    const MeshRange& mesh = kindOf(caster).mesh;
    if (mesh.chunkCount == 0 || batch.level != 0) {
        return std::nullopt;
    }
    const DrawSource& source = m_scene.uploaded.sources()[caster];
    const glm::dvec3 place = source.position - view.origin;
    const glm::dmat3 basis(source.basis);
    const double rounding = roundingOf(caster, view);
    const auto isSeen = [&](const visibility::MeshChunk& chunk) {
        return test.holds(visibility::placedBox(place, basis, chunk.middle, chunk.half), rounding);
    };
    const std::size_t first = runs.size();
    visibility::forEachSeenRun(m_scene.uploaded.chunksOf(mesh), mesh.indexCount, isSeen,
                               [&](const visibility::IndexRun& run) { runs.push_back(run); });
    if (runs.size() == first + 1 && runs.back().count == mesh.indexCount) {
        runs.pop_back();
        return std::nullopt;
    }
    return Range{first, runs.size()};
}

/// Of a caster's vertices, in scene units.
double CasterDraws::roundingOf(std::uint32_t caster, const LightView& view) const {
    const glm::dvec3 place = m_scene.uploaded.sources()[caster].position - view.origin;
    return kRounding * (glm::length(place) + static_cast<double>(m_scene.scene.instances.radius[caster]));
}

const DrawKind& CasterDraws::kindOf(std::uint32_t caster) const {
    const UploadedScene& scene = m_scene.uploaded;
    return scene.kinds()[scene.sources()[caster].kind];
}

bool CasterDraws::isMasked(std::uint32_t caster) const {
    return (kindOf(caster).variant & kMaskedVariant) != 0;
}

/// What a caster is drawn with, without others that become the same draw.
CasterDraws::Batch CasterDraws::batchOf(std::uint32_t caster, const FrameView& frame,
                                        const LightView& view) const {
    const DrawKind& kind = kindOf(caster);
    Batch batch{.kind = m_scene.uploaded.sources()[caster].kind,
                .level = visibility::levelOf(m_scene.scene, caster, frame.camera, frame.levels),
                .isMasked = isMasked(caster)};
    const glm::dvec3 place = m_scene.uploaded.sources()[caster].position - view.origin;
    const auto radius = static_cast<double>(m_scene.scene.instances.radius[caster]);
    // Of one that the near plane or a mask cuts open, the light sees the inside. Coarser levels may have gaps.
    if (kind.mesh.isClosed && !batch.isMasked && batch.level == 0 &&
        glm::dot(view.ahead, place) - radius >= view.nearAhead) {
        batch.faces = kind.mirrored ? Faces::mirroredFront : Faces::front;
    }
    return batch;
}

/// The same of casters that become one draw. Those with a mask are last.
std::uint64_t CasterDraws::drawOf(const Batch& batch) const {
    const std::uint32_t look =
        batch.isMasked ? batch.kind : m_scene.uploaded.kinds()[batch.kind].meshIndex; // its textures count
    std::uint64_t draw = batch.isMasked ? 1 : 0;
    draw = draw << 8u | static_cast<std::uint64_t>(batch.faces);
    draw = draw << 8u | batch.level;
    return draw << 32u | look;
}

float CasterDraws::leastAlphaOf(std::uint32_t caster) const {
    if (!isMasked(caster)) {
        return 0.0f;
    }
    return render::leastAlphaOf(m_scene.scene.materials[m_scene.uploaded.sources()[caster].material]);
}

void CasterDraws::writeRecords(const LightView& view, const Range& range) const {
    const auto records = m_records.as<shaders::CasterRecord>(m_casters.size());
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const DrawSource& source = m_scene.uploaded.sources()[m_casters[i]];
        const glm::dvec3 place = source.position - view.origin;
        const glm::dvec3 offset = view.toLight(place);
        const glm::dmat3 basis(source.basis);
        records[i] = {.right = glm::vec4(glm::vec3(view.right * basis), static_cast<float>(offset.x)),
                      .up = glm::vec4(glm::vec3(view.up * basis), static_cast<float>(offset.y)),
                      .ahead = glm::vec4(glm::vec3(view.ahead * basis), static_cast<float>(offset.z)),
                      .rounding = static_cast<float>(roundingOf(m_casters[i], view)),
                      .leastAlpha = leastAlphaOf(m_casters[i])};
    }
}

void CasterDraws::record(vk::CommandBuffer commands, std::size_t view,
                         const CasterPipelines& pipelines) const {
    const UploadedScene& scene = m_scene.uploaded;
    commands.bindVertexBuffers(0, {scene.vertices(), m_records.handle()}, {0, 0});
    commands.bindIndexBuffer(scene.indices(), 0, vk::IndexType::eUint32);
    const Batch* last = nullptr;
    for (std::size_t i = m_views[view].begin; i < m_views[view].end; ++i) {
        const Batch& batch = m_batches[i];
        const DrawKind& kind = scene.kinds()[batch.kind];
        if (last == nullptr || batch.isMasked != last->isMasked) {
            commands.bindPipeline(vk::PipelineBindPoint::eGraphics,
                                  batch.isMasked ? pipelines.masked : pipelines.solid);
        }
        if (batch.isMasked) {
            commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, pipelines.layout, 0,
                                        kind.textureSet, {});
        }
        if (last == nullptr || batch.faces != last->faces) {
            commands.setCullMode(batch.faces == Faces::all ? vk::CullModeFlagBits::eNone
                                                           : vk::CullModeFlagBits::eBack);
            commands.setFrontFace(batch.faces == Faces::mirroredFront ? vk::FrontFace::eClockwise
                                                                      : vk::FrontFace::eCounterClockwise);
        }
        const LevelRange indices = scene.indicesOf(kind.mesh, batch.level);
        const auto draw = [&](const visibility::IndexRun& run) {
            commands.drawIndexed(run.count,
                                 static_cast<std::uint32_t>(batch.casters.end - batch.casters.begin),
                                 indices.firstIndex + run.first, kind.mesh.vertexOffset,
                                 static_cast<std::uint32_t>(batch.casters.begin));
        };
        if (batch.runs) {
            std::for_each(m_runs.begin() + static_cast<std::ptrdiff_t>(batch.runs->begin),
                          m_runs.begin() + static_cast<std::ptrdiff_t>(batch.runs->end), draw);
        } else {
            draw({.count = indices.indexCount});
        }
        last = &batch;
    }
}

} // namespace cdr::render
