#pragma once

#include <cdr/scene/lod/mesh_pieces.h>
#include <scenes/orbit/earth_quadtree.h>
#include <scenes/orbit/earth_surface.h>

#include <glm/glm.hpp>

#include <cstdint>

namespace cdr::scenes {

/// Squares along an edge of a tile.
inline constexpr std::uint32_t kTileCells = 16;

/// Where the ground is cut finely. Tiles above a least width are no wider than a share of their distance to the
/// eye. Nor are they wider than another share of their distance to a place on the ground.
struct TileDetail {
    glm::dvec3 eye{0.0};   ///< world space
    double eyeShare = 0.3; ///< so that a square of a tile is a fiftieth of its distance
    glm::dvec3 place{0.0}; ///< world space
    double placeShare = 0.6;
    double leastWidth = 1'000.0; ///< metres, at the place
};

/// The tree of tiles that a detail asks for.
EarthQuadtree refineEarth(const EarthSurface& surface, const TileDetail& detail);

/// A rectangle of latitude and longitude, degrees: by default the whole Earth.
struct GeodeticFrame {
    double west = -180.0;
    double north = 90.0;
    double width = 360.0;
    double height = 180.0;
};

/// The mesh of a leaf: world space, float64, (0, 0) to (1, 1) of its texture coordinates the frame.
///
/// No cracks: corners of tiles of one level are the same places, computed from the same integers. Along a
/// coarser neighbour a tile has no corners but the neighbour's. What the renderer's float32 origins round
/// differently, a hair's breadth, is closed by a skirt that hangs from every edge.
scene::SourceMesh tileMesh(const EarthSurface& surface, const EarthQuadtree& tree, const EarthTile& leaf,
                           const GeodeticFrame& frame = {});

/// Corners of tileMesh() that are on the ground; those of the skirt follow.
inline constexpr std::uint32_t kTileCorners = (kTileCells + 1) * (kTileCells + 1);

/// The place of a corner of a tile, `column` and `row` from its north-west, 0 to kTileCells.
Geodetic cornerOf(const EarthTile& tile, std::uint32_t column, std::uint32_t row);

/// From north to south along the tile, metres.
double widthOf(const EarthTile& tile);

} // namespace cdr::scenes
