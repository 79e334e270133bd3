#include <cdr/platform/vector_clones.h>
#include <cdr/visibility/box_test.h>
#include <cdr/visibility/cull_cells.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

namespace cdr::visibility {

namespace {

constexpr std::size_t kJobTests = 256;
constexpr std::size_t kFetchedAhead = 2; ///< cells

/// A cell that is not wholly inside a camera's frustum, by index into the camera's list.
struct CellAcross {
    std::size_t camera = 0;
    std::size_t part = 0;
};

/// Cameras, a bit each.
using CameraBits = std::uint32_t;
static_assert(kMaxTogether <= std::numeric_limits<CameraBits>::digits);

/// Goes down the tree once for all cameras and lists for each the cells that are not wholly outside.
class Descent {
  public:
    Descent(const InstanceCells& cells, std::span<const SphereTest> tests,
            std::span<VisibleCells* const> visible, std::vector<CellAcross>& across)
        : m_cells(cells),
          m_tests(tests.begin(), tests.end()),
          m_visible(visible),
          m_across(across) {}

    /// @param seeing cameras that may see the node. @param inside those of them that see it whole.
    void visit(std::size_t level, std::size_t node, CameraBits seeing, CameraBits inside) {
        const InstanceCells::Box& box = m_cells.levels()[level][node];
        for (CameraBits left = seeing & ~inside; left != 0; left &= left - 1) {
            const CameraBits camera = left & ~(left - 1);
            const BoxSide side = m_tests[static_cast<std::size_t>(std::countr_zero(left))].sideOf(box);
            seeing &= side == BoxSide::outside ? ~camera : ~CameraBits{0};
            inside |= side == BoxSide::inside ? camera : 0;
        }
        if (seeing == 0) {
            return;
        }
        if (level == 0) {
            list(node, seeing, inside);
            return;
        }
        const std::size_t end =
            std::min((node + 1) * InstanceCells::kFan, m_cells.levels()[level - 1].size());
        for (std::size_t child = node * InstanceCells::kFan; child < end; ++child) {
            visit(level - 1, child, seeing, inside);
        }
    }

  private:
    void list(std::size_t cell, CameraBits seeing, CameraBits inside) {
        if (m_cells.held(cell) == 0) {
            return;
        }
        for (CameraBits left = seeing; left != 0; left &= left - 1) {
            const auto camera = static_cast<std::size_t>(std::countr_zero(left));
            std::vector<VisibleCells::Part>& parts = m_visible[camera]->parts;
            if ((inside >> camera & 1u) == 0) {
                m_across.push_back({camera, parts.size()});
            }
            parts.push_back({static_cast<std::uint32_t>(cell), m_cells.held(cell)});
        }
    }

    const InstanceCells& m_cells;
    std::vector<BoxTest> m_tests; ///< by camera
    std::span<VisibleCells* const> m_visible;
    std::vector<CellAcross>& m_across;
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

} // namespace

std::size_t VisibleCells::count() const {
    std::size_t count = 0;
    for (const Part& part : parts) {
        count += static_cast<std::size_t>(std::popcount(part.slots));
    }
    return count;
}

void cullCells(const InstanceCells& cells, const scene::Camera& camera, const scene::Frustum& frustum,
               platform::WorkerPool& workers, VisibleCells& visible) {
    const std::array<SphereTest, 1> test{SphereTest(camera, frustum)};
    const std::array<VisibleCells*, 1> list{&visible};
    cullCells(cells, test, workers, list);
}

void cullCells(const InstanceCells& cells, std::span<const SphereTest> tests, platform::WorkerPool& workers,
               std::span<VisibleCells* const> visible) {
    CameraBits all = 0;
    for (std::size_t camera = 0; camera < tests.size(); ++camera) {
        visible[camera]->cells = &cells;
        visible[camera]->test = tests[camera];
        visible[camera]->parts.clear();
        all |= CameraBits{1} << camera;
    }
    std::vector<CellAcross> across;
    if (!cells.levels().empty()) {
        const std::size_t top = cells.levels().size() - 1;
        Descent descent(cells, tests, visible, across);
        for (std::size_t node = 0; node < cells.levels()[top].size(); ++node) {
            descent.visit(top, node, all, 0);
        }
    }
    const auto partOf = [&](const CellAcross& cell) -> VisibleCells::Part& {
        return visible[cell.camera]->parts[cell.part];
    };
    const std::size_t jobs = (across.size() + kJobTests - 1) / kJobTests;
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        const platform::IndexRange range = platform::evenRange(across.size(), job, jobs);
        for (std::size_t i = range.begin; i < range.end; ++i) {
            if (i + kFetchedAhead < range.end) {
                cells.fetchSpheres(partOf(across[i + kFetchedAhead]).cell);
            }
            VisibleCells::Part& part = partOf(across[i]);
            part.slots = passing(cells, part.cell, tests[across[i].camera]);
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
