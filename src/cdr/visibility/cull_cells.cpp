#include <cdr/host/vector_clones.h>
#include <cdr/visibility/box_test.h>
#include <cdr/visibility/cull_cells.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace cdr::visibility {

namespace {

constexpr std::size_t kJobTests = 256;
constexpr std::size_t kFetchedAhead = 2; ///< cells

/// Goes down the tree and lists the cells that are not wholly outside. Those that are not wholly inside go to
/// `across` too, by index into the list.
class Descent {
  public:
    Descent(const InstanceCells& cells, const SphereTest& test, VisibleCells& visible,
            std::vector<std::uint32_t>& across)
        : m_cells(cells),
          m_test(test),
          m_visible(visible),
          m_across(across) {}

    void visit(std::size_t level, std::size_t node, bool isInside) {
        const InstanceCells::Box& box = m_cells.levels()[level][node];
        if (!isInside) {
            const BoxSide side = m_test.sideOf(box);
            if (side == BoxSide::outside) {
                return;
            }
            isInside = side == BoxSide::inside;
        }
        if (level == 0) {
            list(node, isInside);
            return;
        }
        const std::size_t end =
            std::min((node + 1) * InstanceCells::kFan, m_cells.levels()[level - 1].size());
        for (std::size_t child = node * InstanceCells::kFan; child < end; ++child) {
            visit(level - 1, child, isInside);
        }
    }

  private:
    void list(std::size_t cell, bool isInside) {
        if (m_cells.held(cell) == 0) {
            return;
        }
        if (!isInside) {
            m_across.push_back(static_cast<std::uint32_t>(m_visible.parts.size()));
        }
        m_visible.parts.push_back({static_cast<std::uint32_t>(cell), m_cells.held(cell)});
    }

    const InstanceCells& m_cells;
    BoxTest m_test;
    VisibleCells& m_visible;
    std::vector<std::uint32_t>& m_across;
};

/// A bit for each of a cell's slots whose margin is not below 0.
CDR_VECTOR_CLONES
std::uint64_t bitsOf(const TestedSpheres& tested) {
    std::array<std::uint8_t, InstanceCells::kCellSlots> passes;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        passes[i] = tested.margin[i] >= 0.0 ? 1 : 0;
    }
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < passes.size(); i += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, &passes[i], sizeof(eight));
        // Gathers the lowest bit of each byte in the highest byte, the first byte's lowest.
        bits |= (eight * 0x0102040810204080u >> 56) << i;
    }
    return bits;
}

/// The slots of a cell whose spheres pass.
std::uint64_t passing(const InstanceCells& cells, std::size_t cell, const SphereTest& test) {
    TestedSpheres tested;
    testSpheres(test, cells.spheres(cell), InstanceCells::kCellSlots, tested);
    return bitsOf(tested) & cells.held(cell);
}

/// Has the processor fetch a cell's spheres: cells that are tested lie apart, so it does not know to do so by itself.
void fetchAhead(const InstanceCells& cells, std::size_t cell) {
#if defined(__GNUC__)
    constexpr std::size_t kDoublesPerLine = 8;
    const Spheres spheres = cells.spheres(cell);
    for (std::size_t i = 0; i < InstanceCells::kCellSlots; i += kDoublesPerLine) {
        __builtin_prefetch(spheres.x + i);
        __builtin_prefetch(spheres.y + i);
        __builtin_prefetch(spheres.z + i);
        __builtin_prefetch(spheres.radius + i);
    }
#else
    static_cast<void>(cells);
    static_cast<void>(cell);
#endif
}

} // namespace

std::size_t VisibleCells::count() const {
    std::size_t count = 0;
    for (const Part& part : parts) {
        count += static_cast<std::size_t>(std::popcount(part.slots));
    }
    return count;
}

void cullCells(const InstanceCells& cells, const scene::Camera& camera, const scene::Frustum& frustum,
               host::WorkerPool& workers, VisibleCells& visible) {
    visible.cells = &cells;
    visible.test = SphereTest(camera, frustum);
    visible.parts.clear();
    std::vector<std::uint32_t> across;
    if (!cells.levels().empty()) {
        const std::size_t top = cells.levels().size() - 1;
        Descent descent(cells, visible.test, visible, across);
        for (std::size_t node = 0; node < cells.levels()[top].size(); ++node) {
            descent.visit(top, node, false);
        }
    }
    const std::size_t jobs = (across.size() + kJobTests - 1) / kJobTests;
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        const host::IndexRange range = host::evenRange(across.size(), job, jobs);
        for (std::size_t i = range.begin; i < range.end; ++i) {
            if (i + kFetchedAhead < range.end) {
                fetchAhead(cells, visible.parts[across[i + kFetchedAhead]].cell);
            }
            VisibleCells::Part& part = visible.parts[across[i]];
            part.slots = passing(cells, part.cell, visible.test);
        }
    });
}

void appendIntervals(const VisibleCells& visible, std::vector<depth::Interval>& intervals) {
    for (const VisibleCells::Part& part : visible.parts) {
        const Spheres spheres = visible.cells->spheres(part.cell);
        TestedSpheres tested;
        testSpheres(visible.test, spheres, InstanceCells::kCellSlots, tested);
        for (std::uint64_t slots = part.slots; slots != 0; slots &= slots - 1) {
            const auto slot = static_cast<std::size_t>(std::countr_zero(slots));
            const auto radius = static_cast<double>(spheres.radius[slot]);
            intervals.push_back({tested.distanceView[slot] - radius, tested.distanceView[slot] + radius});
        }
    }
}

} // namespace cdr::visibility
