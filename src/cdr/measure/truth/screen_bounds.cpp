#include <cdr/measure/truth/lens.h>
#include <cdr/measure/truth/screen_bounds.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cdr::measure {

namespace {

struct SlopeRange {
    double least = kNoHit;
    double most = -kNoHit;

    /// Adds the slopes under which a point is seen that is known to `rounding` only.
    void add(double lateral, double distanceView, double rounding) {
        const double slope = lateral / distanceView;
        const double slack = rounding / distanceView * (1.0 + std::abs(slope)) + 1e-14 * std::abs(slope);
        least = std::min(least, slope - slack);
        most = std::max(most, slope + slack);
    }
};

using Corners = std::array<glm::dvec3, 8>;

Corners cornersOf(const ViewBox& box) {
    Corners corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] = box.centre + (i & 1 ? box.halfSides[0] : -box.halfSides[0]) +
                     (i & 2 ? box.halfSides[1] : -box.halfSides[1]) +
                     (i & 4 ? box.halfSides[2] : -box.halfSides[2]);
    }
    return corners;
}

/// Calls `visit` with the corners of the part of the box that is at least `clipView` away.
template <typename Visitor>
void visitClipped(const Corners& corners, double clipView, const Visitor& visit) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i].z >= clipView) {
            visit(corners[i]);
        }
        for (std::size_t bit = 1; bit < corners.size(); bit *= 2) {
            const glm::dvec3& a = corners[i];
            const glm::dvec3& b = corners[i | bit];
            if ((i & bit) == 0 && (a.z < clipView) != (b.z < clipView)) {
                const double along = (clipView - a.z) / (b.z - a.z);
                visit(glm::dvec3(glm::dvec2(a) + (glm::dvec2(b) - glm::dvec2(a)) * along, clipView));
            }
        }
    }
}

/// The half-open range of pixels of `count` whose centre position, in pixels, lies in [least, most].
std::array<std::uint32_t, 2> pixelsWithin(double least, double most, std::uint32_t count) {
    const double first = std::clamp(std::ceil(least), 0.0, static_cast<double>(count));
    const double end = std::clamp(std::floor(most) + 1.0, 0.0, static_cast<double>(count));
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end)};
}

} // namespace

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
            std::min(a.bottom, b.bottom)};
}

std::optional<Footprint> footprint(const ViewBox& box, const scene::Camera& camera, std::uint32_t width,
                                   std::uint32_t height, double marginPixels) {
    const double reach = std::abs(box.halfSides[0].z) + std::abs(box.halfSides[1].z) +
                         std::abs(box.halfSides[2].z) + box.rounding;
    if (box.centre.z - reach > camera.farView || box.centre.z + reach < camera.nearView) {
        return std::nullopt;
    }
    const double nearestView = std::max(box.centre.z - reach, camera.nearView);
    // Clipped a little before near, so that what rounds to just beyond near is still inside.
    const double clipView = camera.nearView - box.rounding;
    if (clipView <= 0.5 * camera.nearView && box.centre.z - reach < clipView) {
        return Footprint{{0, 0, width, height}, nearestView};
    }
    SlopeRange x;
    SlopeRange y;
    visitClipped(cornersOf(box), clipView, [&](const glm::dvec3& corner) {
        x.add(corner.x, corner.z, box.rounding);
        y.add(corner.y, corner.z, box.rounding);
    });
    // The inverse of pixelSlopes.
    const double perSlope = pixelsPerSlope(camera, height);
    const glm::dvec2 axis = axisPixel(camera, width, height);
    const auto columns = pixelsWithin(axis.x + x.least * perSlope - marginPixels,
                                      axis.x + x.most * perSlope + marginPixels, width);
    const auto rows = pixelsWithin(axis.y - y.most * perSlope - marginPixels,
                                   axis.y - y.least * perSlope + marginPixels, height);
    const PixelRect pixels{columns[0], rows[0], columns[1], rows[1]};
    return pixels.empty() ? std::nullopt : std::optional(Footprint{pixels, nearestView});
}

} // namespace cdr::measure
