#include "../fixture.h"
#include "../steps.h"

#include <cdr/base/error.h>
#include <cdr/measure/truth/truth_shading.h>
#include <scenes/cubes.h>

#include <cstdlib>

namespace cdr::render_test {

namespace {

class TruthShadingTest : public RenderTest {};

/// Two programs that share no line light the same surfaces alike.
void expectAlike(const render::Frame& frame, const scene::Scene& scene, const scene::Camera& camera) {
    platform::WorkerPool workers(2);
    const measure::TruthCaster caster(scene, workers);
    const auto truth = caster.cast(camera, frame.width(), frame.height(), workers);
    const auto shaded = measure::shadeTruth(scene, caster, camera, truth, workers);
    const auto inner = measure::innerMask(truth);
    std::size_t alike = 0;
    std::size_t off = 0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const auto id = frame.gbuffer.pixels[i].idAndCascade & 0xffffffu;
        if (id == truth.pixels[i].id && (inner.pixels[i] != 0 || id == 0)) {
            // Where two faces of one box meet either may show.
            (largestStep(shaded.pixels[i], frame.color.pixels[i]) <= 2 ? alike : off)++;
        }
    }
    EXPECT_GT(alike, truth.pixels.size() / 2);
    EXPECT_LT(off * 200, alike);
}

TEST_F(TruthShadingTest, LooksAsTheRendererDoes) {
    const scene::SceneSetup setup = scenes::makeAfc(2013);
    const scene::Camera camera = setup.path.at(40);
    const auto frame = draw(setup.scene, camera, smallOptions(depth::parseTechnique("anchored")));
    expectAlike(frame, setup.scene, camera);
}

TEST_F(TruthShadingTest, ColorsLightsAndStretchedBoxesToo) {
    scene::Scene scene = boxScene();
    scene.background = glm::vec3(0.2f, 0.1f, 0.4f);
    scene.materials[0].baseColorFactor = glm::vec4(0.9f, 0.4f, 0.2f, 1.0f);
    scene.lights.push_back({.position = {-8.0, 3.0, 4.0}, .color = {0.2f, 0.5f, 1.0f}, .halfDistance = 9.0});
    addBox(scene, {0.0, 0.0, 0.0}, glm::mat3(3.0f, 0.5f, 0.0f, -0.4f, 1.5f, 0.2f, 0.0f, -0.3f, 2.0f));
    addBox(scene, {2.0, 2.0, -3.0}, glm::mat3(4.0f));
    const scene::Camera camera = scene::lookAt({.fovY = 0.9}, {1.0, 2.0, 6.0}, glm::dvec3(0.0));
    expectAlike(draw(scene, camera, smallOptions(depth::parseTechnique("standard"))), scene, camera);
}

/// Metals and dielectrics, smooth and rough, lit from so near that highlights lie on flat faces.
scene::Scene glossyScene(const glm::dvec3& centre) {
    scene::Scene scene = boxScene();
    scene.materials.clear();
    scene.ambient = glm::vec3(0.1f, 0.15f, 0.2f);
    scene.lights = {
        {.position = centre + glm::dvec3(0.4, 0.3, 2.6), .color = {0.9f, 0.8f, 0.7f}, .halfDistance = 4.0},
        {.position = centre + glm::dvec3(-2.0, -1.0, 1.2), .halfDistance = 2.0}};
    for (const float metallic : {0.0f, 0.25f, 1.0f}) {
        for (const float roughness : {0.0f, 0.3f, 0.5f, 1.0f}) {
            const auto i = static_cast<std::uint32_t>(scene.materials.size());
            // What the G-buffer keeps as it is; every other box is not shaded by facets.
            scene.materials.push_back(
                {.name = "shiny",
                 .baseColorFactor = glm::vec4(0.64f, 0.36f, 0.16f, 1.0f),
                 .metallicRoughness = scene::MetallicRoughness{.metallic = metallic, .roughness = roughness},
                 .doubleSided = i % 2 == 1});
            scene::addInstance(scene, 0, i, i, centre + glm::dvec3((i % 4) - 1.5, (i / 4) - 1.0, 0.1 * i),
                               glm::mat3(0.95f));
        }
    }
    return scene;
}

TEST_F(TruthShadingTest, ShinyBoxesToo) {
    const scene::Scene scene = glossyScene(glm::dvec3(0.0));
    // The last sees a light mirrored at a grazing angle.
    for (const glm::dvec3 eye :
         {glm::dvec3(0.5, 0.2, 6.0), glm::dvec3(-3.0, 2.0, 4.0), glm::dvec3(4.0, 2.0, 1.8)}) {
        const scene::Camera camera = scene::lookAt({.fovY = 0.7}, eye, glm::dvec3(0.0));
        expectAlike(draw(scene, camera, smallOptions(depth::parseTechnique("standard"))), scene, camera);
    }
}

TEST_F(TruthShadingTest, HighlightsAMillionUnitsAwayToo) {
    const glm::dvec3 centre(123'456.75, -7'654.5, 9'876.25);
    const scene::Scene scene = glossyScene(centre);
    const scene::Camera camera{
        .position = centre + glm::dvec3(0.0, 0.0, 1e6), .fovY = 3.2e-6, .nearView = 0.001, .farView = 2e6};
    expectAlike(draw(scene, camera, smallOptions(depth::parseTechnique("anchored"))), scene, camera);
}

TEST_F(TruthShadingTest, InterpolatedNormalsToo) {
    scene::Scene scene = boxScene();
    scene.meshes[0].boxHalfSides.reset();
    for (scene::Vertex& vertex : scene.meshes[0].vertices) {
        vertex.normal = glm::normalize(vertex.position);
    }
    addBox(scene, glm::dvec3(0.0), glm::mat3(3.0f));
    const scene::Camera camera = scene::lookAt({.fovY = 0.9}, {1.0, 2.0, 4.0}, glm::dvec3(0.0));
    expectAlike(draw(scene, camera, smallOptions(depth::parseTechnique("standard"))), scene, camera);
}

TEST(OrderByTruth, ReplacesOnlyWhatIsWrong) {
    image::ImageRgba8 picture(2, 1, {1, 1, 1, 255});
    const image::ImageRgba8 shaded(2, 1, {9, 9, 9, 255});
    image::ImageU32 ids(2, 1, 5);
    measure::TruthImage truth(2, 1, {.id = 5});
    EXPECT_EQ(measure::orderByTruth(picture, ids, truth, shaded), picture);
    ids.at(1, 0) = 6;
    image::ImageRgba8 expected = picture;
    expected.at(1, 0) = shaded.at(1, 0);
    EXPECT_EQ(measure::orderByTruth(picture, ids, truth, shaded), expected);
    EXPECT_THROW(measure::orderByTruth(picture, ids, truth, {1, 1}), base::InputError);
}

} // namespace

} // namespace cdr::render_test
