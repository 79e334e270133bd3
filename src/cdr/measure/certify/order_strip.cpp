#include <cdr/measure/certify/order_strip.h>

#include <algorithm>
#include <cmath>

namespace cdr::measure {

namespace {

/// What lies this share beyond the drawn distance, and four steps of the buffer, is not looked at.
constexpr double kBehindShare = 1e-3;
constexpr double kBehindSteps = 4.0;
/// The distance that a picture keeps is interpolated apart from depth, and divided once more.
constexpr double kSurfaceRoundings = 2.0;

std::uint32_t clampedPixel(double place, std::uint32_t end) {
    return static_cast<std::uint32_t>(std::clamp(place, 0.0, static_cast<double>(end)));
}

} // namespace

OrderStrip::OrderStrip(const DrawnFrame& frame, const DeviceBound& bound, const PixelRect& pixels,
                       double farthestLayer)
    : m_frame(frame),
      m_bound(bound),
      m_readsMasks(false),
      m_pixels(pixels),
      m_tileColumns((frame.ids.width + kTile - 1) / kTile) {
    const std::uint32_t rows = pixels.bottom - pixels.top;
    m_orders.resize(std::size_t{rows} * frame.ids.width);
    m_reach.resize(m_orders.size());
    m_tileReach.assign(std::size_t{(rows + kTile - 1) / kTile} * m_tileColumns, 0.0);
    for (std::uint32_t y = pixels.top; y < pixels.bottom; ++y) {
        for (std::uint32_t x = 0; x < frame.ids.width; ++x) {
            const double drawn = frame.distancesView.at(x, y);
            const double reach =
                frame.ids.at(x, y) == 0
                    ? kNever
                    : drawn * (1.0 + kBehindShare) + kBehindSteps * bound.stepView(drawn) + farthestLayer;
            keepReach(x, y, reach);
        }
    }
}

OrderStrip::OrderStrip(const OrderStrip& device, std::span<const glm::uvec2> open, const DeviceBound& bound)
    : m_frame(device.m_frame),
      m_bound(bound),
      m_readsMasks(true),
      m_pixels(device.m_pixels),
      m_reach(device.m_reach.size(), 0.0),
      m_tileColumns(device.m_tileColumns),
      m_tileReach(device.m_tileReach.size(), 0.0),
      m_orders(device.m_orders.size()) {
    for (const glm::uvec2& pixel : open) {
        keepReach(pixel.x, pixel.y, device.m_reach[indexOf(pixel.x, pixel.y)]);
    }
}

void OrderStrip::keepReach(std::uint32_t x, std::uint32_t y, double reach) {
    m_reach[indexOf(x, y)] = reach;
    double& tile = m_tileReach[std::size_t{(y - m_pixels.top) / kTile} * m_tileColumns + x / kTile];
    tile = std::max(tile, reach);
}

bool OrderStrip::hides(const PixelRect& pixels, double leastView) const {
    const PixelRect inside = intersection(pixels, m_pixels);
    if (inside.empty()) {
        return true;
    }
    for (std::uint32_t row = (inside.top - m_pixels.top) / kTile;
         row <= (inside.bottom - 1 - m_pixels.top) / kTile; ++row) {
        for (std::uint32_t column = inside.left / kTile; column <= (inside.right - 1) / kTile; ++column) {
            if (leastView <= m_tileReach[std::size_t{row} * m_tileColumns + column]) {
                return false;
            }
        }
    }
    return true;
}

void OrderStrip::Edge::cut(Span& span, double y, double least) const {
    const double needed = least - (perY * y + atOrigin);
    if (perX > 0.0) {
        span.first = std::max(span.first, std::ceil(needed / perX));
    } else if (perX < 0.0) {
        span.last = std::min(span.last, std::floor(needed / perX));
    } else if (needed > 0.0) {
        span.last = span.first - 1.0;
    }
}

std::array<OrderStrip::Edge, 3> OrderStrip::edgesOf(const ScreenTriangle& triangle) const {
    std::array<Edge, 3> edges{};
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2& from = triangle.corners[i];
        const glm::dvec2 along = triangle.corners[(i + 1) % 3] - from;
        edges[i] = {.perX = -along.y,
                    .perY = along.x,
                    .atOrigin = along.y * from.x - along.x * from.y,
                    .margin = triangle.bound.pixels * (std::abs(along.x) + std::abs(along.y))};
    }
    return edges;
}

PixelRect OrderStrip::boxOf(const ScreenTriangle& triangle) const {
    const auto& [a, b, c] = triangle.corners;
    const glm::dvec2 least = glm::min(a, glm::min(b, c)) - triangle.bound.pixels;
    const glm::dvec2 most = glm::max(a, glm::max(b, c)) + triangle.bound.pixels;
    const PixelRect box{clampedPixel(std::ceil(least.x), m_frame.ids.width),
                        clampedPixel(std::ceil(least.y), m_frame.ids.height),
                        clampedPixel(std::floor(most.x) + 1.0, m_frame.ids.width),
                        clampedPixel(std::floor(most.y) + 1.0, m_frame.ids.height)};
    return intersection(box, m_pixels);
}

