#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <vector>

namespace cdr::scenes {

/// A square of latitude and longitude. Level 0 has two of them, each 180 degrees a side, west and east;
/// every level quarters.
struct EarthTile {
    std::uint32_t level = 0;
    std::uint32_t x = 0; ///< from 180 degrees west, below 2^(level + 1)
    std::uint32_t y = 0; ///< from the north pole, below 2^level

    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a 0
    auto operator<=>(const EarthTile&) const = default;
};

enum class TileEdge : std::uint8_t { north, south, west, east };

/// Tiles that cover the Earth once.
class EarthQuadtree {
  public:
    static constexpr std::uint32_t kDeepest = 16; ///< 300 m

    /// Quarters every tile that `isTooLarge` down to kDeepest.
    explicit EarthQuadtree(const std::function<bool(const EarthTile&)>& isTooLarge);

    /// In the order of their place in the tree, so the same for the same question.
    const std::vector<EarthTile>& leaves() const { return m_leaves; }

    /// Levels by which the leaf beyond an edge of a leaf is coarser. 0 where it is as fine or finer, or there
    /// is none, as beyond a pole.
    std::uint32_t coarserBeyond(const EarthTile& leaf, TileEdge edge) const;

  private:
    std::vector<EarthTile> m_leaves;
    std::set<EarthTile> m_known;
};

} // namespace cdr::scenes
