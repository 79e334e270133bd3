#include <cdr/base/format_error.h>
#include <cdr/render/submit/facet_draws.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace cdr::render {

namespace {

constexpr std::uint64_t kTexelsPerFacet = 2;

gpu::Buffer makeStream(const gpu::Device& device, std::size_t bytes, vk::BufferUsageFlagBits usage,
                       const char* name) {
    return {device, std::max<std::size_t>(bytes, 1), usage, gpu::MemoryUse::hostWrites, name};
}

} // namespace

std::size_t FacetDraws::mostDraws(std::size_t draws) const {
    if (m_pass.lights()) {
        return std::numeric_limits<std::size_t>::max();
    }
    const FacetCounts& most = m_pass.meshes().most();
    const std::uint64_t maxTexels =
        vk::PhysicalDevice(device().physical()).getProperties().limits.maxTexelBufferElements;
    const std::uint64_t texels = draws * most.facets * kTexelsPerFacet;
    if (texels > maxTexels) {
        throw base::runError("{} draws have facets of {} texels, {} reads {}", draws, texels,
                             device().info().name, maxTexels);
    }
    return maxTexels / kTexelsPerFacet / std::max(most.facets, 1u);
}

void FacetDraws::makeRecords(std::size_t facets) {
    m_facetTexels.reset();
    m_facets = makeStream(device(), std::max<std::size_t>(facets, 1) * sizeof(shaders::FacetRecord),
                          vk::BufferUsageFlagBits::eUniformTexelBuffer, "facets");
    m_facetTexels = vk::Device(device().handle())
                        .createBufferViewUnique({.buffer = m_facets.handle(),
                                                 .format = vk::Format::eR32G32B32A32Uint,
                                                 .range = VK_WHOLE_SIZE});
}

void FacetDraws::makeRoom(std::size_t draws) {
    const FacetCounts& most = m_pass.meshes().most();
    const std::size_t litStride = m_pass.lights() ? FacetLight::strideOf(scene()) : 0;
    if (m_room > 0 && draws <= m_room && most == m_most && litStride == m_litStride) {
        return;
    }
    const std::size_t room = std::min(roomFor(draws), mostDraws(draws));
    gpu::requireDeviceBytes(device(), room * bytesPerDraw(most, litStride),
                            fmt::format("the facets of {} draws", draws));
    using Usage = vk::BufferUsageFlagBits;
    m_room = 0; // until all is there
    m_vertices = makeStream(device(), room * most.vertices * sizeof(shaders::FacetVertex),
                            Usage::eVertexBuffer, "facet vertices");
    m_indices = makeStream(device(), room * most.indices * sizeof(std::uint32_t), Usage::eIndexBuffer,
                           "facet indices");
    if (m_pass.lights()) {
        m_lit = makeStream(device(), room * most.vertices * litStride * sizeof(glm::vec3),
                           Usage::eVertexBuffer, "light of facets");
    } else {
        makeRecords(room * most.facets);
    }
    m_room = room;
    m_most = most;
    m_litStride = litStride;
}

void FacetDraws::record(vk::CommandBuffer commands, const DrawJob& job, const FrameView& view) const {
    m_pass.record(commands, job,
                  {.scene = scene(),
                   .view = view,
                   .lists = lists(),
                   .streams = {.vertices = static_cast<shaders::FacetVertex*>(m_vertices.mapped()),
                               .indices = static_cast<std::uint32_t*>(m_indices.mapped()),
                               .facets = static_cast<shaders::FacetRecord*>(m_facets.mapped()),
                               .lit = static_cast<glm::vec3*>(m_lit.mapped())},
                   .vertices = m_vertices.handle(),
                   .indices = m_indices.handle(),
                   .lit = m_lit.handle()});
}

void FacetDraws::flush() const {
    m_vertices.flush();
    m_indices.flush();
    (m_pass.lights() ? m_lit : m_facets).flush();
}

} // namespace cdr::render
