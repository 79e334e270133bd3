#include "../fixture.h"

#include <cdr/scene/lod/levels.h>
#include <scenes/boulders.h>

#include <map>
#include <set>
#include <utility>

namespace cdr::render_test {

namespace {

using render::RenderOptions;

/// Boulders near and far over a floor, in a light from the side. Some are behind the camera, and their shadows before it.
scene::SceneSetup bouldersOverFloor() {
    scene::SceneSetup setup = scenes::makeBoulders(2013, {.boulders = 40, .shapes = 2, .subdivisions = 4});
    scene::Scene& scene = setup.scene;
    for (scene::Mesh& mesh : scene.meshes) {
        mesh.indices.resize(mesh.indices.size() / 24 * 21); // open, so that all faces of each level are drawn
    }
    platform::WorkerPool workers(2);
    scene::makeLevels(scene, workers);
    const scene::Camera camera = setup.path.at(0);
    scene.lights = {{.position = camera.position + glm::dvec3(2e3, 3e3, 3e3), .halfDistance = 1e4}};
    for (const double ahead : {-30.0, -12.0, 25.0}) {
        scene::addInstance(scene, 0, 0, static_cast<std::uint32_t>(scene.instances.size()),
                           camera.position - ahead * camera.back + 2.0 * camera.up, glm::mat3(4.0f));
    }
    scene.meshes.push_back(scene::makeBox(glm::vec3(1.0f)));
    scene::addInstance(scene, static_cast<std::uint32_t>(scene.meshes.size()) - 1, 0,
                       static_cast<std::uint32_t>(scene.instances.size()),
                       camera.position - 6.0 * camera.up - 60.0 * camera.back,
                       glm::mat3(200, 0, 0, 0, 0.5f, 0, 0, 0, 200));
    return setup;
}

/// The same scene, in which each mesh is the level that an instance is drawn at.
scene::Scene withLevelsAsMeshes(const scene::Scene& scene, const scene::Camera& camera,
                                const visibility::LevelRule& rule) {
    scene::Scene made = scene;
    made.meshes.clear();
    std::map<std::pair<std::uint32_t, std::uint8_t>, std::uint32_t> places;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const std::uint32_t from = scene.instances.mesh[i];
        const std::uint8_t level = visibility::levelOf(scene, i, camera, rule);
        const auto [place, isNew] =
            places.emplace(std::pair(from, level), static_cast<std::uint32_t>(made.meshes.size()));
        if (isNew) {
            scene::Mesh mesh = scene.meshes[from];
            if (level > 0) {
                mesh.indices = mesh.levels[level - 1u].indices;
            }
            mesh.levels.clear();
            made.meshes.push_back(mesh);
        }
        made.instances.mesh[i] = place->second;
    }
    return made;
}

class DetailedShadowsTest : public RenderTest {};

/// A caster at another level than the surface would shade it. Submissions choose levels each in their own way.
TEST_F(DetailedShadowsTest, AreThoseOfTheLevelsThatAreDrawn) {
    const scene::SceneSetup setup = bouldersOverFloor();
    const scene::Camera camera = setup.path.at(0);
    RenderOptions options = smallOptions(depth::namedTechnique("anchored").technique);
    options.shadows.method = render::ShadowMethod::anchored;
    for (const double pixels : {1.0, 6.0}) {
        const visibility::Detail detail{.mode = visibility::DetailMode::perObject, .pixels = pixels};
        const visibility::LevelRule rule =
            visibility::levelRule(detail, scene::frustumOf(camera, options.width, options.height));
        std::set<std::uint8_t> levels;
        for (std::uint32_t i = 0; i < setup.scene.instances.size(); ++i) {
            levels.insert(visibility::levelOf(setup.scene, i, camera, rule));
        }
        EXPECT_GT(levels.size(), 2u);
        options.detail = {};
        const render::Frame wanted = draw(withLevelsAsMeshes(setup.scene, camera, rule), camera, options);
        const render::Frame full = draw(setup.scene, camera, options);
        options.detail = detail;
        for (const render::Submission submission : submissions()) {
            options.submission = submission;
            const render::Frame frame = draw(setup.scene, camera, options);
            EXPECT_EQ(frame.litMask, wanted.litMask) << pixels << " " << nameOf(submission);
            EXPECT_EQ(hashOf(frame), hashOf(wanted)) << pixels << " " << nameOf(submission);
            EXPECT_NE(frame.litMask, full.litMask) << pixels;
        }
        options.submission = {};
    }
}

} // namespace

} // namespace cdr::render_test
