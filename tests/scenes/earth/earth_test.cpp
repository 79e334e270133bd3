#include "../../support/synthetic_earth.h"

#include <cdr/scene/world/check.h>
#include <scenes/earth/earth.h>
#include <scenes/earth/ground_blocks.h>
#include <scenes/orbit/airport.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace cdr::scenes::test {

namespace {

class EarthScene : public testing::Test {
  protected:
    EarthMaps m_maps = cdr::test::syntheticEarth();
    scene::SceneSetup m_earth = makeEarth(m_maps, nullptr, {.blockTexels = 32});
    scene::SceneSetup m_orbit = makeOrbit(cdr::test::syntheticEarth());
};

TEST_F(EarthScene, IsTheOrbitButForGroundAndAir) {
    const scene::Scene& earth = m_earth.scene;
    const scene::Scene& orbit = m_orbit.scene;
    scene::requireUsable(earth);
    EXPECT_EQ(earth.objectNames, orbit.objectNames);
    EXPECT_EQ(earth.instances.x, orbit.instances.x);
    EXPECT_EQ(earth.instances.y, orbit.instances.y);
    EXPECT_EQ(earth.instances.z, orbit.instances.z);
    EXPECT_EQ(earth.instances.object, orbit.instances.object);
    ASSERT_EQ(earth.meshes.size(), orbit.meshes.size());
    for (std::size_t i = 0; i < earth.meshes.size(); ++i) {
        ASSERT_EQ(earth.meshes[i].indices, orbit.meshes[i].indices);
    }
    EXPECT_EQ(m_earth.path.frames, m_orbit.path.frames);
    EXPECT_EQ(m_earth.path.at(100).position, m_orbit.path.at(100).position);
    EXPECT_FALSE(orbit.air);
}

/// A machine may have more processors.
TEST_F(EarthScene, IsPaintedByAsManyThreadsAsThereMayBe) {
    const scene::SceneSetup setup = makeEarth(m_maps, nullptr, {.blockTexels = 32, .threads = 1000});
    EXPECT_EQ(setup.scene.textures.size(), m_earth.scene.textures.size());
}

/// Gaps of a tenth of a metre are narrower than pixels, so a wall of another colour shows as broken lines.
TEST_F(EarthScene, WallsBehindCladdingHaveItsColor) {
    const auto colorOf = [](const scene::Scene& scene, std::string_view name) {
        const auto found = std::ranges::find_if(
            scene.materials, [&](const scene::Material& material) { return material.name == name; });
        return found == scene.materials.end() ? glm::vec4(0.0f) : found->baseColorFactor;
    };
    EXPECT_GT(colorOf(m_earth.scene, kCladding).b, 0.5f);
    EXPECT_EQ(colorOf(m_earth.scene, kHangarWall), colorOf(m_earth.scene, kCladding));
    EXPECT_NE(colorOf(m_orbit.scene, kHangarWall), colorOf(m_orbit.scene, kCladding)) << "it is measured";
}

TEST_F(EarthScene, AModelKeepsMaterialsThatHaveTheAirportsNames) {
    scene::Scene model;
    model.meshes = {scene::makeBox(glm::vec3(1.0f))};
    const glm::vec4 paint(0.25f, 0.5f, 0.75f, 1.0f);
    for (const char* name : {kConcrete, kCladding, kHangarWall}) {
        model.materials.push_back({.name = name, .baseColorFactor = paint});
    }
    scene::addInstance(model, 0, 0, 0, glm::dvec3(0.0), glm::mat3(1.0f));
    const scene::SceneSetup setup = makeEarth(m_maps, &model, {.blockTexels = 32});
    const auto painted = std::ranges::count_if(setup.scene.materials, [&](const scene::Material& material) {
        return material.baseColorFactor == paint && !material.baseColorTexture;
    });
    EXPECT_EQ(painted, 3);
}

/// A texture begins and ends within its block, so no tile shows a smeared edge.
TEST_F(EarthScene, EachTileLiesOnItsTexture) {
    const scene::Scene& earth = m_earth.scene;
    EXPECT_EQ(earth.textures.size(), blocksAround(kOrbitAirport, 15).size() + 1) << "and concrete";
    std::vector<std::size_t> tiles(earth.textures.size());
    for (std::size_t i = 0; i < earth.instances.size(); ++i) {
        const auto& texture = earth.materials[earth.instances.material[i]].baseColorTexture;
        if (!texture) {
            continue;
        }
        ++tiles.at(*texture);
        for (const scene::Vertex& vertex : earth.meshes[earth.instances.mesh[i]].vertices) {
            ASSERT_GE(std::min(vertex.uv.x, vertex.uv.y), -1e-5f);
            ASSERT_LE(std::max(vertex.uv.x, vertex.uv.y), 1.0f + 1e-5f);
        }
    }
    for (const std::size_t count : tiles) {
        EXPECT_GT(count, 0u);
    }
}

/// The airport is where its air is thickest, and the Sun of the air is the light that shines.
TEST_F(EarthScene, TheAirLiesOnTheGround) {
    const scene::Air& air = m_earth.scene.air.value();
    const EarthSurface surface(m_maps.topography, kOrbitAirport, {.radius = 1e3});
    const auto heightOf = [&](const glm::dvec3& place) {
        const glm::dvec3 fromCentre = place - air.centre;
        const double along = glm::dot(air.axis, fromCentre);
        return glm::length(fromCentre + (1.0 / (1.0 - air.flattening) - 1.0) * along * air.axis) - air.radius;
    };
    for (const Geodetic& place :
         {kOrbitAirport, Geodetic{0.0, 40.0}, Geodetic{89.0, 0.0}, Geodetic{-60.0, -100.0}}) {
        EXPECT_NEAR(heightOf(surface.toWorld(place, 0.0)), 0.0, 0.01);
        EXPECT_NEAR(heightOf(surface.toWorld(place, 1e4)), 1e4, 50.0);
    }
    EXPECT_GT(glm::dot(air.toSun, glm::normalize(m_earth.scene.lights.at(0).position)), 1.0 - 1e-12);
}

} // namespace

} // namespace cdr::scenes::test
