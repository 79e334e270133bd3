#include <scenes/orbit/earth_quadtree.h>

namespace cdr::scenes {

EarthQuadtree::EarthQuadtree(const std::function<bool(const EarthTile&)>& isTooLarge) {
    std::vector<EarthTile> open{{0, 1, 0}, {0, 0, 0}};
    while (!open.empty()) {
        const EarthTile tile = open.back();
        open.pop_back();
        if (tile.level < kDeepest && isTooLarge(tile)) {
            for (const std::uint32_t quarter : {3u, 2u, 1u, 0u}) {
                open.push_back({tile.level + 1, 2 * tile.x + quarter % 2, 2 * tile.y + quarter / 2});
            }
        } else {
            m_leaves.push_back(tile);
        }
    }
    m_known.insert(m_leaves.begin(), m_leaves.end());
}

std::uint32_t EarthQuadtree::coarserBeyond(const EarthTile& leaf, TileEdge edge) const {
    const std::uint32_t columns = 2u << leaf.level;
    const std::uint32_t rows = 1u << leaf.level;
    EarthTile beyond = leaf;
    switch (edge) {
    case TileEdge::north:
    case TileEdge::south:
        if (leaf.y == (edge == TileEdge::north ? 0 : rows - 1)) {
            return 0;
        }
        beyond.y += edge == TileEdge::north ? -1u : 1u;
        break;
    case TileEdge::west:
        beyond.x = (leaf.x + columns - 1) % columns;
        break;
    case TileEdge::east:
        beyond.x = (leaf.x + 1) % columns;
        break;
    }
    for (std::uint32_t coarser = 0; coarser <= leaf.level; ++coarser) {
        if (m_known.contains({leaf.level - coarser, beyond.x >> coarser, beyond.y >> coarser})) {
            return coarser;
        }
    }
    return 0; // finer leaves lie there
}

} // namespace cdr::scenes
