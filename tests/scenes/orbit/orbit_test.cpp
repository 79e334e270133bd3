#include "../../support/synthetic_earth.h"

#include <cdr/base/error.h>
#include <scenes/orbit/airport.h>
#include <scenes/orbit/orbit.h>
#include <scenes/orbit/runway_marking.h>
#include <scenes/solids.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

namespace cdr::scenes::test {

using namespace scene;
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

double volumeOf(const SourceMesh& mesh) {
    double volume = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        volume += glm::dot(mesh.positions[mesh.indices[i]], glm::cross(mesh.positions[mesh.indices[i + 1]],
                                                                       mesh.positions[mesh.indices[i + 2]]));
    }
    return volume / 6.0;
}

TEST(Solids, AreClosedAndFaceOutwards) {
    EXPECT_NEAR(volumeOf(sphereMesh("ball", 2.0, 256)), 4.0 / 3.0 * std::numbers::pi * 8.0, 0.01);
    const std::array<glm::dvec2, 4> rod{{{-1.0, 0.0}, {-1.0, 0.5}, {1.0, 0.5}, {1.0, 0.0}}};
    EXPECT_NEAR(volumeOf(turnedSolid("rod", rod, 256)), 0.5 * std::numbers::pi, 1e-3);
    const std::array<glm::dvec3, 8> box{
        {{0, 0, 0}, {2, 0, 0}, {2, 0, -3}, {0, 0, -3}, {0, 1, 0}, {2, 1, 0}, {2, 1, -3}, {0, 1, -3}}};
    EXPECT_DOUBLE_EQ(volumeOf(hexahedron("box", box)), 6.0);
}

TEST(RunwayMarking, FacesUpAndFillsItsHeight) {
    MarkingPaint paint("09L");
    paint.text("0927RL", 9.0);
    const SourceMesh& mesh = paint.mesh();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        const glm::dvec3 normal =
            glm::cross(mesh.positions[mesh.indices[i + 1]] - a, mesh.positions[mesh.indices[i + 2]] - a);
        EXPECT_GT(normal.y, 0.0);
        EXPECT_EQ(a.y, 0.0);
    }
    const auto ahead = std::minmax_element(mesh.positions.begin(), mesh.positions.end(),
                                           [](const auto& a, const auto& b) { return a.x < b.x; });
    EXPECT_NEAR(ahead.first->x, -4.5, 0.3);
    EXPECT_NEAR(ahead.second->x, 4.5, 0.3);
    EXPECT_THROW(paint.text("Q", 1.0), base::InputError);
}

double areaOf(const SourceMesh& mesh) {
    double area = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        area += 0.5 * glm::length(glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                                             mesh.positions[mesh.indices[i + 2]] - a));
    }
    return area;
}

TEST(RunwayMarking, StrokesAreAsWideAtTheirBendsAsBetweenThem) {
    // Mitred, a closed stroke covers its width times its length, whatever its angles.
    const std::array<glm::dvec2, 5> ring{{{0.0, 0.0}, {4.0, 0.0}, {5.0, 2.0}, {2.0, 5.0}, {0.0, 3.0}}};
    double length = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        length += glm::distance(ring[i], ring[(i + 1) % ring.size()]);
    }
    MarkingPaint paint("ring");
    paint.stroke(ring, 0.25, MarkingPaint::Ends::joined);
    EXPECT_NEAR(areaOf(paint.mesh()), 0.25 * length, 1e-12);
}

class OrbitScene : public testing::Test {
  protected:
    static const SceneSetup& setup() {
        static const SceneSetup scene = makeOrbit(cdr::test::syntheticEarth());
        return scene;
    }
    /// The highest point, world y, of what an object draws.
    static double topOf(std::string_view name) {
        const Scene& scene = setup().scene;
        double top = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < scene.instances.size(); ++i) {
            if (scene.objectNames[scene.instances.object[i]] == name) {
                for (const Vertex& vertex : scene.meshes[scene.instances.mesh[i]].vertices) {
                    const glm::dvec3 corner =
                        glm::dmat3(scene.instances.basis[i]) * glm::dvec3(vertex.position);
                    top = std::max(top, scene.instances.y[i] + corner.y);
                }
            }
        }
        return top;
    }
};

