#pragma once

#include <cdr/render/geometry/facet_pass.h>
#include <cdr/render/submit/host_draws.h>

namespace cdr::render {

/// Draws facets: vertices and indices, and the records of facets or how each vertex' facet is lit.
class FacetDraws final : public HostDraws {
  public:
    FacetDraws(const HostDrawsContext& context, const FacetPass& pass) : HostDraws(context), m_pass(pass) {}

    /// Writes a job's corners, triangles and facets, and draws them by one command, or by two where some draws are
    /// wide; by more where there are more vertices than the device can name. Takes no lock and allocates nothing.
    void record(vk::CommandBuffer commands, const DrawJob& job, const FrameView& view) const override;
    void flush() const override;
    ScopeFormats formats() const override { return m_pass.pipelines.formats(); }
    vk::BufferView facets() const override { return *m_facetTexels; }

  protected:
    depth::Mapping mapping() const override { return m_pass.pipelines.options().technique.mapping; }
    void makeRoom(std::size_t draws) override;

  private:
    void makeRecords(std::size_t facets);
    /// Of draws whose vertices all have a name.
    void recordPart(vk::CommandBuffer commands, const DrawJob& job, const FrameView& view) const;
    void bind(vk::CommandBuffer commands, Span span, std::size_t cascade, const FrameView& view) const;
    /// The most draws whose facets the device reads. base::RunError if these are more.
    std::size_t mostDraws(std::size_t draws) const;

    const FacetPass& m_pass;
    std::size_t m_room = 0; ///< draws
    FacetCounts m_most;     ///< of a draw
    gpu::Buffer m_vertices;
    gpu::Buffer m_indices;
    std::size_t m_litStride = 0; ///< FacetLight::stride(); 0 where each facet has a record
    gpu::Buffer m_lit;           ///< where facets are lit while they are drawn, else `m_facets`
    gpu::Buffer m_facets;
    vk::UniqueBufferView m_facetTexels;
};

} // namespace cdr::render
