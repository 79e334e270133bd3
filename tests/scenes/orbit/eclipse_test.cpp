#include "../../support/synthetic_earth.h"

#include <scenes/orbit/airport.h>
#include <scenes/orbit/eclipse.h>

#include <gtest/gtest.h>

namespace cdr::scenes::test {

namespace {

class EclipseScene : public testing::Test {
  protected:
    /// How far a place is from the line between the Sun and the middle of the Moon.
    double besideShadow(const glm::dvec3& place) const {
        const glm::dvec3 sun = m_setup.scene.lights.at(0).position;
        const glm::dvec3 way = glm::normalize(moon() - sun);
        return glm::length(glm::cross(place - sun, way));
    }
    glm::dvec3 moon() const {
        const scene::Scene& scene = m_setup.scene;
        for (std::size_t i = 0; i < scene.instances.size(); ++i) {
            if (scene.objectNames[scene.instances.object[i]] == "moon") {
                return scene.instances.position(i);
            }
        }
        ADD_FAILURE() << "no moon";
        return glm::dvec3(0.0);
    }

    EarthMaps m_maps = cdr::test::syntheticEarth();
    EarthSurface m_surface{m_maps.topography, kOrbitAirport, airportPad()};
    scene::SceneSetup m_setup = makeEclipse(cdr::test::syntheticEarth());
};

TEST_F(EclipseScene, TheMoonShadesTheEarthButNeitherStationNorAirport) {
    const StationPose station = orbitStation(m_surface);
    EXPECT_GT(besideShadow(station.eye), 1.2 * kMoonRadius);
    EXPECT_GT(besideShadow(glm::dvec3(0.0)), 1.2 * kMoonRadius);
    const double besideEarth = besideShadow(m_surface.earthCentre());
    EXPECT_LT(besideEarth, 6.3e6) << "the middle of the disc lies on the Earth";
    EXPECT_NEAR(glm::distance(moon(), m_surface.earthCentre()), kMoonDistance, 7e6);
}

TEST_F(EclipseScene, ItIsTheOrbitButForMoonLampAndPath) {
    const scene::SceneSetup orbit = makeOrbit(cdr::test::syntheticEarth());
    ASSERT_EQ(m_setup.scene.instances.size(), orbit.scene.instances.size());
    EXPECT_EQ(m_setup.scene.lights.size(), 1u);
    EXPECT_EQ(m_setup.scene.lights[0].position, orbit.scene.lights[0].position);
    for (std::size_t i = 0; i < orbit.scene.instances.size(); ++i) {
        if (orbit.scene.objectNames[orbit.scene.instances.object[i]] != "moon") {
            ASSERT_EQ(m_setup.scene.instances.position(i), orbit.scene.instances.position(i));
        }
    }
}

TEST_F(EclipseScene, EachStopLooksAtItsShadow) {
    ASSERT_EQ(m_setup.path.frames, 4 * kEclipseStopFrames);
    const auto at = [&](std::uint32_t stop) { return m_setup.path.at(stop * kEclipseStopFrames); };
    const StationPose station = orbitStation(m_surface);
    EXPECT_LT(glm::distance(at(0).position, station.eye), 0.5) << "bolts";
    EXPECT_EQ(at(1).position, station.eye);
    EXPECT_GT(-glm::dot(at(1).back, glm::normalize(glm::dvec3(180.0, 9.0, -300.0) - station.eye)),
              1.0 - 1e-12)
        << "hangars";
    EXPECT_LT(glm::distance(at(2).position, station.eye), 100.0);
    EXPECT_NEAR(glm::distance(at(3).position, m_surface.earthCentre()), 60e6, 1.0);
    for (std::uint32_t frame = 0; frame < m_setup.path.frames; ++frame) {
        scene::requireUsable(m_setup.path.at(frame));
    }
    EXPECT_NE(m_setup.path.at(1).position, m_setup.path.at(0).position) << "cameras move";
}

} // namespace

} // namespace cdr::scenes::test
