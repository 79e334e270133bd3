#include <cdr/render/submit/host_draws.h>
#include <cdr/visibility/cluster_choice.h>

namespace cdr::render {

void HostDraws::bin(const FrameView& view, const visibility::VisibleCells& visible, FrameStats& stats) {
    const depth::Cascades clipRanges = view.clipRanges();
    m_binner.bin(visible, clipRanges, wideSpan(mapping(), clipRanges.size()), workers(), m_lists);
    stats.visible = m_lists.visible;
    stats.draws = m_lists.draws();
    stats.duplication = m_lists.duplication();
    visibility::keepCascades(m_lists, view.drawn);
    visibility::chooseDetail(m_context.scene,
                             {.camera = view.camera,
                              .frustum = view.frustum,
                              .clipRanges = clipRanges,
                              .wideSpan = wideSpan(mapping(), clipRanges.size()),
                              .levels = view.levels},
                             workers(), m_lists);
    makeRoom(m_lists.draws());
}

} // namespace cdr::render
