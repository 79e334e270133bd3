#include "require_length.h"

#include <cdr/render/focus.h>

#include <algorithm>
#include <cmath>

namespace cdr::render {

namespace {

/// How much earlier overlapping cascades begin, as a share of their near plane.
constexpr double kOverlap = 0.2;

} // namespace

void requireUsable(const Focus& focus) {
    requireLength("the distance in focus", focus.distance);
    requireLength("the aperture of the lens", focus.aperture);
}

FocusLens::FocusLens(const Focus& focus, double tanY, std::uint32_t height)
    : m_distance(focus.distance),
      m_circleAtInfinity(focus.aperture * height / (2.0 * tanY * focus.distance)) {}

double FocusLens::circleAt(double distanceView) const {
    return m_circleAtInfinity * std::abs(1.0 - m_distance / distanceView);
}

std::uint32_t FocusLens::scaleOf(const depth::Cascade& range) const {
    if (range.nearView <= m_distance && m_distance <= range.farView) {
        return 1;
    }
    const double smallest = std::min(circleAt(range.nearView), circleAt(range.farView));
    std::uint32_t scale = 1;
    while (scale < kMaxFocusScale && 2.0 * scale <= smallest) {
        scale *= 2;
    }
    return scale;
}

depth::Cascades FocusLens::overlapping(const depth::Cascades& cascades) const {
    depth::Cascades ranges = cascades;
    for (std::size_t i = 1; i < ranges.size(); ++i) {
        const depth::Cascade& before = cascades[i - 1];
        if (before.farView != cascades[i].nearView) {
            continue; // nothing lies between them
        }
        ranges[i].nearView = std::max((1.0 - kOverlap) * cascades[i].nearView, before.nearView);
        const double half = 0.5 * scaleOf(cascades[i]);
        if (cascades[i].nearView > m_distance && half >= 1.0) {
            ranges[i].nearView = std::max(ranges[i].nearView, m_distance / (1.0 - half / m_circleAtInfinity));
        }
    }
    return ranges;
}

std::vector<double> FocusLens::boundaries() const {
    if (m_circleAtInfinity == 0.0) {
        return {};
    }
    // A little wider, so that no rounding takes the cascade behind a boundary for a sharper one.
    constexpr double kWider = 1.0 + 1e-9;
    std::vector<double> distances;
    for (std::uint32_t scale = kMaxFocusScale; scale >= 2; scale /= 2) {
        distances.push_back(m_distance / (1.0 + kWider * scale / m_circleAtInfinity));
    }
    for (std::uint32_t scale = 2; scale <= kMaxFocusScale; scale *= 2) {
        if (kWider * scale < m_circleAtInfinity) {
            distances.push_back(m_distance / (1.0 - kWider * scale / m_circleAtInfinity));
        }
    }
    return distances;
}

} // namespace cdr::render
