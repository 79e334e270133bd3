#include "fixture.h"

#include <cdr/platform/worker_pool.h>
#include <cdr/scene/animation/scene_animation.h>
#include <cdr/scene/gltf/open_gltf.h>

#include <cmath>

namespace cdr::scene::test {
namespace {

constexpr const char* kPunctual = "KHR_lights_punctual";

class GltfMovingLights : public GltfFolder {
  protected:
    /// A square, a point light that stays, and a spot on an arm that moves along x and turns by a quarter about y.
    static Document lamps() {
        Document document = square();
        document.root["extensions"][kPunctual]["lights"] = {{{"type", "point"}, {"name", "still"}},
                                                            {{"type", "spot"}, {"range", 50.0}}};
        document.root["nodes"].push_back({{"extensions", {{kPunctual, {{"light", 0}}}}}});
        document.root["nodes"].push_back({{"children", {3}}});
        document.root["nodes"].push_back(
            {{"translation", {0, 0, 3}}, {"extensions", {{kPunctual, {{"light", 1}}}}}});
        document.root["scenes"][0]["nodes"] = {0, 1, 2};
        document.root["extensionsUsed"] = {kPunctual};
        const auto half = static_cast<float>(std::sqrt(0.5));
        const int times = document.addAccessor(std::vector<float>{0, 2}, "SCALAR", kFloat);
        const int places = document.addAccessor(std::vector<float>{0, 0, 0, 10, 0, 0}, "VEC3", kFloat);
        const int turns =
            document.addAccessor(std::vector<float>{0, 0, 0, 1, 0, half, 0, half}, "VEC4", kFloat);
        document.root["animations"] = {
            {{"samplers", {{{"input", times}, {"output", places}}, {{"input", times}, {"output", turns}}}},
             {"channels",
              {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}},
               {{"sampler", 1}, {"target", {{"node", 2}, {"path", "rotation"}}}}}}}};
        return document;
    }

    static GltfChoice at(double seconds, std::optional<double> framesPerSecond = {}) {
        GltfChoice choice;
        choice.light = ModelLight::file;
        choice.seconds = seconds;
        choice.framesPerSecond = framesPerSecond;
        return choice;
    }

    std::filesystem::path path(const Document& document) const { return write("a.glb", document.glb()); }
};

TEST_F(GltfMovingLights, FollowTheirNodes) {
    const std::filesystem::path file = path(lamps());
    for (const double seconds : {0.0, 0.5, 1.0, 2.0}) {
        const std::vector<PointLight> lights = openGltf(file, at(seconds)).setup.scene.lights;
        ASSERT_EQ(lights.size(), 2u);
        EXPECT_EQ(lights[0].position, glm::dvec3(0.0));
        const double angle = seconds * std::acos(0.0) / 2.0;
        const glm::dvec3 back(std::sin(angle), 0.0, std::cos(angle));
        EXPECT_NEAR(glm::distance(lights[1].position, glm::dvec3(5.0 * seconds, 0.0, 0.0) + 3.0 * back), 0.0,
                    1e-6);
        EXPECT_NEAR(glm::distance(lights[1].cone->direction, -back), 0.0, 1e-6);
        EXPECT_EQ(lights[1].range, 50.0);
    }
}

TEST_F(GltfMovingLights, MoveWithTheFrames) {
    const std::filesystem::path file = path(lamps());
    const OpenedScene opened = openGltf(file, at(0.5, 4.0));
    const SceneMotion& motion = opened.setup.motion;
    EXPECT_TRUE(motion);
    EXPECT_EQ(motion.lights, (std::vector<std::uint32_t>{1}));
    EXPECT_FALSE(opened.lights[0].moves);
    EXPECT_TRUE(opened.lights[1].moves);
    platform::WorkerPool workers(1);
    for (const std::uint32_t frame : {0u, 1u, 3u}) {
        Scene scene = opened.setup.scene;
        show(scene, motion, frame, workers);
        const PointLight wanted = openGltf(file, at(0.5 + frame / 4.0)).setup.scene.lights[1];
        EXPECT_EQ(scene.lights[1].position, wanted.position);
        EXPECT_EQ(scene.lights[1].cone->direction, wanted.cone->direction);
        EXPECT_EQ(scene.lights[1].color, wanted.color);
        EXPECT_EQ(scene.lights[1].halfDistance, wanted.halfDistance);
    }
    GltfChoice lamps = at(0.0, 4.0);
    lamps.light = {};
    EXPECT_TRUE(openGltf(file, lamps).setup.motion.lights.empty()); // the lamps about the model stay
}

TEST_F(GltfMovingLights, StayAtRestWhereAFrameFlattensThem) {
    Document document = lamps();
    const int times = document.addAccessor(std::vector<float>{0, 2}, "SCALAR", kFloat);
    const int sizes = document.addAccessor(std::vector<float>{1, 1, 1, 0, 0, 0}, "VEC3", kFloat);
    document.root["animations"][0]["samplers"].push_back({{"input", times}, {"output", sizes}});
    document.root["animations"][0]["channels"].push_back(
        {{"sampler", 2}, {"target", {{"node", 2}, {"path", "scale"}}}});
    const std::vector<PointLight> lights = openGltf(path(document), at(2.0)).setup.scene.lights;
    EXPECT_EQ(lights[1].position, glm::dvec3(0.0, 0.0, 3.0));
    EXPECT_EQ(lights[1].cone->direction, glm::dvec3(0.0, 0.0, -1.0));
}

} // namespace
} // namespace cdr::scene::test