TEST_F(OrbitScene, SeparationsAreThoseOfTheSpecification) {
    EXPECT_NEAR(topOf("runway 09L/27R"), 0.02, 1e-9);
    EXPECT_NEAR(topOf("numbers 09L") - topOf("runway 09L/27R"), 0.005, 1e-9);
    EXPECT_NEAR(topOf("numbers 27R") - topOf("runway 09L/27R"), 0.005, 1e-9);
    EXPECT_NEAR(topOf("runway markings"), 0.025, 1e-9);
    EXPECT_NEAR(topOf("hangar 2 cladding") - topOf("hangar 2"), 0.01, 1e-8);
}

TEST_F(OrbitScene, GroundBelowTheAirportIsLevel) {
    const Scene& scene = setup().scene;
    const EarthSurface::Pad pad = airportPad();
    std::size_t level = 0;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const glm::dvec3 origin = scene.instances.position(i);
        const bool onPad = glm::distance(glm::dvec2(origin.x, origin.z), pad.centre) +
                               static_cast<double>(scene.instances.radius[i]) <
                           pad.radius;
        if (scene.objectNames[scene.instances.object[i]] != "earth" || !onPad) {
            continue;
        }
        for (const Vertex& vertex : scene.meshes[scene.instances.mesh[i]].vertices) {
            const double y = origin.y + static_cast<double>(vertex.position.y);
            EXPECT_LE(y, 1e-7); // a float32 of the way to the middle of tile and skirt
            level += std::abs(y) < 1e-7 ? 1 : 0;
        }
    }
    EXPECT_GT(level, 5u * kTileCorners); // skirts hang below
}

TEST_F(OrbitScene, TheAirportLiesOnItsPad) {
    const Scene& scene = setup().scene;
    const EarthSurface::Pad pad = airportPad();
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const glm::dvec3 p = scene.instances.position(i);
        if (glm::length(p) < 20e3 && scene.objectNames[scene.instances.object[i]] != "earth") {
            EXPECT_LT(glm::distance(glm::dvec2(p.x, p.z), pad.centre) +
                          static_cast<double>(scene.instances.radius[i]),
                      pad.radius)
                << scene.objectNames[scene.instances.object[i]];
        }
    }
}

TEST_F(OrbitScene, HoldsWhatIsPromisedAtItsSize) {
    const Scene& scene = setup().scene;
    for (const char* name : {"window frame", "handrail", "solar panel", "earth", "moon", "runway 09L/27R",
                             "hangar 1", "aircraft"}) {
        EXPECT_NE(std::ranges::find(scene.objectNames, name), scene.objectNames.end()) << name;
    }
    EXPECT_EQ(scene.objectCount(), scene.objectNames.size());
    const glm::dvec3 eye = setup().path.at(0).position;
    const EarthMaps maps = cdr::test::syntheticEarth();
    const EarthSurface surface(maps.topography, kOrbitAirport, airportPad());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const std::string& name = scene.objectNames[scene.instances.object[i]];
        const glm::dvec3 p = scene.instances.position(i);
        if (name == "moon") {
            EXPECT_NEAR(glm::distance(p, surface.earthCentre()), 384.4e6, 1.0);
            EXPECT_NEAR(scene.instances.radius[i], 1'737.4e3, 200.0);
        } else if (name == "solar panel" || name == "truss") {
            EXPECT_LT(glm::distance(p, eye), 50.0);
            EXPECT_GT(glm::distance(p, eye), 10.0);
        }
    }
}

TEST_F(OrbitScene, Float64StepsAreFineAtBothEnds) {
    const glm::dvec3 eye = setup().path.at(0).position;
    for (const double coordinate : {eye.x, eye.y, eye.z}) {
        EXPECT_LE(std::nextafter(std::abs(coordinate), 1e30) - std::abs(coordinate), 1e-9);
    }
    EXPECT_NEAR(eye.y, 420e3, 2000.0); // the ground falls away below the line of sight
    EXPECT_NEAR(glm::length(eye), 430e3, 5e3);
}

