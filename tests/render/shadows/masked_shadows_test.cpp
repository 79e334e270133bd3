#include "../fixture.h"

#include <cdr/measure/shadows/wrong_shadows.h>
#include <cdr/measure/truth/layered_truth.h>
#include <cdr/scene/world/world.h>
#include <scenes/sheets.h>

namespace cdr::render_test {

namespace {

using render::RenderOptions;

constexpr std::uint32_t kMasked = 1; // material
constexpr std::uint32_t kSquare = 1; // mesh

/// A floor 2 below the camera, a screen over it with 32 holes, and a light above both. The screen's sides are 6 wide.
scene::Scene screenOverFloor(float alpha, std::uint8_t vertexAlpha, float cutoff) {
    scene::Scene scene = boxScene();
    scene.meshes.push_back(scenes::makeSquare(1.0f));
    for (scene::Vertex& vertex : scene.meshes[kSquare].vertices) {
        vertex.color[3] = vertexAlpha;
    }
    scene::Texture holes{.name = "holes", .pixels = image::ImageRgba8(8, 8, {255, 255, 255, 255})};
    for (std::uint32_t i = 0; i < 64; ++i) {
        holes.pixels.at(i % 8, i / 8)[3] = (i + i / 8) % 2 == 0 ? 255 : 0;
    }
    scene.textures.push_back(holes);
    scene.materials.push_back({.name = "screen",
                               .baseColorFactor = glm::vec4(1.0f, 1.0f, 1.0f, alpha),
                               .baseColorTexture = 0,
                               .doubleSided = true,
                               .alphaMode = scene::AlphaMode::mask,
                               .alphaCutoff = cutoff});
    scene.lights.front() = {.position = {1.0, 60.0, -9.0}, .halfDistance = 100.0};
    addBox(scene, {0.0, -2.0, -10.0}, glm::mat3(20, 0, 0, 0, 0.1f, 0, 0, 0, 20));
    scene::addInstance(scene, kSquare, kMasked, 1, {0.0, 1.0, -10.0}, glm::mat3(3, 0, 0, 0, 0, -3, 0, 3, 0));
    return scene;
}

scene::Camera cameraOverFloor() {
    return scene::lookAlong({.fovY = 1.0, .farView = 1e3}, {0.0, 4.0, 0.0}, {0.0, -0.5, -1.0});
}

RenderOptions optionsOf(const char* technique) {
    RenderOptions options = smallOptions(depth::namedTechnique(technique).technique);
    options.shadows.method = render::ShadowMethod::anchored;
    return options;
}

class MaskedShadowsTest : public RenderTest {
  protected:
    measure::WrongShadows wrongShadowsOf(const scene::Scene& scene, const RenderOptions& options) {
        const scene::Camera camera = cameraOverFloor();
        platform::WorkerPool workers(2);
        const measure::TruthCaster shapes(scene, workers);
        const measure::ShadowTruthCaster caster(scene, shapes.shapes());
        return measure::countWrongShadows({draw(scene, camera, options).litMask, 0},
                                          caster.cast(camera, options.width, options.height, 0, workers));
    }
};

/// Beside the screen is one with other holes, of the same mesh.
TEST_F(MaskedShadowsTest, HolesLetLightThroughForEveryMapping) {
    scene::Scene scene = screenOverFloor(1.0f, 255, 0.5f);
    scene::Texture half{.name = "half", .pixels = image::ImageRgba8(2, 1, {255, 255, 255, 255})};
    half.pixels.at(1, 0)[3] = 0;
    scene.textures.push_back(half);
    scene.materials.push_back(scene.materials[kMasked]);
    scene.materials.back().baseColorTexture = 1;
    scene::addInstance(scene, kSquare, 2, 2, {4.5, 1.0, -10.0}, glm::mat3(1, 0, 0, 0, 0, -3, 0, 1, 0));
    for (const char* technique : {"standard", "anchored", "logcdr"}) {
        const measure::WrongShadows wrong = wrongShadowsOf(scene, optionsOf(technique));
        EXPECT_GT(wrong.shadowed, 1'500u) << technique;
        EXPECT_LE(wrong.wrong, wrong.pixels / 10'000) << technique << ", of " << wrong.pixels;
    }
    const std::uint64_t behindScreen = wrongShadowsOf(scene, optionsOf("anchored")).shadowed;
    scene.materials[kMasked].alphaMode = scene::AlphaMode::opaque;
    EXPECT_GT(wrongShadowsOf(scene, optionsOf("anchored")).shadowed, 2 * behindScreen);
}

/// What is compared with the cutoff is the product of the factor, a vertex' alpha and the texture's. And a box has no tree of
/// triangles for the truth.
TEST_F(MaskedShadowsTest, FactorsAndVerticesCount) {
    const RenderOptions options = optionsOf("anchored");
    struct Case {
        float alpha;
        std::uint8_t vertexAlpha;
        float cutoff;
        bool castsShadow;
    };
    for (const Case& each :
         {Case{0.5f, 255, 0.25f, true}, Case{0.5f, 255, 0.75f, false}, Case{1.0f, 102, 0.25f, true},
          Case{1.0f, 102, 0.75f, false}, Case{0.0f, 255, 0.25f, false}, Case{0.0f, 255, 0.0f, true}}) {
        scene::Scene scene = screenOverFloor(each.alpha, each.vertexAlpha, each.cutoff);
        const measure::WrongShadows wrong = wrongShadowsOf(scene, options);
        EXPECT_EQ(wrong.shadowed > 100, each.castsShadow) << each.alpha << " " << each.cutoff;
        EXPECT_LE(wrong.wrong, wrong.pixels / 10'000) << each.alpha << " " << each.cutoff;
        scene.instances.mesh[1] = 0; // a flat box
        scene::placeInstance(scene, 1, {0.0, 1.0, -10.0}, glm::mat3(6, 0, 0, 0, 0.1f, 0, 0, 0, 6));
        EXPECT_LE(wrongShadowsOf(scene, options).wrong, 1u) << each.alpha << " " << each.cutoff;
    }
}

TEST_F(MaskedShadowsTest, FollowAMaterialThatChanges) {
    const scene::Camera camera = cameraOverFloor();
    const RenderOptions options = optionsOf("anchored");
    scene::World world(screenOverFloor(0.5f, 255, 0.25f));
    SoleRenderer renderer(device(), world, options);
    const auto expectAsAnew = [&](const char* what) {
        const render::Frame frame = renderer.render(camera);
        EXPECT_EQ(frame.litMask, draw(world.scene(), camera, options).litMask) << what;
        return frame.litMask;
    };
    const image::ImageRgba8 first = expectAsAnew("first");
    scene::Material material = world.scene().materials[kMasked];
    material.alphaCutoff = 0.75f;
    world.setMaterial(world.material(kMasked), material);
    EXPECT_NE(expectAsAnew("nothing is kept"), first);
    material.alphaMode = scene::AlphaMode::opaque;
    world.setMaterial(world.material(kMasked), material);
    EXPECT_NE(expectAsAnew("opaque"), first);
    material.alphaMode = scene::AlphaMode::mask;
    material.alphaCutoff = 0.25f;
    world.setMaterial(world.material(kMasked), material);
    EXPECT_EQ(expectAsAnew("as it was"), first);
}

/// A pane under the screen, so that the maps of translucent surfaces count.
TEST_F(MaskedShadowsTest, HolesLetLightOnTranslucentSurfaces) {
    scene::Scene scene = screenOverFloor(1.0f, 255, 0.5f);
    scene.materials.push_back({.name = "pane",
                               .baseColorFactor = glm::vec4(0.5f, 0.7f, 0.9f, 0.5f),
                               .doubleSided = true,
                               .alphaMode = scene::AlphaMode::blend});
    scene::addInstance(scene, kSquare, 2, 2, {0.0, -1.0, -10.0}, glm::mat3(8, 0, 0, 0, 0, -8, 0, 8, 0));
    RenderOptions options = optionsOf("anchored");
    options.translucency.countsFragments = true;
    const scene::Camera camera = cameraOverFloor();
    platform::WorkerPool workers(2);
    const auto differs = [&](const scene::Scene& drawn) {
        const render::Frame frame = draw(drawn, camera, options);
        return measure::compareLayers(frame.color, frame.fragmentCounts,
                                      measure::castLayers(scene, camera, options.width, options.height,
                                                          workers, measure::Lights::castShadows));
    };
    const measure::LayerDifference difference = differs(scene);
    EXPECT_GT(difference.translucent, 20'000u);
    EXPECT_GE(difference.withinFraction(), 0.98); // edges of holes have texels
    scene::Scene solid = scene;
    solid.materials[kMasked].alphaCutoff = 0.0f;
    EXPECT_LT(differs(solid).withinFraction(), 0.95);
}

} // namespace

} // namespace cdr::render_test
