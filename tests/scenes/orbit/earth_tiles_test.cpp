#include "../../support/synthetic_earth.h"

#include <scenes/orbit/earth_tiles.h>
#include <scenes/orbit/orbit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cdr::scenes::test {

using namespace scene;
namespace {

/// The tiles of the scene orbit over a synthetic Earth.
class EarthTiles : public testing::Test {
  protected:
    static constexpr EarthSurface::Pad kPad{.centre = {1000.0, 0.0}, .radius = 2600.0};

    EarthMaps m_maps = cdr::test::syntheticEarth();
    EarthSurface m_surface{m_maps.topography, kOrbitAirport, kPad};
    TileDetail m_detail = orbitDetail(orbitStation(m_surface));
    EarthQuadtree m_tree = refineEarth(m_surface, m_detail);
};

TEST_F(EarthTiles, CoverTheEarthOnce) {
    double area = 0.0;
    for (const EarthTile& leaf : m_tree.leaves()) {
        area += std::pow(0.25, leaf.level);
    }
    EXPECT_EQ(area, 2.0);
    EXPECT_GT(m_tree.leaves().size(), 200u);
    EXPECT_LT(m_tree.leaves().size(), 2000u);
}

/// Every edge of the ground, by the exact float64 positions of its ends, belongs to two triangles. So there is no
/// crack, no T-junction, and no hole at a pole or at 180 degrees.
TEST_F(EarthTiles, ShareEveryEdgeExactly) {
    using Edge = std::array<double, 6>;
    std::vector<Edge> edges;
    std::size_t stitched = 0;
    for (const EarthTile& leaf : m_tree.leaves()) {
        for (const TileEdge edge : {TileEdge::north, TileEdge::south, TileEdge::west, TileEdge::east}) {
            stitched += m_tree.coarserBeyond(leaf, edge) > 0 ? 1 : 0;
        }
        const SourceMesh mesh = tileMesh(m_surface, m_tree, leaf);
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const std::array triangle{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
            if (*std::max_element(triangle.begin(), triangle.end()) >= kTileCorners) {
                continue; // of the skirt
            }
            for (std::size_t side = 0; side < 3; ++side) {
                glm::dvec3 a = mesh.positions[triangle[side]];
                glm::dvec3 b = mesh.positions[triangle[(side + 1) % 3]];
                if (std::array{b.x, b.y, b.z} < std::array{a.x, a.y, a.z}) {
                    std::swap(a, b);
                }
                edges.push_back({a.x, a.y, a.z, b.x, b.y, b.z});
            }
        }
    }
    EXPECT_GT(stitched, 50u);
    std::sort(edges.begin(), edges.end());
    std::size_t alone = 0;
    for (auto first = edges.begin(); first != edges.end();) {
        const auto end = std::find_if(first, edges.end(), [&](const Edge& edge) { return edge != *first; });
        alone += end - first != 2 ? 1 : 0;
        first = end;
    }
    EXPECT_EQ(alone, 0u) << "of " << edges.size() / 2;
}

TEST_F(EarthTiles, AreSmallForTheirDistance) {
    double finest = 1e9;
    for (const EarthTile& leaf : m_tree.leaves()) {
        double nearest = 1e12;
        for (std::uint32_t row = 0; row <= kTileCells; ++row) {
            for (std::uint32_t column = 0; column <= kTileCells; ++column) {
                const glm::dvec3 corner = m_surface.at(cornerOf(leaf, column, row));
                nearest = std::min(nearest, glm::distance(corner, m_detail.eye));
            }
        }
        EXPECT_LE(widthOf(leaf), m_detail.eyeShare * nearest + 1.0) << leaf.level;
        finest = std::min(finest, widthOf(leaf));
    }
    EXPECT_LE(finest, m_detail.leastWidth);
    EXPECT_GE(finest, 0.5 * m_detail.leastWidth);
}

TEST_F(EarthTiles, FaceOutwardsAndHangTheirSkirtsInwards) {
    const SourceMesh mesh = tileMesh(m_surface, m_tree, m_tree.leaves().at(m_tree.leaves().size() / 2));
    const glm::dvec3 centre = m_surface.earthCentre();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
        const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
        if (std::max({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]}) < kTileCorners) {
            EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a - centre), 0.0);
        } else {
            // A skirt's front looks away from the middle of its tile.
            const glm::dvec3 middle = mesh.positions[kTileCorners / 2];
            EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a - middle), 0.0);
        }
    }
    ASSERT_GT(mesh.positions.size(), kTileCorners);
    EXPECT_LT(glm::distance(mesh.positions[kTileCorners], centre), glm::distance(mesh.positions[0], centre));
}

TEST(EarthQuadtree, KnowsCoarserNeighboursRoundTheBackAndNoneBeyondPoles) {
    // One tile of the west quartered twice, the rest of level 0.
    const EarthQuadtree tree([](const EarthTile& tile) {
        return tile == EarthTile{0, 0, 0} || tile == EarthTile{1, 0, 0};
    });
    EXPECT_EQ(tree.leaves().size(), 8u);
    EXPECT_EQ(tree.coarserBeyond({2, 0, 0}, TileEdge::west), 2u); // the east's only tile
    EXPECT_EQ(tree.coarserBeyond({2, 0, 0}, TileEdge::north), 0u);
    EXPECT_EQ(tree.coarserBeyond({2, 1, 0}, TileEdge::east), 1u);
    EXPECT_EQ(tree.coarserBeyond({2, 0, 0}, TileEdge::east), 0u);
    EXPECT_EQ(tree.coarserBeyond({1, 1, 0}, TileEdge::west), 0u); // finer
    const EarthQuadtree east([](const EarthTile& tile) { return tile == EarthTile{0, 1, 0}; });
    EXPECT_EQ(east.coarserBeyond({1, 3, 0}, TileEdge::east), 1u); // the west's only tile, over 180 degrees
}

} // namespace
} // namespace cdr::scenes::test
