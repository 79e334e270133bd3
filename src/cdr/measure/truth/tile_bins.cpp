#include <cdr/measure/truth/tile_bins.h>

#include <algorithm>

namespace cdr::measure {

namespace {

std::uint32_t tilesAcross(std::uint32_t pixels) {
    return (pixels + TileBins::kSide - 1) / TileBins::kSide;
}

} // namespace

TileBins::TileBins(std::uint32_t width, std::uint32_t height, std::span<const PixelRect> rects)
    : m_width(width),
      m_height(height),
      m_columns(tilesAcross(width)),
      m_begins(std::size_t{m_columns} * tilesAcross(height) + 1, 0) {
    // Counting sort: count per tile, turn counts into begins, then fill.
    for (const PixelRect& rect : rects) {
        visitTiles(rect, [&](std::size_t tile) { ++m_begins[tile + 1]; });
    }
    for (std::size_t tile = 0; tile < tiles(); ++tile) {
        m_begins[tile + 1] += m_begins[tile];
    }
    m_members.resize(m_begins.back());
    std::vector<std::size_t> next(m_begins.begin(), m_begins.end() - 1);
    for (std::size_t i = 0; i < rects.size(); ++i) {
        visitTiles(rects[i],
                   [&](std::size_t tile) { m_members[next[tile]++] = static_cast<std::uint32_t>(i); });
    }
}

PixelRect TileBins::pixels(std::size_t tile) const {
    const auto left = static_cast<std::uint32_t>(tile % m_columns) * kSide;
    const auto top = static_cast<std::uint32_t>(tile / m_columns) * kSide;
    return {left, top, std::min(left + kSide, m_width), std::min(top + kSide, m_height)};
}

template <typename Visitor>
void TileBins::visitTiles(const PixelRect& rect, const Visitor& visit) const {
    if (rect.empty()) {
        return;
    }
    for (std::uint32_t row = rect.top / kSide; row <= (rect.bottom - 1) / kSide; ++row) {
        for (std::uint32_t column = rect.left / kSide; column <= (rect.right - 1) / kSide; ++column) {
            visit(std::size_t{row} * m_columns + column);
        }
    }
}

} // namespace cdr::measure
