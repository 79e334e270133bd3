#pragma once

#include <cdr/measure/truth/screen_bounds.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::measure {

/// The picture cut into square tiles, and for each the rectangles that touch it.
class TileBins {
  public:
    /// @param rects within width x height, each by its index in the tiles' lists, which keep their order.
    TileBins(std::uint32_t width, std::uint32_t height, std::span<const PixelRect> rects);

    std::size_t tiles() const { return m_begins.size() - 1; }
    /// The tile's pixels; tiles at the right and bottom may be smaller.
    PixelRect pixels(std::size_t tile) const;
    /// Indices of the rectangles that touch the tile, ascending.
    std::span<const std::uint32_t> members(std::size_t tile) const {
        return std::span(m_members).subspan(m_begins[tile], m_begins[tile + 1] - m_begins[tile]);
    }

    static constexpr std::uint32_t kSide = 16; ///< pixels

  private:
    template <typename Visitor>
    void visitTiles(const PixelRect& rect, const Visitor& visit) const;

    std::uint32_t m_width;
    std::uint32_t m_height;
    std::uint32_t m_columns;
    std::vector<std::size_t> m_begins; ///< per tile its first member, and the end of the last
    std::vector<std::uint32_t> m_members;
};

} // namespace cdr::measure
