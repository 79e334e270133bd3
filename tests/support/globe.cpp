#include "globe.h"

#include <cdr/base/error.h>
#include <scenes/scene_builder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace cdr::test {

namespace {

constexpr std::uint32_t kMaxCells = 1024;

/// Where the k-th of `cells` lines crosses an edge of the cube from -1 to 1, at even angles. It is exact at
/// the ends and odd about the middle, so that faces meet in the same vertices.
double lineAt(std::uint32_t k, std::uint32_t cells) {
    const double share = (2.0 * k - cells) / cells;
    return std::abs(share) == 1.0 ? share : std::tan(0.25 * std::numbers::pi * share);
}

/// One face of a cube about the origin, blown up to the globe.
void addFace(int axis, double side, double radius, std::uint32_t cells, scene::SourceMesh& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t j = 0; j <= cells; ++j) {
        for (std::uint32_t i = 0; i <= cells; ++i) {
            glm::dvec3 onCube(side);
            // Mirrored with the side, which keeps fronts outside.
            onCube[(axis + 1) % 3] = side * lineAt(i, cells);
            onCube[(axis + 2) % 3] = lineAt(j, cells);
            // The same sum for the same corner of every face, whatever the order of its axes.
            std::array<double, 3> squares{onCube.x * onCube.x, onCube.y * onCube.y, onCube.z * onCube.z};
            std::sort(squares.begin(), squares.end());
            const glm::dvec3 normal = onCube / std::sqrt(squares[0] + squares[1] + squares[2]);
            mesh.positions.push_back(radius * normal);
            mesh.vertices.push_back({.normal = glm::vec3(normal)});
        }
    }
    for (std::uint32_t j = 0; j < cells; ++j) {
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = first + j * (cells + 1) + i;
            const std::uint32_t c = a + cells + 1;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, c + 1, a, c + 1, c});
        }
    }
}

} // namespace

scene::SourceMesh globeMesh(double radius, std::uint32_t cells) {
    if (cells < 1 || cells > kMaxCells) {
        throw base::InputError("a globe has 1 to " + std::to_string(kMaxCells) + " cells along an edge");
    }
    scene::SourceMesh mesh;
    mesh.name = "globe";
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            addFace(axis, side, radius, cells, mesh);
        }
    }
    return mesh;
}

scene::Scene makeGlobe(const GlobeOptions& options) {
    scene::Scene scene;
    scene.name = "globe";
    scene.materials.push_back({.name = "white", .baseColorFactor = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f)});
    scene.lights.push_back(scenes::farLight({0.6, 0.5, 0.6}, 1e3 * options.radius));
    const scene::PieceSet pieces =
        addPieces(scene, scene::cutIntoPieces(globeMesh(options.radius, options.cells), options.pieceRadius));
    glm::dmat4 toWorld(1.0);
    toWorld[3] = glm::dvec4(options.centre, 1.0);
    placePieces(scene, pieces, 0, 0, toWorld);
    return scene;
}

} // namespace cdr::test
