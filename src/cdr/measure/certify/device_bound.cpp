#include <cdr/depth/separation.h>
#include <cdr/measure/certify/device_bound.h>
#include <cdr/measure/truth/lens.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cdr::measure {

namespace {

constexpr double kFloatRounding = 0x1p-24;
/// No triangle is placed more exactly, pixels.
constexpr double kMinPixels = 0x1p-30;
/// Cells go by the exponent and the first 5 bits of the mantissa.
constexpr unsigned kCellShift = 47;

std::uint64_t cellNumber(double distanceView) {
    return std::bit_cast<std::uint64_t>(distanceView) >> kCellShift;
}

double cellBegin(std::uint64_t number) {
    return std::bit_cast<double>(number << kCellShift);
}

} // namespace

void FrameBound::add(const TriangleBound& bound) {
    add(FrameBound{.pixels = bound.pixels, .distanceView = bound.distanceView, .depth = bound.depth});
}

void FrameBound::add(const FrameBound& other) {
    pixels = std::max(pixels, other.pixels);
    distanceView = std::max(distanceView, other.distanceView);
    depth = std::max(depth, other.depth);
    stepView = std::max(stepView, other.stepView);
}

DeviceBound::DeviceBound(const DrawnFrame& frame, double rounding, double snapPixels)
    : m_rounding(rounding),
      m_snapPixels(snapPixels),
      m_pixelsPerSlope(pixelsPerSlope(frame.camera, frame.ids.height)),
      m_picturePixels(double{1.0} * frame.ids.width + frame.ids.height),
      m_shiftPixels(m_pixelsPerSlope *
                    std::max(std::abs(frame.camera.lensShift.x), std::abs(frame.camera.lensShift.y))) {}

DeviceBound DeviceBound::ofFloat64(const DrawnFrame& frame) {
    return {frame, kDoubleOperation, kMinPixels};
}

DeviceBound::DeviceBound(const DrawnFrame& frame) : DeviceBound(frame, kFloatRounding, frame.snapPixels) {
    m_bends = frame.technique.mapping == depth::Mapping::log;
    const depth::Mapping mapping = frame.technique.mapping;
    const depth::FarEnd farEnd = depth::farEndOf(frame.technique.split);
    for (std::size_t i = 0; i < frame.cascades.size(); ++i) {
        const depth::DepthRange range = depth::depthRange(mapping, frame.cascades, i, farEnd);
        m_ranges.push_back({.clip = depth::clipRange(mapping, frame.cascades, i),
                            .range = range,
                            .anchorView = depth::clipTerms(range).anchorView});
    }
    if (m_ranges.empty()) {
        return;
    }
    m_cells.clear();
    m_firstCell = cellNumber(m_ranges.front().clip.nearView);
    const std::uint64_t lastCell = cellNumber(m_ranges.back().clip.farView);
    for (std::uint64_t cell = m_firstCell; cell <= lastCell; ++cell) {
        m_cells.push_back(makeCell(cellBegin(cell), cellBegin(cell + 1), frame.technique.format));
    }
}

DeviceBound::Cell DeviceBound::makeCell(double leastView, double mostView, depth::DepthFormat format) const {
    Cell cell;
    for (const Range& range : m_ranges) {
        const double least = std::max(leastView, range.clip.nearView);
        const double most = std::min(mostView, range.clip.farView);
        if (least > most) {
            continue;
        }
        for (const double w : {least, 0.5 * (least + most), most}) {
            // At the far end no farther value exists, but nearer surfaces are still resolved.
            const double inside =
                std::min(w, range.clip.farView - 1e-3 * (range.clip.farView - range.clip.nearView));
            cell.stepView =
                std::max(cell.stepView,
                         depth::separationView(range.range, format, std::max(inside, range.clip.nearView)));
            cell.viewPerDepth = std::max(cell.viewPerDepth, 1.0 / depth::depthSlope(range.range, w));
        }
    }
    // Float32's step doubles where its exponent changes, which may be between the three.
    cell.stepView *= 2.0;
    return cell;
}

const DeviceBound::Cell& DeviceBound::cellAt(double distanceView) const {
    const std::uint64_t number = cellNumber(std::max(distanceView, 0.0));
    const std::uint64_t index = number > m_firstCell ? number - m_firstCell : 0;
    return m_cells[std::min<std::uint64_t>(index, m_cells.size() - 1)];
}

double DeviceBound::anchorPixels(const TriangleReach& reach, double beforeAnchor) const {
    const double share = 6.0 * m_rounding * beforeAnchor / reach.leastView;
    const double across = reach.acrossView * m_pixelsPerSlope / reach.leastView;
    return share < 0.5 ? across * share / (1.0 - share) : 16.0 * (across + m_picturePixels + m_shiftPixels);
}

TriangleBound DeviceBound::of(const TriangleReach& reach) const {
    TriangleBound bound;
    // Roundings of x, of w (by which x is divided), and of the viewport, a lens shift and a plane over the picture.
    bound.pixels = m_snapPixels + m_rounding * (reach.acrossView * m_pixelsPerSlope / reach.leastView *
                                                    (10.0 + 4.0 * reach.alongView / reach.leastView) +
                                                4.0 * (m_picturePixels + m_shiftPixels));
    double depth = 0.0;
    double beyondAnchor = m_ranges.empty() ? reach.mostView : 0.0;
    double beforeAnchor = 0.0;
    const double leastMoved = reach.leastView - reach.layer.movedView(reach.leastView);
    const double mostMoved = reach.mostView - reach.layer.movedView(reach.mostView);
    for (const Range& range : m_ranges) {
        if (std::max(reach.mostView, mostMoved) < range.clip.nearView ||
            std::min(reach.leastView, leastMoved) > range.clip.farView) {
            continue;
        }
        beforeAnchor = std::max(beforeAnchor, range.anchorView - reach.leastView);
        for (const double w : {reach.leastView, reach.mostView, leastMoved, mostMoved}) {
            const double clipped = std::clamp(w, range.clip.nearView, range.clip.farView);
            depth = std::max(depth, std::abs(depth::zNdcAt(range.range, clipped)));
            beyondAnchor = std::max(beyondAnchor, std::abs(w - range.anchorView));
        }
    }
    bound.pixels += anchorPixels(reach, beforeAnchor);
    // Float64 rounds along all three axes, and a point of the picture moves by its slope too where its distance does.
    const double placedView = kDoubleOperation * reach.summedView;
    bound.pixels += placedView * (m_pixelsPerSlope + m_picturePixels + m_shiftPixels) / reach.leastView;
    bound.depth = (reach.layer.view == 0.0 ? 8.0 : 16.0) * m_rounding * std::min(depth, 1.0);
    bound.distanceView = 8.0 * m_rounding * (beyondAnchor + reach.alongView) + placedView;
    if (m_bends) {
        const double octaves = std::log(reach.mostView / reach.leastView);
        bound.bend = octaves * octaves / 8.0;
    }
    return bound;
}

} // namespace cdr::measure
