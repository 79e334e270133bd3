#include <cdr/render/draw_source.h>
#include <cdr/render/shadows/caster_draws.h>
#include <cdr/render/shadows/cull_casters.h>

#include <fmt/format.h>

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

void CasterDraws::prepare(std::vector<LightView>& views, platform::WorkerPool& workers) {
    std::vector<std::vector<std::uint32_t>> casters(views.size());
    const visibility::InstanceCells& cells = m_scene.uploaded.cells(workers);
    const std::vector<DrawSource>& sources = m_scene.uploaded.sources();
    workers.run(views.size(), [&](std::size_t view, std::size_t) {
        views[view].nearAhead = cullCasters(cells, views[view], casters[view]);
        std::sort(casters[view].begin(), casters[view].end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(sources[a].kind, a) < std::pair(sources[b].kind, b);
        });
    });
    m_casters.clear();
    m_ranges.clear();
    for (const std::vector<std::uint32_t>& some : casters) {
        m_ranges.push_back({m_casters.size(), m_casters.size() + some.size()});
        m_casters.insert(m_casters.end(), some.begin(), some.end());
    }
    growRecords();
    workers.run(views.size(),
                [&](std::size_t view, std::size_t) { writeRecords(views[view], m_ranges[view]); });
    m_records.flush();
}

void CasterDraws::growRecords() {
    const std::size_t draws = m_casters.size();
    if (m_records.size() > 0 && draws <= m_records.size() / sizeof(shaders::CasterRecord)) {
        return;
    }
    // Half as many again, so that a camera that turns does not make a new buffer at every frame.
    const std::size_t bytes = std::max<std::size_t>(draws + draws / 2, 64) * sizeof(shaders::CasterRecord);
    gpu::requireDeviceBytes(m_device, bytes, fmt::format("the records of {} shadow casters", draws));
    m_records = gpu::Buffer(m_device, bytes, vk::BufferUsageFlagBits::eVertexBuffer,
                            gpu::MemoryUse::hostWrites, "shadow casters");
}

void CasterDraws::writeRecords(const LightView& view, const Range& range) const {
    const auto records = m_records.as<shaders::CasterRecord>(m_casters.size());
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const DrawSource& source = m_scene.uploaded.sources()[m_casters[i]];
        const glm::dvec3 place = source.position - view.origin;
        const glm::dvec3 offset = view.toLight(place);
        const glm::dmat3 basis(source.basis);
        const auto radius = static_cast<double>(m_scene.scene.instances.radius[m_casters[i]]);
        const double rounding = kRounding * (glm::length(place) + radius);
        records[i] = {.right = glm::vec4(glm::vec3(view.right * basis), static_cast<float>(offset.x)),
                      .up = glm::vec4(glm::vec3(view.up * basis), static_cast<float>(offset.y)),
                      .ahead = glm::vec4(glm::vec3(view.ahead * basis), static_cast<float>(offset.z)),
                      .rounding = static_cast<float>(rounding)};
    }
}

void CasterDraws::record(vk::CommandBuffer commands, std::size_t view) const {
    const GpuScene& scene = m_scene.uploaded;
    commands.bindVertexBuffers(0, {scene.vertices(), m_records.handle()}, {0, 0});
    commands.bindIndexBuffer(scene.indices(), 0, vk::IndexType::eUint32);
    const auto kindOf = [&](std::size_t draw) -> const DrawKind& {
        return scene.kinds()[scene.sources()[m_casters[draw]].kind];
    };
    const Range& range = m_ranges[view];
    for (std::size_t first = range.begin; first < range.end;) {
        const DrawKind& kind = kindOf(first);
        const MeshRange& mesh = kind.mesh;
        std::size_t end = first + 1;
        while (end < range.end && kindOf(end).meshIndex == kind.meshIndex) {
            ++end;
        }
        commands.drawIndexed(mesh.indexCount, static_cast<std::uint32_t>(end - first), mesh.firstIndex,
                             mesh.vertexOffset, static_cast<std::uint32_t>(first));
        first = end;
    }
}

} // namespace cdr::render
