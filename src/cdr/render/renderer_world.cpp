#include "frame_slot.h"

#include <cdr/render/choose_facets.h>
#include <cdr/render/renderer_setup.h>

#include <utility>
#include <vector>

namespace cdr::render {

Renderer::Needs Renderer::needs() const {
    const GpuScene& uploaded = m_drawn.uploaded;
    const PreparedSurfaces prepared = preparedSurfaces(m_options.prepareFor);
    return {.metallicRoughness = (uploaded.hasMetallicRoughness() || prepared.metallicRoughness) &&
                                 keepsMetallicRoughness(m_options),
            .blended = uploaded.hasBlended() || prepared.blended,
            .emission = (uploaded.hasEmission() || prepared.emission) && keepsEmission(m_options),
            .sky = m_drawn.scene.sky.has_value(),
            .air = m_drawn.scene.air.has_value(),
            .focusBackground = m_options.focus.isOn() ? m_drawn.scene.background : glm::vec3(0.0f)};
}

void Renderer::remake(const Needs& needs, const RenderOptions& options) {
    const Needs needsBefore = std::exchange(m_needs, needs);
    const RenderOptions optionsBefore = std::exchange(m_options, options);
    // Pipelines that snap vertices do so for one size.
    const bool snaps = options.snapBits > 0 || options.snapping == Snapping::inPlane;
    const bool snapsAnew = snaps && options != optionsBefore;
    std::unique_ptr<DrawPathFactory> paths;
    try {
        if (needs.metallicRoughness != needsBefore.metallicRoughness ||
            needs.emission != needsBefore.emission || snapsAnew) {
            paths = std::make_unique<DrawPathFactory>(m_device, m_drawn, chooseFacets(m_drawn, m_options),
                                                      m_options,
                                                      KeptSurfaces{needs.metallicRoughness, needs.emission});
            std::swap(paths, m_paths);
        }
        makePasses();
    } catch (...) { // all is as it was, and the next frame tries again
        m_needs = needsBefore;
        m_options = optionsBefore;
        if (paths != nullptr) {
            std::swap(paths, m_paths);
        }
        throw;
    }
}

void Renderer::followScene() {
    if (m_live != nullptr) {
        m_live->update();
    }
    const std::uint64_t revision = m_drawn.uploaded.revision();
    // Lights change without a new revision, and whether facets can be lit while they are drawn depends on them.
    const bool haveFacetsChanged = m_revision != revision || m_options.surface == SurfacePath::lit;
    if (haveFacetsChanged && m_paths->facets() != nullptr) {
        followFacets();
    }
    if (needs() != m_needs) {
        finish();
        remake(needs(), m_options);
    }
    if (m_revision != revision) {
        m_paths->followKinds();
    }
    const std::size_t lights = m_drawn.scene.lights.size();
    if (lights > m_passes->lightRoom) {
        finish();
        const std::size_t room = lights + lights / 2;
        std::vector<std::unique_ptr<SlotInputs>> made; // those of all slots first, since this may throw
        for (std::size_t i = 0; i < m_passes->slots.size(); ++i) {
            made.push_back(makeInputs(room));
        }
        for (std::size_t i = 0; i < made.size(); ++i) {
            m_passes->slots[i].inputs = std::move(made[i]);
        }
        m_passes->lightRoom = room;
    }
    m_revision = revision;
}

void Renderer::followFacets() {
    const GpuScene& uploaded = m_drawn.uploaded;
    const FacetsMadeFrom now{uploaded.meshesRevision(), uploaded.kinds().size()};
    if (m_facetsMadeFrom == now) {
        requireFacets(m_drawn, m_options, *m_paths->facets());
        return;
    }
    m_paths->setFacets(*chooseFacets(m_drawn, m_options));
    m_facetsMadeFrom = now;
}

} // namespace cdr::render
