#pragma once

#include <cdr/platform/worker_pool.h>
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

/// The opaque instances of a scene, in an order in which every `slots` in a row are neighbours. Groups of 2, 4, 8 and so on
/// of these are neighbours too. For this the instances are halved across the widest axis, again and again. The order is the
/// same for any number of workers.
std::vector<CellSeed> sortIntoCells(const scene::Scene& scene, std::size_t slots,
                                    platform::WorkerPool& workers);

} // namespace cdr::visibility
