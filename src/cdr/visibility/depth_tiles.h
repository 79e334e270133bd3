#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::visibility {

/// A part of a picture in pixels, from the top left; may reach beyond it.
struct PixelRect {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;
};

/// For each tile of pixels a view distance. All that is farther there is hidden by the picture's opaque surfaces. Squares
/// of tiles have the largest distance of their tiles, so that large objects need few tests.
class DepthTiles {
  public:
    static constexpr std::uint32_t kSide = 8; ///< of a tile, in pixels

    /// Of a picture in pixels. Nothing is hidden yet.
    DepthTiles(std::uint32_t width, std::uint32_t height);

    std::uint32_t columns() const { return m_levels.front().columns; }
    std::uint32_t rows() const { return m_levels.front().rows; }

    /// View distances by tile, row by row: what is farther is hidden in the whole tile. Infinity where nothing is. Call
    /// makeLevels() once they are written.
    std::span<double> hiddenBeyond() { return m_levels.front().values; }
    void makeLevels();

    /// Whether everything within `rect` that is no nearer than `nearestView` is hidden. What is outside the picture is.
    bool hides(const PixelRect& rect, double nearestView) const;

  private:
    /// Tiles in a range of columns and rows, the last ones included.
    struct TileRange {
        std::uint32_t left = 0;
        std::uint32_t top = 0;
        std::uint32_t right = 0;
        std::uint32_t bottom = 0;
    };
    struct Level {
        std::uint32_t columns = 1;
        std::uint32_t rows = 1;
        std::vector<double> values;
    };
    bool hides(std::size_t level, const TileRange& range, const TileRange& tiles, double nearestView) const;

    double m_width;
    double m_height;
    std::vector<Level> m_levels; ///< each of squares twice as wide as the last; the last is one square
};

} // namespace cdr::visibility
