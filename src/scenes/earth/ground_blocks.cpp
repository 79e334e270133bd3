#include <scenes/earth/ground_blocks.h>

#include <algorithm>
#include <cmath>

namespace cdr::scenes {

namespace {

constexpr std::uint32_t kAcross = 4;
constexpr std::uint32_t kCoarsest = 3; ///< level of the widest block's tiles: it reaches beyond the horizon

/// The first of the tiles around the corner that is nearest to a place.
std::uint32_t firstAround(double position, std::uint32_t count, std::uint32_t across) {
    const double first =
        std::clamp(std::round(position) - 0.5 * across, 0.0, static_cast<double>(count - across));
    return static_cast<std::uint32_t>(first);
}

GroundBlock blockAround(const Geodetic& place, std::uint32_t level, std::uint32_t across) {
    const std::uint32_t rows = 1u << level;
    const double perDegree = rows / 180.0;
    return {.first = {level, firstAround((place.longitude + 180.0) * perDegree, 2 * rows, across),
                      firstAround((90.0 - place.latitude) * perDegree, rows, across)},
            .columns = across,
            .rows = across};
}

} // namespace

bool GroundBlock::covers(const EarthTile& tile) const {
    if (tile.level < first.level) {
        return false;
    }
    const std::uint32_t x = tile.x >> (tile.level - first.level);
    const std::uint32_t y = tile.y >> (tile.level - first.level);
    return x >= first.x && x < first.x + columns && y >= first.y && y < first.y + rows;
}

GeodeticFrame GroundBlock::frame() const {
    const double degrees = 180.0 / static_cast<double>(1u << first.level);
    return {.west = first.x * degrees - 180.0,
            .north = 90.0 - first.y * degrees,
            .width = columns * degrees,
            .height = rows * degrees};
}

std::vector<GroundBlock> blocksAround(const Geodetic& place, std::uint32_t finest) {
    std::vector<GroundBlock> blocks{GroundBlock{}};
    for (std::uint32_t level = kCoarsest; level <= finest; ++level) {
        blocks.push_back(blockAround(place, level, kAcross));
    }
    blocks.push_back(blockAround(place, finest, kAcross / 2)); // no tiles are smaller, so it has fewer
    return blocks;
}

} // namespace cdr::scenes
