#include <scenes/orbit/earth_tiles.h>
#include <scenes/solids.h>

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace cdr::scenes {

namespace {

/// How deep a skirt hangs, as a share of its tile's width: far more than float32 rounds, less than a pixel.
constexpr double kSkirtShare = 1.0 / 512.0;

/// A corner by column and row, counted along the edges of the whole tile.
struct Corner {
    std::uint32_t column;
    std::uint32_t row;
};

std::uint32_t indexOf(const Corner& corner) {
    return corner.row * (kTileCells + 1) + corner.column;
}

/// Moves corners on an edge to the nearest that a coarser neighbour has, too.
class Stitching {
  public:
    Stitching(const EarthQuadtree& tree, const EarthTile& leaf)
        : m_north(step(tree, leaf, TileEdge::north)),
          m_south(step(tree, leaf, TileEdge::south)),
          m_west(step(tree, leaf, TileEdge::west)),
          m_east(step(tree, leaf, TileEdge::east)) {}

    Corner stitched(Corner corner) const {
        const Corner given = corner;
        if (given.row == 0 || given.row == kTileCells) {
            corner.column = nearest(given.column, given.row == 0 ? m_north : m_south);
        }
        if (given.column == 0 || given.column == kTileCells) {
            corner.row = nearest(given.row, given.column == 0 ? m_west : m_east);
        }
        return corner;
    }

  private:
    static std::uint32_t step(const EarthQuadtree& tree, const EarthTile& leaf, TileEdge edge) {
        // A neighbour of which this tile spans less than one square leaves the ends alone.
        return std::min(1u << tree.coarserBeyond(leaf, edge), kTileCells);
    }
    static std::uint32_t nearest(std::uint32_t at, std::uint32_t step) {
        return (at + step / 2) / step * step;
    }

    std::uint32_t m_north;
    std::uint32_t m_south;
    std::uint32_t m_west;
    std::uint32_t m_east;
};

void addGround(const Stitching& stitching, scene::SourceMesh& mesh) {
    for (std::uint32_t row = 0; row < kTileCells; ++row) {
        for (std::uint32_t column = 0; column < kTileCells; ++column) {
            const auto index = [&](std::uint32_t right, std::uint32_t down) {
                return indexOf(stitching.stitched({column + right, row + down}));
            };
            const std::uint32_t northWest = index(0, 0);
            const std::uint32_t northEast = index(1, 0);
            const std::uint32_t southWest = index(0, 1);
            const std::uint32_t southEast = index(1, 1);
            addTriangle(mesh, northWest, southWest, southEast);
            addTriangle(mesh, northWest, southEast, northEast);
        }
    }
}

/// Walks round the tile, the ground on the left, so that the skirt's fronts look outwards.
std::vector<Corner> outline() {
    std::vector<Corner> corners;
    for (std::uint32_t i = 0; i < kTileCells; ++i) {
        corners.push_back({0, i});
    }
    for (std::uint32_t i = 0; i < kTileCells; ++i) {
        corners.push_back({i, kTileCells});
    }
    for (std::uint32_t i = kTileCells; i > 0; --i) {
        corners.push_back({kTileCells, i});
    }
    for (std::uint32_t i = kTileCells; i > 0; --i) {
        corners.push_back({i, 0});
    }
    return corners;
}

void addSkirt(const Stitching& stitching, double depth, scene::SourceMesh& mesh) {
    const std::vector<Corner> corners = outline();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto count = static_cast<std::uint32_t>(corners.size());
    std::vector<std::uint32_t> above;
    for (const Corner& corner : corners) {
        above.push_back(indexOf(stitching.stitched(corner)));
        const scene::Vertex vertex = mesh.vertices[above.back()];
        mesh.positions.push_back(mesh.positions[above.back()] - depth * glm::dvec3(vertex.normal));
        mesh.vertices.push_back(vertex);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = (i + 1) % count;
        addTriangle(mesh, above[i], first + i, first + next);
        addTriangle(mesh, above[i], first + next, above[next]);
    }
}

} // namespace

double widthOf(const EarthTile& tile) {
    return std::numbers::pi * kEarthRadius / static_cast<double>(1u << tile.level);
}

Geodetic cornerOf(const EarthTile& tile, std::uint32_t column, std::uint32_t row) {
    // Integers first, so that tiles of any level find the same number for the same place.
    const std::uint32_t finest = EarthQuadtree::kDeepest - tile.level;
    const auto along = [finest](std::uint32_t index, std::uint32_t cells) {
        return static_cast<double>((index * kTileCells + cells) << finest);
    };
    constexpr double kDegrees = 180.0 / (kTileCells << EarthQuadtree::kDeepest);
    return {90.0 - along(tile.y, row) * kDegrees, along(tile.x, column) * kDegrees - 180.0};
}

EarthQuadtree refineEarth(const EarthSurface& surface, const TileDetail& detail) {
    return EarthQuadtree([&](const EarthTile& tile) {
        const double width = widthOf(tile);
        if (tile.level < 2) {
            return true; // a sphere needs corners before it has distances
        }
        const auto at = [&](std::uint32_t column, std::uint32_t row) {
            return surface.at(cornerOf(tile, column, row));
        };
        const glm::dvec3 middle = at(kTileCells / 2, kTileCells / 2);
        double radius = 0.0;
        for (const auto& corner :
             {at(0, 0), at(kTileCells, 0), at(0, kTileCells), at(kTileCells, kTileCells)}) {
            radius = std::max(radius, glm::distance(middle, corner));
        }
        const auto distanceTo = [&](const glm::dvec3& point) {
            return std::max(glm::distance(middle, point) - radius, 0.0);
        };
        return width > detail.eyeShare * distanceTo(detail.eye) ||
               width > std::max(detail.leastWidth, detail.placeShare * distanceTo(detail.place));
    });
}

scene::SourceMesh tileMesh(const EarthSurface& surface, const EarthQuadtree& tree, const EarthTile& leaf,
                           const GeodeticFrame& frame) {
    scene::SourceMesh mesh;
    mesh.name = fmt::format("earth {}/{}/{}", leaf.level, leaf.x, leaf.y);
    for (std::uint32_t row = 0; row <= kTileCells; ++row) {
        for (std::uint32_t column = 0; column <= kTileCells; ++column) {
            const Geodetic place = cornerOf(leaf, column, row);
            mesh.positions.push_back(surface.at(place));
            mesh.vertices.push_back({.normal = glm::vec3(surface.normalAt(place)),
                                     .uv = glm::vec2((place.longitude - frame.west) / frame.width,
                                                     (frame.north - place.latitude) / frame.height)});
        }
    }
    const Stitching stitching(tree, leaf);
    addGround(stitching, mesh);
    addSkirt(stitching, kSkirtShare * widthOf(leaf), mesh);
    return mesh;
}

} // namespace cdr::scenes
