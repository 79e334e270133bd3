#include <cdr/base/error.h>
#include <scenes/city.h>
#include <scenes/open_scene.h>
#include <scenes/terrain.h>

#include <gtest/gtest.h>

namespace cdr::scenes {

namespace {

TEST(City, HoldsAMillionBoxes) {
    const scene::SceneSetup setup = openScene("city", 2013).setup;
    EXPECT_EQ(setup.scene.instances.size(), 1'000'000u);
    EXPECT_EQ(setup.scene.objectCount(), 1'000'000u);
    EXPECT_EQ(setup.scene.meshes.size(), 1u);
}

TEST(City, LeavesItsStreetsToTheCamera) {
    const scene::SceneSetup setup = makeCity(3, 4);
    const scene::Instances& boxes = setup.scene.instances;
    for (std::uint32_t frame = 0; frame < setup.path.frames; ++frame) {
        const glm::dvec3 eye = setup.path.at(frame).position;
        ASSERT_DOUBLE_EQ(eye.y, 1.7);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const glm::dvec3 away = glm::abs(eye - boxes.position(i));
            const bool isInside = away.x < 0.5 * static_cast<double>(boxes.basis[i][0][0]) + 0.3 &&
                                  away.y < 0.5 * static_cast<double>(boxes.basis[i][1][1]) &&
                                  away.z < 0.5 * static_cast<double>(boxes.basis[i][2][2]) + 0.3;
            ASSERT_FALSE(isInside) << "frame " << frame << " is in box " << i;
        }
    }
}

TEST(GeneratedPath, RepeatsAfterItsLastFrame) {
    for (const scene::SceneSetup& setup : {makeCity(3, 2), makeTerrain(3, 16)}) {
        for (const std::uint32_t frame : {0u, 7u}) {
            const scene::Camera first = setup.path.at(frame);
            EXPECT_EQ(setup.path.at(setup.path.frames + frame), first) << setup.scene.name;
            EXPECT_EQ(setup.path.at(100 * setup.path.frames + frame), first) << setup.scene.name;
        }
    }
}

TEST(City, RefusesABlockAloneAndTooMany) {
    EXPECT_THROW(makeCity(1, 3), base::InputError);
    EXPECT_THROW(makeCity(1, 200), base::InputError);
    EXPECT_EQ(makeCity(1, 2).scene.instances.size(), 2500u);
}

} // namespace

} // namespace cdr::scenes
