#pragma once

#include <scenes/orbit/earth_tiles.h>

#include <vector>

namespace cdr::scenes {

/// A part of the Earth that one texture shows: so many tiles of a level in each direction.
struct GroundBlock {
    EarthTile first{}; ///< in its north-western corner
    std::uint32_t columns = 2;
    std::uint32_t rows = 1;

    /// Whether a tile lies in it as a whole.
    bool covers(const EarthTile& tile) const;
    GeodeticFrame frame() const;
};

/// The whole Earth, and blocks of 4 x 4 tiles around a place, the last of 2 x 2. Each block is half as wide as the last one.
/// @param finest level of the tiles of the last block.
std::vector<GroundBlock> blocksAround(const Geodetic& place, std::uint32_t finest);

} // namespace cdr::scenes
