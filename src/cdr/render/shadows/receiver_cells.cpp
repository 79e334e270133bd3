#include <cdr/render/shadows/receiver_cells.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cdr::render {

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
/// Texels around a surface: of the two by two that it reads, and of roundings.
constexpr double kMargin = kMapBorder + 1.0;

struct Interval {
    double low = kUnbounded;
    double high = -kUnbounded;
};

/// The cells of a row or column that an interval reaches into.
struct Span {
    std::size_t begin = 0;
    std::size_t end = 0;

    /// @param side cells of a row, at most 64
    Span(const Interval& interval, std::size_t side)
        : begin(clamped(std::floor(interval.low), side)),
          end(clamped(std::ceil(interval.high), side)) {}
    std::uint64_t bits() const {
        const auto below = [](std::size_t cell) {
            return cell >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << cell) - 1;
        };
        return begin < end ? below(end) & ~below(begin) : 0;
    }

  private:
    static std::size_t clamped(double cell, std::size_t side) {
        return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(side)));
    }
};

/// Where a convex body lies between two heights.
Interval acrossBand(const SeenCorners& corners, const Interval& band) {
    Interval across;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const auto& [upper, lower] = std::minmax(
                corners[i], corners[j], [](const auto& one, const auto& other) { return one.y < other.y; });
            if (upper.y > band.high || lower.y < band.low) {
                continue;
            }
            const glm::dvec2 way = lower - upper;
            const double begin = way.y > 0.0 ? std::max((band.low - upper.y) / way.y, 0.0) : 0.0;
            const double end = way.y > 0.0 ? std::min((band.high - upper.y) / way.y, 1.0) : 1.0;
            for (const double share : {begin, end}) {
                across.low = std::min(across.low, upper.x + way.x * share);
                across.high = std::max(across.high, upper.x + way.x * share);
            }
        }
    }
    return across;
}

} // namespace

ReceiverCells::ReceiverCells(const LightView& view, const ReceiverSlice& slice, const glm::dvec3& camera)
    : m_wOffset(view.wOffset),
      m_wPerUnit(view.wPerUnit),
      m_low(view.low),
      m_perUnit(double{kSide} / (view.texel * glm::dvec2(view.size.width, view.size.height))),
      m_margin(kMargin * view.texel * m_perUnit) {
    const glm::dvec3 shift = camera - view.origin;
    for (const SeenSphere& sphere : slice.seen) {
        add(areaOf(view.toLight(shift + sphere.centre), glm::dvec3(sphere.radius)));
    }
    if (std::optional<SeenCorners> corners = seenBy(view, slice.view, -shift)) { // else it may cover anything
        for (glm::dvec2& corner : *corners) {
            corner = cellsAt(corner, 1.0);
        }
        keepWithin(*corners);
    }
}

bool ReceiverCells::meet(const glm::dvec3& middle, const glm::dvec3& half) const {
    const Area area = areaOf(middle, half);
    const Span rows({area.low.y, area.high.y}, kSide);
    const std::uint64_t columns = Span({area.low.x, area.high.x}, kSide).bits();
    for (std::size_t row = rows.begin; row < rows.end; ++row) {
        if ((m_rows[row] & columns) != 0) {
            return true;
        }
    }
    return false;
}

ReceiverCells::Area ReceiverCells::areaOf(const glm::dvec3& middle, const glm::dvec3& half) const {
    const double nearW = m_wOffset + m_wPerUnit * (middle.z - half.z);
    const double farW = m_wOffset + m_wPerUnit * (middle.z + half.z);
    if (nearW <= 0.0) { // reaches behind the light
        return {glm::dvec2(-kUnbounded), glm::dvec2(kUnbounded)};
    }
    const glm::dvec2 low = glm::dvec2(middle) - glm::dvec2(half);
    const glm::dvec2 high = glm::dvec2(middle) + glm::dvec2(half);
    return {glm::min(cellsAt(low, nearW), cellsAt(low, farW)) - m_margin,
            glm::max(cellsAt(high, nearW), cellsAt(high, farW)) + m_margin};
}

void ReceiverCells::add(const Area& area) {
    const Span rows({area.low.y, area.high.y}, kSide);
    const std::uint64_t columns = Span({area.low.x, area.high.x}, kSide).bits();
    for (std::size_t row = rows.begin; row < rows.end; ++row) {
        m_rows[row] |= columns;
    }
}

/// Clears the cells beside a convex body.
void ReceiverCells::keepWithin(const SeenCorners& corners) {
    for (std::size_t row = 0; row < kSide; ++row) {
        const auto top = static_cast<double>(row);
        const Interval across = acrossBand(corners, {top - m_margin.y, top + 1.0 + m_margin.y});
        m_rows[row] &= Span({across.low - m_margin.x, across.high + m_margin.x}, kSide).bits();
    }
}

} // namespace cdr::render
