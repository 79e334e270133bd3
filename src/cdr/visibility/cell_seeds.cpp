#include <cdr/visibility/blended.h>
#include <cdr/visibility/cell_seeds.h>

#include <algorithm>
#include <bit>
#include <span>

namespace cdr::visibility {

namespace {

using Seeds = std::span<CellSeed>;

constexpr std::size_t kJobSeeds = 16'384;

std::size_t widestAxis(Seeds seeds) {
    std::array<float, 3> low = seeds.front().at;
    std::array<float, 3> high = low;
    for (const CellSeed& seed : seeds) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], seed.at[axis]);
            high[axis] = std::max(high[axis], seed.at[axis]);
        }
    }
    std::size_t widest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
        widest = high[axis] - low[axis] > high[widest] - low[widest] ? axis : widest;
    }
    return widest;
}

/// Moves the nearer seeds along the widest axis to the front, as many as fill a power of two of cells. Returns how
/// many; all of them where they fill one cell at most.
std::size_t halve(Seeds seeds, std::size_t slots) {
    const std::size_t cells = (seeds.size() + slots - 1) / slots;
    if (cells <= 1) {
        return seeds.size();
    }
    const std::size_t front = slots * std::bit_floor(cells - 1);
    const std::size_t axis = widestAxis(seeds);
    std::nth_element(seeds.begin(), seeds.begin() + static_cast<std::ptrdiff_t>(front), seeds.end(),
                     [axis](const CellSeed& a, const CellSeed& b) { return a.at[axis] < b.at[axis]; });
    return front;
}

void halveAll(Seeds seeds, std::size_t slots) {
    while (seeds.size() > slots) {
        const std::size_t front = halve(seeds, slots);
        halveAll(seeds.first(front), slots);
        seeds = seeds.subspan(front);
    }
}

std::vector<CellSeed> opaqueSeeds(const scene::Scene& scene) {
    const scene::Instances& instances = scene.instances;
    std::vector<CellSeed> seeds;
    seeds.reserve(instances.size());
    for (std::uint32_t i = 0; i < instances.size(); ++i) {
        if (instances.radius[i] != scene::kNoRadius && !isBlended(scene, i)) {
            const glm::vec3 at(instances.position(i));
            seeds.push_back({.at = {at.x, at.y, at.z}, .instance = i});
        }
    }
    return seeds;
}

} // namespace

std::vector<CellSeed> sortIntoCells(const scene::Scene& scene, std::size_t slots,
                                    platform::WorkerPool& workers) {
    std::vector<CellSeed> seeds = opaqueSeeds(scene);
    std::vector<Seeds> parts{seeds};
    while (parts.size() < 8 * workers.threads() && seeds.size() > parts.size() * kJobSeeds) {
        std::vector<std::size_t> fronts(parts.size());
        workers.run(parts.size(),
                    [&](std::size_t job, std::size_t) { fronts[job] = halve(parts[job], slots); });
        std::vector<Seeds> halves;
        for (std::size_t part = 0; part < parts.size(); ++part) {
            halves.push_back(parts[part].first(fronts[part]));
            halves.push_back(parts[part].subspan(fronts[part]));
        }
        parts = std::move(halves);
    }
    workers.run(parts.size(), [&](std::size_t job, std::size_t) { halveAll(parts[job], slots); });
    return seeds;
}

} // namespace cdr::visibility
