#include <cdr/base/error.h>
#include <scenes/mixed.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace cdr::scenes {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::uint32_t kMostCells = 1024;

/// So far away that it shines alike on everything.
scene::PointLight farLight(const glm::dvec3& direction, double distance) {
    return {.position = distance * direction, .color = glm::vec3(1.0f), .halfDistance = 10.0 * distance};
}

/// Turned about y, then about x.
glm::dmat3 turnedBy(double yaw, double pitch) {
    const glm::dmat3 aboutY(std::cos(yaw), 0.0, -std::sin(yaw), 0.0, 1.0, 0.0, std::sin(yaw), 0.0,
                            std::cos(yaw));
    const glm::dmat3 aboutX(1.0, 0.0, 0.0, 0.0, std::cos(pitch), std::sin(pitch), 0.0, -std::sin(pitch),
                            std::cos(pitch));
    return aboutX * aboutY;
}

/// Where the k-th of `cells` lines crosses an edge of the cube from -1 to 1: at even angles, and exactly at
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

scene::StagedScene makeMixed() {
    constexpr double kSide = 0.018;
    constexpr double kSpacing = 0.027;
    const double kBehind = std::numbers::sqrt3; // puts corner-on faces one below
    scene::StagedScene staged;
    scene::Scene& scene = staged.scene;
    scene.name = "mixed";
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    scene.materials.push_back({.name = "white", .baseColorFactor = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f)});
    scene.materials.push_back({.name = "twin", .baseColorFactor = glm::vec4(0.7f, 0.05f, 0.05f, 1.0f)});
    scene.lights.push_back(farLight({0.3, 0.5, 0.8}, 1e12));
    for (std::uint32_t pair = 0; pair < kMixedPairs; ++pair) {
        const std::uint32_t cell = pair / kMixedPairsPerCell;
        const std::uint32_t column = cell / kMixedShares.size();
        const std::uint32_t row = cell % kMixedShares.size();
        const std::uint32_t place = pair % kMixedPairsPerCell;
        const double w = kMixedDistances[column];
        const double x = 0.14 * (column - 1.5) + kSpacing * (place % 3 - 1.0);
        const double y = 0.082 - 0.164 * row + kSpacing * (1.0 - std::floor(place / 3));
        const glm::dvec3 centre = w * glm::dvec3(x, y, -1.0);
        // A corner towards the eye, a little aside: on faces seen from the edge, x and y would decide.
        const scene::Camera facing = scene::lookAt({}, glm::dvec3(0.0), centre);
        const glm::dmat3 turned = glm::dmat3(facing.right, facing.up, facing.back) *
                                  turnedBy((41.0 + place) * kDegree, 35.0 * kDegree);
        const glm::mat3 basis(turned * (kSide * w));
        scene::addInstance(scene, 0, 0, 2 * pair, centre, basis);
        scene::addInstance(scene, 0, 1, 2 * pair + 1, centre * (1.0 + kBehind * kMixedShares[row]), basis);
    }
    staged.path = scene::stillPath({.fovY = 20.0 * kDegree, .nearView = 0.1, .farView = 2e8});
    return staged;
}

scene::SourceMesh globeMesh(double radius, std::uint32_t cells) {
    if (cells < 1 || cells > kMostCells) {
        throw base::InputError("a globe has 1 to " + std::to_string(kMostCells) + " cells along an edge");
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
    scene.lights.push_back(farLight({0.6, 0.5, 0.6}, 1e3 * options.radius));
    const scene::PieceSet pieces =
        addPieces(scene, scene::cutIntoPieces(globeMesh(options.radius, options.cells), options.pieceRadius));
    glm::dmat4 toWorld(1.0);
    toWorld[3] = glm::dvec4(options.centre, 1.0);
    placePieces(scene, pieces, 0, 0, toWorld);
    return scene;
}

} // namespace cdr::scenes
