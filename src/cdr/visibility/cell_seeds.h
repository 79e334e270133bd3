#pragma once

#include <cdr/host/worker_pool.h>
#include <cdr/scene/scene.h>

#include <array>
#include <cstdint>
#include <vector>

namespace cdr::visibility {

/// An opaque instance and about where it is.
struct CellSeed {
    std::array<float, 3> at;
    std::uint32_t instance;
};

/// The opaque instances of a scene, so ordered that every `slots` in a row are neighbours, and that groups of them by
/// powers of two are too: halves across the widest axis, over and over. The same order for any number of workers.
std::vector<CellSeed> sortIntoCells(const scene::Scene& scene, std::size_t slots, host::WorkerPool& workers);

} // namespace cdr::visibility