void OrderStrip::enter(const ScreenTriangle& triangle, const StripSurface& surface) {
    const PixelRect box = boxOf(triangle);
    if (box.empty() || hides(box, triangle.leastView - surface.layer.view)) {
        return;
    }
    if (triangle.isThin) {
        enterThin(triangle, surface, box);
        return;
    }
    const std::array<Edge, 3> edges = edgesOf(triangle);
    for (std::uint32_t row = box.top; row < box.bottom; ++row) {
        enterRow(triangle, surface, edges, box, row);
    }
}

void OrderStrip::enterRow(const ScreenTriangle& triangle, const StripSurface& surface,
                          const std::array<Edge, 3>& edges, const PixelRect& box, std::uint32_t row) {
    Span outer{static_cast<double>(box.left), box.right - 1.0};
    Span inner = outer;
    for (const Edge& edge : edges) {
        edge.cut(outer, row, -edge.margin);
        edge.cut(inner, row, edge.margin);
    }
    if (!(outer.first <= outer.last)) {
        return;
    }
    const auto end = static_cast<std::uint32_t>(outer.last) + 1;
    for (auto x = static_cast<std::uint32_t>(outer.first); x < end; ++x) {
        const bool isWithin = x >= inner.first && x <= inner.last;
        enterPixel(triangle, surface, x, row, isWithin ? Cover::within : coverAt(triangle, edges, x, row));
    }
}

OrderStrip::Cover OrderStrip::coverAt(const ScreenTriangle& triangle, const std::array<Edge, 3>& edges,
                                      double x, double y) const {
    Cover cover = Cover::surely;
    for (std::size_t i = 0; i < 3; ++i) {
        const double inside = edges[i].at(x, y);
        if (std::abs(inside) > edges[i].margin) {
            continue;
        }
        if (!triangle.goesOn[i]) {
            return Cover::perhaps;
        }
        if (inside < 0.0) {
            cover = Cover::goesOn;
        }
    }
    return cover;
}

/// A thin triangle lies within four times of what its corners are off from its longest edge.
void OrderStrip::enterThin(const ScreenTriangle& triangle, const StripSurface& surface,
                           const PixelRect& box) {
    std::array<Edge, 3> edges = edgesOf(triangle);
    Edge& longest = *std::ranges::max_element(edges, {}, &Edge::margin);
    longest.margin = 6.0 * longest.margin + 16.0 * triangle.bound.pixels * triangle.bound.pixels;
    Edge mirrored{-longest.perX, -longest.perY, -longest.atOrigin, longest.margin};
    const double surfaceOff =
        kSurfaceRoundings * DeviceBound::surfaceView(triangle.drawnBound, triangle.mostView, 0.0);
    for (std::uint32_t row = box.top; row < box.bottom; ++row) {
        Span span{static_cast<double>(box.left), box.right - 1.0};
        longest.cut(span, row, -longest.margin);
        mirrored.cut(span, row, -longest.margin);
        for (double x = span.first; x <= span.last; x += 1.0) {
            const auto column = static_cast<std::uint32_t>(x);
            const double least = triangle.leastView;
            if (least - surface.layer.view <= m_reach[indexOf(column, row)]) {
                const double off = m_bound.orderView(triangle.bound, least, 0.0, surface.layer);
                enterPerhaps(surface, column, row, intervalAt(surface, least, 0.0, off).least, surfaceOff);
            }
        }
    }
}

OrderStrip::Interval OrderStrip::intervalAt(const StripSurface& surface, double distanceView,
                                            double slopeView, double offView) const {
    const LayerOffset& layer = surface.layer;
    const double partingView = m_bound.partingView(layer, distanceView, slopeView);
    return {distanceView - layer.view - offView - (layer.view > 0.0 ? partingView : 0.0),
            distanceView - layer.movedView(distanceView) + offView + (layer.view < 0.0 ? partingView : 0.0)};
}

void OrderStrip::enterPerhaps(const StripSurface& surface, std::uint32_t x, std::uint32_t y, double least,
                              double offView) {
    Order& order = m_orders[indexOf(x, y)];
    if (surface.alphaMode == scene::AlphaMode::blend) {
        order.blendedLeast = std::min(order.blendedLeast, least);
        return;
    }
    if (surface.alphaMode == scene::AlphaMode::mask) {
        order.maskedLeast = std::min(order.maskedLeast, least);
    }
    if (surface.id == m_frame.ids.at(x, y)) {
        order.least = std::min(order.least, least);
        order.mostBeside = kNever;
        order.offView = std::min(order.offView, offView);
    } else {
        order.otherLeast = std::min(order.otherLeast, least);
    }
}

