#include <cdr/visibility/occluders.h>

#include <bit>

namespace cdr::visibility {

bool canOcclude(const scene::Material& material) {
    return material.alphaMode == scene::AlphaMode::opaque && material.layer == 0.0f;
}

const VisibleCells& Occluders::choose(const scene::Scene& scene, const scene::Frustum& frustum,
                                      const VisibleCells& visible) {
    m_chosen.cells = visible.cells;
    m_chosen.test = visible.test;
    m_chosen.parts.clear();
    const double perDistance = frustum.footprintSlope * (m_last.empty() ? kMinFirstOccluder : kMinOccluder);
    auto last = m_last.begin();
    TestedSpheres tested;
    for (const VisibleCells::Part& part : visible.parts) { // by cell, ascending, as m_last is
        std::uint64_t candidates = part.slots;
        if (!m_last.empty()) {
            while (last != m_last.end() && last->cell < part.cell) {
                ++last;
            }
            candidates &= last != m_last.end() && last->cell == part.cell ? last->slots : 0;
        }
        if (candidates == 0) {
            continue;
        }
        const Spheres spheres = visible.cells->spheres(part.cell);
        const std::uint32_t* instances = visible.cells->instancesOf(part.cell);
        testSpheres(visible.test, spheres, InstanceCells::kCellSlots, tested);
        std::uint64_t chosen = 0;
        for (; candidates != 0; candidates &= candidates - 1) {
            const auto slot = static_cast<std::size_t>(std::countr_zero(candidates));
            const bool isLarge =
                static_cast<double>(spheres.radius[slot]) >= perDistance * tested.distanceView[slot];
            if (isLarge && canOcclude(scene.materials[scene.instances.material[instances[slot]]])) {
                chosen |= std::uint64_t{1} << slot;
            }
        }
        if (chosen != 0) {
            m_chosen.parts.push_back({part.cell, chosen});
        }
    }
    return m_chosen;
}

} // namespace cdr::visibility