TEST_F(OrbitScene, TheLensNarrowsByOneFactorAndEndsOnTheNumbers) {
    const CameraPath& path = setup().path;
    ASSERT_EQ(path.frames, 240u);
    const double factor = path.at(1).fovY / path.at(0).fovY;
    EXPECT_NEAR(path.at(0).fovY, 60.0 * kDegree, 1e-12);
    EXPECT_NEAR(path.at(239).fovY, 0.002 * kDegree, 1e-15);
    const glm::dvec3 target(0.0, 0.025, 0.0);
    for (std::uint32_t frame = 0; frame < path.frames; ++frame) {
        const Camera camera = path.at(frame);
        requireUsable(camera);
        if (frame > 0) {
            EXPECT_NEAR(camera.fovY / path.at(frame - 1).fovY, factor, 1e-9);
            // No jump: the aim moves by less than a tenth of the picture a frame.
            EXPECT_LT(glm::length(glm::cross(camera.back, path.at(frame - 1).back)), 0.1 * camera.fovY);
        }
        EXPECT_NEAR(glm::dot(camera.right, camera.back), 0.0, 1e-15);
        EXPECT_NEAR(glm::length(camera.up), 1.0, 1e-15);
        const glm::dvec3 seen = camera.toView(target);
        const double away = std::hypot(seen.x, seen.y) / -seen.z;
        if (camera.fovY < 20.0 * kDegree) {
            EXPECT_LT(away, std::tan(0.5 * camera.fovY)) << frame; // in the picture to stay
        }
        if (frame == 239) {
            EXPECT_LT(std::hypot(seen.x, seen.y), 1e-9);
        }
    }
    EXPECT_EQ(path.at(240).fovY, path.at(0).fovY);
}

TEST_F(OrbitScene, TheHorizonIsInTheFirstPicture) {
    const Camera camera = setup().path.at(0);
    const EarthMaps maps = cdr::test::syntheticEarth();
    const EarthSurface surface(maps.topography, kOrbitAirport, airportPad());
    const StationPose station = orbitStation(surface);
    const double dip = std::acos(kEarthRadius / (kEarthRadius + kStationHeight));
    const glm::dvec3 toHorizon = std::cos(dip) * station.forward - std::sin(dip) * station.up;
    const double angle = std::acos(glm::dot(toHorizon, -camera.back));
    EXPECT_LT(angle, 0.5 * camera.fovY);
    EXPECT_NEAR((kEarthRadius + kStationHeight) * std::sin(dip), 2.35e6, 0.05e6);
}

TEST(OrbitModel, IsParkedOnTheSlab) {
    Scene model;
    model.meshes.push_back(makeBox(glm::vec3(1.0f, 2.0f, 3.0f)));
    model.materials.push_back({.name = "red"});
    addInstance(model, 0, 0, 0, {0.0, 7.0, 0.0}, glm::mat3(2.0f));
    model.objectNames = {"crate"};
    const SceneSetup setup = makeOrbit(cdr::test::syntheticEarth(), &model);
    const Scene& scene = setup.scene;
    const auto name = std::find(scene.objectNames.begin(), scene.objectNames.end(), "model crate");
    ASSERT_NE(name, scene.objectNames.end());
    EXPECT_EQ(std::count(scene.objectNames.begin(), scene.objectNames.end(), "aircraft"), 0);
    const auto object = static_cast<std::uint32_t>(name - scene.objectNames.begin());
    const auto& objects = scene.instances.object;
    const auto i = static_cast<std::size_t>(std::ranges::find(objects, object) - objects.begin());
    ASSERT_LT(i, scene.instances.size());
    EXPECT_NEAR(scene.instances.y[i] - 4.0, kSlabHeight, 1e-9); // half its height below its middle
    EXPECT_EQ(scene.materials[scene.instances.material[i]].name, "red");
    EXPECT_EQ(scene.meshes[scene.instances.mesh[i]].boxHalfSides, glm::vec3(1.0f, 2.0f, 3.0f));
}

} // namespace
} // namespace cdr::scenes::test
