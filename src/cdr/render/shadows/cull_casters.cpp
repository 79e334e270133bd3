#include <cdr/render/shadows/cull_casters.h>

#include <algorithm>
#include <array>
#include <bit>

namespace cdr::render {

namespace {

/// What is nearer to a light than this is left out. For a distant light it is a share of the light's distance: no surface is
/// so near. For a light near by it is a share of the farthest receiver's distance.
constexpr double kMinDistant = 0x1p-10;
constexpr double kMinNear = 0x1p-20;

/// Inside where dot(normal, place) + offset >= 0, relative to the view's origin. Not of unit length.
struct Plane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;
    double length = 0.0;
};

/// What may cast a shadow on what the view shows: in its pyramid, or column, as far as the farthest receiver, and before a
/// receiver.
class CasterTest {
  public:
    CasterTest(const LightView& view, const ReceiverCells& receivers) : m_view(view), m_receivers(receivers) {
        const glm::dvec2 high = view.low + view.texel * glm::dvec2(view.size.width, view.size.height);
        const auto add = [&](std::size_t i, const glm::dvec3& axis, double sign, double limit) {
            const glm::dvec3 normal = sign * (axis - limit * view.wPerUnit * view.ahead);
            m_planes[i] = {normal, -sign * limit * view.wOffset, glm::length(normal)};
        };
        add(0, view.right, 1.0, view.low.x);
        add(1, view.right, -1.0, high.x);
        add(2, view.up, 1.0, view.low.y);
        add(3, view.up, -1.0, high.y);
        m_planes[4] = {-view.ahead, view.farAhead, 1.0};
        m_planes[5] = {view.wPerUnit * view.ahead, view.wOffset, view.wPerUnit};
    }

    bool holds(const glm::dvec3& centre, double radius) const {
        const glm::dvec3 place = centre - m_view.origin;
        return std::all_of(m_planes.begin(), m_planes.end(),
                           [&](const Plane& plane) {
                               return glm::dot(plane.normal, place) + plane.offset >= -radius * plane.length;
                           }) &&
               m_receivers.meet(m_view.toLight(place), glm::dvec3(radius));
    }
    bool holds(const visibility::InstanceCells::Box& box) const {
        const glm::dvec3 middle = 0.5 * ((box.low - m_view.origin) + (box.high - m_view.origin));
        const glm::dvec3 half = 0.5 * (box.high - box.low);
        const glm::dvec3 across(glm::dot(glm::abs(m_view.right), half), glm::dot(glm::abs(m_view.up), half),
                                glm::dot(glm::abs(m_view.ahead), half));
        return std::all_of(m_planes.begin(), m_planes.end(),
                           [&](const Plane& plane) {
                               return glm::dot(plane.normal, middle) + plane.offset >=
                                      -(glm::dot(glm::abs(plane.normal), half) + box.radius * plane.length);
                           }) &&
               m_receivers.meet(m_view.toLight(middle), across + box.radius);
    }

  private:
    const LightView& m_view;
    const ReceiverCells& m_receivers;
    std::array<Plane, 6> m_planes;
};

/// Goes down the tree of cells.
class CasterSearch {
  public:
    CasterSearch(const visibility::InstanceCells& cells, const LightView& view,
                 const ReceiverCells& receivers, std::vector<std::uint32_t>& casters)
        : m_cells(cells),
          m_view(view),
          m_test(view, receivers),
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
    CasterTest m_test;
    std::vector<std::uint32_t>& m_casters;
    double m_nearest = std::numeric_limits<double>::infinity();
};

} // namespace

double cullCasters(const visibility::InstanceCells& cells, const LightView& view,
                   const ReceiverCells& receivers, std::vector<std::uint32_t>& casters) {
    CasterSearch search(cells, view, receivers, casters);
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
