#include <cdr/render/shadows/cull_casters.h>

#include <algorithm>
#include <bit>
#include <limits>

namespace cdr::render {

namespace {

/// What is nearer to a light than this is left out. For a distant light it is a share of the light's distance: no surface is
/// so near. For a light near by it is a share of the farthest receiver's distance.
constexpr double kMinDistant = 0x1p-10;
constexpr double kMinNear = 0x1p-20;

/// Goes down the tree of cells.
class CasterSearch {
  public:
    CasterSearch(const visibility::InstanceCells& cells, const LightView& view, const CasterTest& test,
                 std::vector<std::uint32_t>& casters)
        : m_cells(cells),
          m_view(view),
          m_test(test),
          m_casters(casters) {}

    void visit(std::size_t level, std::size_t node) {
        if (!m_test.holds(m_cells.levels()[level][node])) {
            return;
        }
        if (level == 0) {
            list(node);
            return;
        }
        constexpr std::size_t kFan = visibility::InstanceCells::kFan;
        const std::size_t end = std::min((node + 1) * kFan, m_cells.levels()[level - 1].size());
        for (std::size_t child = node * kFan; child < end; ++child) {
            visit(level - 1, child);
        }
    }
    double nearest() const { return m_nearest; }

  private:
    void list(std::size_t cell) {
        const visibility::Spheres spheres = m_cells.spheres(cell);
        for (std::uint64_t slots = m_cells.held(cell); slots != 0; slots &= slots - 1) {
            const auto slot = static_cast<std::size_t>(std::countr_zero(slots));
            const glm::dvec3 centre(spheres.x[slot], spheres.y[slot], spheres.z[slot]);
            const auto radius = static_cast<double>(spheres.radius[slot]);
            if (m_test.holds(centre, radius)) {
                m_casters.push_back(m_cells.instancesOf(cell)[slot]);
                m_nearest = std::min(m_nearest, glm::dot(m_view.ahead, centre - m_view.origin) - radius);
            }
        }
    }

    const visibility::InstanceCells& m_cells;
    const LightView& m_view;
    const CasterTest& m_test;
    std::vector<std::uint32_t>& m_casters;
    double m_nearest = std::numeric_limits<double>::infinity();
};

} // namespace

double cullCasters(const visibility::InstanceCells& cells, const LightView& view, const CasterTest& test,
                   std::vector<std::uint32_t>& casters) {
    CasterSearch search(cells, view, test, casters);
    if (!cells.levels().empty()) {
        const std::size_t top = cells.levels().size() - 1;
        for (std::size_t node = 0; node < cells.levels()[top].size(); ++node) {
            search.visit(top, node);
        }
    }
    const double least =
        view.isDistant() ? (kMinDistant - view.wOffset) / view.wPerUnit : kMinNear * view.farAhead;
    const double length = view.texel * view.w(view.farAhead); // what is drawn has some depth
    return std::min(std::max(search.nearest(), least), view.farAhead - length);
}

} // namespace cdr::render