void OrderStrip::enterPixel(const ScreenTriangle& triangle, const StripSurface& surface, std::uint32_t x,
                            std::uint32_t y, Cover cover) {
    const double w =
        std::clamp(1.0 / (triangle.inverse[0] + triangle.inverse[1] * x + triangle.inverse[2] * y),
                   triangle.leastView, triangle.mostView);
    const double slope = w * w * (std::abs(triangle.inverse[1]) + std::abs(triangle.inverse[2]));
    const double off = m_bound.orderView(triangle.bound, w, slope, surface.layer);
    const Interval place = intervalAt(surface, w, slope, off);
    // A device cuts at the ends of its range where the surface is, or where it is moved to.
    const double least = std::min(place.least, w - off);
    const double most = std::max(place.most, w + off);
    const scene::Camera& camera = m_frame.camera;
    if (place.least > m_reach[indexOf(x, y)] || most < camera.nearView || least > camera.farView) {
        return;
    }
    if (cover != Cover::goesOn && (least < camera.nearView || most > camera.farView)) {
        cover = Cover::perhaps;
    }
    const double surfaceOff = kSurfaceRoundings * DeviceBound::surfaceView(triangle.drawnBound, w, slope);
    Order& order = m_orders[indexOf(x, y)];
    const bool readsMask = m_readsMasks && surface.masked != nullptr;
    if (readsMask) {
        order.maskedLeast = std::min(order.maskedLeast, place.least);
        if (surface.masked->cutsAt(triangle.first, x, y)) {
            if (cover != Cover::within && surface.id == m_frame.ids.at(x, y)) {
                order.mostBeside = kNever; // what is kept beyond the edge may end there
            }
            return;
        }
    }
    if (cover == Cover::perhaps || (surface.alphaMode != scene::AlphaMode::opaque && !readsMask)) {
        enterPerhaps(surface, x, y, place.least, surfaceOff);
        return;
    }
    if (surface.id != m_frame.ids.at(x, y)) {
        order.otherLeast = std::min(order.otherLeast, place.least);
        // Near an edge beyond which it goes on, it may end there too: another triangle says so, to the drawn object alone.
        if (cover == Cover::within) {
            order.otherMost = std::min(order.otherMost, place.most);
        }
        return;
    }
    order.least = std::min(order.least, place.least);
    order.offView = std::min(order.offView, surfaceOff);
    if (cover == Cover::goesOn) {
        order.mostBeside = std::max(order.mostBeside, place.most);
        return;
    }
    order.most = std::min(order.most, place.most);
    const double orderedView = w - surface.layer.movedView(w);
    if (orderedView < order.nearest) {
        order.nearest = orderedView;
        order.isAtDrawn = std::abs(w - m_frame.distancesView.at(x, y)) <= surfaceOff;
    }
}

bool OrderStrip::lookFarther() {
    bool looks = false;
    for (std::uint32_t y = m_pixels.top; y < m_pixels.bottom; ++y) {
        for (std::uint32_t x = 0; x < m_frame.ids.width; ++x) {
            if (m_reach[indexOf(x, y)] < kNever && findingAt(x, y).verdict == PixelVerdict::refused) {
                keepReach(x, y, kNever);
                looks = true;
            }
        }
    }
    return looks;
}

PixelFinding OrderStrip::findingAt(std::uint32_t x, std::uint32_t y) const {
    const Order& order = m_orders[indexOf(x, y)];
    const double reach = m_reach[indexOf(x, y)];
    const bool isBackground = m_frame.ids.at(x, y) == 0;
    return {.verdict = isBackground ? verdictOnBackground(order) : verdictOnObject(order, reach),
            .isMasked = order.maskedLeast < kNever && order.maskedLeast <= order.most,
            .isBlended = order.blendedLeast < kNever && order.blendedLeast <= order.most,
            .offView = order.offView < kNever ? static_cast<float>(order.offView) : 0.0f};
}

PixelVerdict OrderStrip::verdictOnBackground(const Order& order) {
    return order.otherMost < kNever    ? PixelVerdict::refused
           : order.otherLeast < kNever ? PixelVerdict::open
                                       : PixelVerdict::certified;
}

PixelVerdict OrderStrip::verdictOnObject(const Order& order, double reach) {
    if (order.otherMost < order.least || order.least == kNever) {
        return PixelVerdict::refused;
    }
    const double most = std::max(order.most, order.mostBeside);
    // Beyond the reach others were not looked at.
    const bool isNearest = most < order.otherLeast && most <= reach;
    return isNearest && order.isAtDrawn ? PixelVerdict::certified : PixelVerdict::open;
}

} // namespace cdr::measure
