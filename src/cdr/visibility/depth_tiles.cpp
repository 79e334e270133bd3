#include <cdr/visibility/depth_tiles.h>

#include <algorithm>
#include <limits>

namespace cdr::visibility {

namespace {

constexpr double kOpen = std::numeric_limits<double>::infinity();

std::uint32_t halved(std::uint32_t count) {
    return (count + 1) / 2;
}

} // namespace

DepthTiles::DepthTiles(std::uint32_t width, std::uint32_t height) : m_width(width), m_height(height) {
    std::uint32_t columns = (width + kSide - 1) / kSide;
    std::uint32_t rows = (height + kSide - 1) / kSide;
    const auto addLevel = [&] {
        m_levels.push_back(
            {.columns = columns, .rows = rows, .values = std::vector(std::size_t{columns} * rows, kOpen)});
    };
    addLevel();
    while (columns > 1 || rows > 1) {
        columns = halved(columns);
        rows = halved(rows);
        addLevel();
    }
}

void DepthTiles::makeLevels() {
    for (std::size_t level = 1; level < m_levels.size(); ++level) {
        const Level& finer = m_levels[level - 1];
        Level& coarser = m_levels[level];
        for (std::uint32_t row = 0; row < coarser.rows; ++row) {
            for (std::uint32_t column = 0; column < coarser.columns; ++column) {
                const std::uint32_t right = std::min(2 * column + 1, finer.columns - 1);
                const std::uint32_t below = std::min(2 * row + 1, finer.rows - 1);
                const auto at = [&](std::uint32_t x, std::uint32_t y) {
                    return finer.values[std::size_t{y} * finer.columns + x];
                };
                coarser.values[std::size_t{row} * coarser.columns + column] = std::max(
                    {at(2 * column, 2 * row), at(right, 2 * row), at(2 * column, below), at(right, below)});
            }
        }
    }
}

bool DepthTiles::hides(const PixelRect& rect, double nearestView) const {
    if (rect.right <= 0.0 || rect.bottom <= 0.0 || rect.left >= m_width || rect.top >= m_height) {
        return true;
    }
    const auto tileOf = [](double pixel, double end) {
        // Written so that what is not a number is the far end, which makes the range larger and not smaller.
        const double inside = pixel < end ? std::max(pixel, 0.0) : end - 1.0;
        return static_cast<std::uint32_t>(inside) / kSide;
    };
    const TileRange tiles{.left = rect.left > 0.0 ? tileOf(rect.left, m_width) : 0,
                          .top = rect.top > 0.0 ? tileOf(rect.top, m_height) : 0,
                          .right = tileOf(rect.right, m_width),
                          .bottom = tileOf(rect.bottom, m_height)};
    return hides(m_levels.size() - 1, {}, tiles, nearestView);
}

/// @param range of squares of the level that meet the tiles.
bool DepthTiles::hides(std::size_t level, const TileRange& range, const TileRange& tiles,
                       double nearestView) const {
    const Level& here = m_levels[level];
    for (std::uint32_t row = range.top; row <= range.bottom; ++row) {
        for (std::uint32_t column = range.left; column <= range.right; ++column) {
            if (nearestView > here.values[std::size_t{row} * here.columns + column]) {
                continue;
            }
            if (level == 0) {
                return false;
            }
            const std::size_t finer = level - 1;
            const TileRange children{.left = std::max(2 * column, tiles.left >> finer),
                                     .top = std::max(2 * row, tiles.top >> finer),
                                     .right = std::min(2 * column + 1, tiles.right >> finer),
                                     .bottom = std::min(2 * row + 1, tiles.bottom >> finer)};
            if (!hides(finer, children, tiles, nearestView)) {
                return false;
            }
        }
    }
    return true;
}

} // namespace cdr::visibility
