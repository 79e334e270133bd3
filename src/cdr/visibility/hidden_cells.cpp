#include <cdr/visibility/hidden_cells.h>

#include <bit>
#include <cmath>

namespace cdr::visibility {

namespace {

constexpr std::size_t kPartsPerJob = 128;
/// Pixels by which a rectangle is larger than its object: what a device snaps vertices by is less.
constexpr double kRim = 1.0;
/// By so many radii an object counts as nearer than its bounding sphere. On a face that is seen edge-on, depth at a pixel's
/// centre may be outside the range of depths at its corners.
constexpr double kRadiiNearer = 1.0;

/// Bounds along the picture's axes (SphereTest): x to the right, y up, z the view distance.
struct ViewBounds {
    glm::dvec3 low;
    glm::dvec3 high;
};

/// Where boxes and spheres lie in the picture.
class Projection {
  public:
    Projection(const SphereTest& camera, const scene::Frustum& frustum, const DepthTiles& tiles)
        : m_camera(camera),
          m_tiles(tiles),
          m_perX(0.5 / frustum.tanX),
          m_perY(0.5 / frustum.tanY),
          m_height(2.0 * frustum.tanY / frustum.footprintSlope),
          m_width(m_height * frustum.aspect),
          m_radii(std::hypot(1.0, frustum.centre.x), std::hypot(1.0, frustum.centre.y), 1.0) {}

    /// @param centres bounds of the centres of spheres no larger than `radius`.
    bool isHidden(const ViewBounds& centres, double radius) const {
        const glm::dvec3 low = centres.low - radius * m_radii;
        const glm::dvec3 high = centres.high + radius * m_radii;
        if (!(low.z > m_camera.nearView)) { // or not a number
            return false;
        }
        const auto lowest = [&](double x) { return x / (x < 0.0 ? low.z : high.z); };
        const auto highest = [&](double x) { return x / (x < 0.0 ? high.z : low.z); };
        const PixelRect rect{.left = (0.5 + m_perX * lowest(low.x)) * m_width - kRim,
                             .top = (0.5 - m_perY * highest(high.y)) * m_height - kRim,
                             .right = (0.5 + m_perX * highest(high.x)) * m_width + kRim,
                             .bottom = (0.5 - m_perY * lowest(low.y)) * m_height + kRim};
        return m_tiles.hides(rect, low.z - kRadiiNearer * radius);
    }

    bool isHidden(const InstanceCells::Box& box) const {
        const glm::dvec3 middle = turn(0.5 * (box.low + box.high) - m_camera.position);
        const glm::dvec3 half = 0.5 * (box.high - box.low);
        const glm::dvec3 reach(glm::dot(glm::abs(m_camera.right), half),
                               glm::dot(glm::abs(m_camera.up), half),
                               glm::dot(glm::abs(m_camera.back), half));
        return isHidden({middle - reach, middle + reach}, box.radius);
    }

    bool isHidden(const Spheres& spheres, std::size_t slot) const {
        const glm::dvec3 centre =
            turn(glm::dvec3(spheres.x[slot], spheres.y[slot], spheres.z[slot]) - m_camera.position);
        return isHidden({centre, centre}, static_cast<double>(spheres.radius[slot]));
    }

  private:
    glm::dvec3 turn(const glm::dvec3& offset) const {
        return {glm::dot(m_camera.right, offset), glm::dot(m_camera.up, offset),
                -glm::dot(m_camera.back, offset)};
    }

    const SphereTest& m_camera;
    const DepthTiles& m_tiles;
    double m_perX;
    double m_perY;
    double m_height; ///< of the picture, in pixels
    double m_width;
    glm::dvec3 m_radii; ///< how far a sphere of radius 1 reaches along the picture's axes
};

std::uint64_t shown(const InstanceCells& cells, const VisibleCells::Part& part,
                    const Projection& projection) {
    if (projection.isHidden(cells.levels().front()[part.cell])) {
        return 0;
    }
    const Spheres spheres = cells.spheres(part.cell);
    std::uint64_t kept = part.slots;
    for (std::uint64_t slots = part.slots; slots != 0; slots &= slots - 1) {
        const auto slot = static_cast<std::size_t>(std::countr_zero(slots));
        if (projection.isHidden(spheres, slot)) {
            kept &= ~(std::uint64_t{1} << slot);
        }
    }
    return kept;
}

} // namespace

void dropHidden(const scene::Frustum& frustum, const DepthTiles& tiles, platform::WorkerPool& workers,
                VisibleCells& visible) {
    if (visible.parts.empty()) {
        return;
    }
    const Projection projection(visible.test, frustum, tiles);
    const std::size_t jobs = (visible.parts.size() + kPartsPerJob - 1) / kPartsPerJob;
    workers.run(jobs, [&](std::size_t job, std::size_t) {
        const platform::IndexRange range = platform::evenRange(visible.parts.size(), job, jobs);
        for (std::size_t i = range.begin; i < range.end; ++i) {
            visible.parts[i].slots = shown(*visible.cells, visible.parts[i], projection);
        }
    });
    std::erase_if(visible.parts, [](const VisibleCells::Part& part) { return part.slots == 0; });
}

} // namespace cdr::visibility
