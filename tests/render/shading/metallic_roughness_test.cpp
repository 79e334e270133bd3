#include "../fixture.h"
#include "../steps.h"

#include <cdr/measure/truth/layered_truth.h>
#include <cdr/render/materials/material_words.h>
#include <scenes/sheets.h>

#include <algorithm>

namespace cdr::render_test {

namespace {

using render::Frame;
using scene::MetallicRoughness;

/// The byte of the G-buffer that has a pixel's metallic and roughness.
std::uint32_t codeAt(const Frame& frame, std::uint32_t x, std::uint32_t y) {
    return frame.gbuffer.at(x, y).albedo >> 24;
}

/// Square roots are of 8 bits, so that the G-buffer keeps it as it is.
const glm::vec4 kCopper(0.64f, 0.36f, 0.16f, 1.0f);

const scene::Camera kMetallicRoughnessCamera =
    scene::lookAt({.fovY = 0.6, .nearView = 0.1, .farView = 1000.0}, {0.0, 0.0, 8.0}, glm::dvec3(0.0));

/// A slab that fills the picture, its face towards the camera, lit from beside the camera.
scene::Scene slabScene(const std::optional<MetallicRoughness>& metallicRoughness) {
    scene::Scene scene = boxScene();
    scene.materials[0].baseColorFactor = kCopper;
    scene.materials[0].metallicRoughness = metallicRoughness;
    scene.ambient = glm::vec3(0.1f);
    scene.lights = {{.position = {0.5, 0.25, 4.0}, .halfDistance = 5.0}};
    addBox(scene, glm::dvec3(0.0), glm::mat3(6.0f));
    return scene;
}

class MetallicRoughnessTest : public RenderTest {
  protected:
    Frame drawSlab(const std::optional<MetallicRoughness>& metallicRoughness) {
        return draw(slabScene(metallicRoughness), kMetallicRoughnessCamera,
                    smallOptions(depth::parseTechnique("reversed")));
    }
};

/// The brightest pixel: the highlight.
image::Rgba8 brightest(const Frame& frame) {
    return *std::ranges::max_element(frame.color.pixels, [](const image::Rgba8& a, const image::Rgba8& b) {
        return int{a[0]} + a[1] + a[2] < int{b[0]} + b[1] + b[2];
    });
}

TEST_F(MetallicRoughnessTest, MetalsMirrorInTheirColorAndDielectricsInTheLights) {
    const image::Rgba8 matt = brightest(drawSlab({}));
    scene::Scene dim = slabScene(MetallicRoughness{.metallic = 1.0f, .roughness = 0.6f});
    dim.lights[0].color = glm::vec3(0.25f); // so that no channel is cut off
    const image::Rgba8 metal =
        brightest(draw(dim, kMetallicRoughnessCamera, smallOptions(depth::parseTechnique("reversed"))));
    const image::Rgba8 dielectric =
        brightest(drawSlab(MetallicRoughness{.metallic = 0.0f, .roughness = 0.3f}));
    // Blue is a quarter of red, 0.52 of it in sRGB.
    EXPECT_NEAR(metal[2], 0.52 * metal[0], 0.04 * metal[0]);
    EXPECT_GT(dielectric[2], matt[2] + 60);
    EXPECT_GT(dielectric[0], matt[0] + 20);
}

TEST_F(MetallicRoughnessTest, RoughnessSpreadsTheHighlight) {
    const auto bright = [&](float roughness) {
        const Frame frame = drawSlab(MetallicRoughness{.metallic = 1.0f, .roughness = roughness});
        return std::count_if(frame.color.pixels.begin(), frame.color.pixels.end(),
                             [](const image::Rgba8& pixel) { return pixel[0] > 200; });
    };
    const std::ptrdiff_t sharp = bright(0.1f);
    const std::ptrdiff_t soft = bright(0.3f);
    EXPECT_GT(sharp, 4);
    EXPECT_GT(soft, 4 * sharp);
}

/// Metals mirror their surroundings too, of which ambient light is all there is.
TEST_F(MetallicRoughnessTest, MetalsInAmbientLightAreNotBlack) {
    for (const float roughness : {0.0f, 0.5f, 1.0f}) {
        scene::Scene scene = slabScene(MetallicRoughness{.metallic = 1.0f, .roughness = roughness});
        scene.lights.clear();
        const Frame frame =
            draw(scene, kMetallicRoughnessCamera, smallOptions(depth::parseTechnique("reversed")));
        EXPECT_GT(frame.color.at(240, 135)[0], 40) << roughness;
    }
}

/// Whatever brings a material to the G-buffer, facets shaded per vertex among it, brings its metallic and roughness.
TEST_F(MetallicRoughnessTest, EverySurfaceHoldsItsCode) {
    scene::Scene scene = slabScene(MetallicRoughness{.metallic = 1.0f, .roughness = 0.3f});
    scene.instances = {};
    scene.textures.push_back({.name = "white", .pixels = image::ImageRgba8(1, 1, {255, 255, 255, 255})});
    scene.materials.push_back({.name = "both sides",
                               .metallicRoughness = MetallicRoughness{.metallic = 0.25f, .roughness = 0.5f},
                               .doubleSided = true});
    scene.materials.push_back(
        {.name = "textured", .baseColorTexture = 0, .metallicRoughness = MetallicRoughness{}});
    scene.materials.push_back({.name = "masked",
                               .baseColorTexture = 0,
                               .metallicRoughness = MetallicRoughness{.metallic = 0.0f, .roughness = 0.7f},
                               .alphaMode = scene::AlphaMode::mask});
    scene.materials.push_back({.name = "matt"});
    scene.materials.push_back({.name = "unlit", .metallicRoughness = MetallicRoughness{}, .unlit = true});
    const auto materials = static_cast<std::uint32_t>(scene.materials.size());
    for (std::uint32_t i = 0; i < materials; ++i) {
        scene::addInstance(scene, 0, i, i, {0.8 * (i - 2.5), 0.0, 0.0}, glm::mat3(0.7f));
    }
    const render::GpuScene gpuScene(device(), scene);
    for (const render::Submission submission : submissions()) {
        for (const render::Batching batching : render::kBatchings) {
            if (submission == render::Submission::gpuDriven && batching != render::Batching::instanced) {
                continue;
            }
            for (const char* technique : {"standard", "log-fragment/none"}) {
                render::RenderOptions options = smallOptions(depth::parseTechnique(technique), 240, 135);
                options.submission = submission;
                options.batching = batching;
                const Frame frame = draw(scene, gpuScene, kMetallicRoughnessCamera, options);
                std::vector<std::size_t> pixels(materials);
                for (std::uint32_t y = 0; y < frame.height(); ++y) {
                    for (std::uint32_t x = 0; x < frame.width(); ++x) {
                        if (const std::uint32_t id = frame.id(x, y); id != 0) {
                            const scene::Material& material = scene.materials[id - 1];
                            ASSERT_EQ(codeAt(frame, x, y), material.unlit ? 0
                                                                          : render::metallicRoughnessCode(
                                                                                material.metallicRoughness))
                                << material.name << " " << nameOf(submission) << " " << nameOf(batching);
                            ++pixels[id - 1];
                        }
                    }
                }
                EXPECT_GT(*std::min_element(pixels.begin(), pixels.end()), 100u);
            }
        }
    }
}

/// The byte is one, and occlusion per cascade was asked for: so all is matt, and the frame says so.
TEST_F(MetallicRoughnessTest, OcclusionPerLayerLeavesAllMattAndSaysSo) {
    scene::Scene metallicRoughness = slabScene(MetallicRoughness{.metallic = 1.0f, .roughness = 0.3f});
    addBox(metallicRoughness, {1.0, 0.0, 3.1});
    scene::Scene matt = metallicRoughness;
    matt.materials[0].metallicRoughness.reset();
    render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"));
    options.targets = render::TargetsKind::accumulate;
    options.effects.occlusion = {.radius = 0.5, .perLayer = true};
    const Frame frame = draw(metallicRoughness, kMetallicRoughnessCamera, options);
    EXPECT_TRUE(frame.stats.lostMetallicRoughness);
    const Frame wanted = draw(matt, kMetallicRoughnessCamera, options);
    EXPECT_EQ(hashOf(frame), hashOf(wanted));
    EXPECT_FALSE(wanted.stats.lostMetallicRoughness);
    // Over the whole picture both go together.
    options.effects.occlusion.perLayer = false;
    const Frame whole = draw(metallicRoughness, kMetallicRoughnessCamera, options);
    EXPECT_FALSE(whole.stats.lostMetallicRoughness);
    EXPECT_NE(hashOf(whole), hashOf(draw(matt, kMetallicRoughnessCamera, options)));
    EXPECT_NE(codeAt(whole, 240, 135), 0u);
}

/// Layers lit one by one look as a whole picture does.
TEST_F(MetallicRoughnessTest, LayersOfALensHaveItToo) {
    const scene::Scene scene = slabScene(MetallicRoughness{.metallic = 1.0f, .roughness = 0.4f});
    render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"));
    options.targets = render::TargetsKind::layers;
    const Frame plain = draw(scene, kMetallicRoughnessCamera, options);
    options.focus = {.distance = 5.0, .aperture = 1e-6};
    const Frame layered = draw(scene, kMetallicRoughnessCamera, options);
    EXPECT_LE(largestStep(plain.color, layered.color), 1); // half floats
    EXPECT_NE(hashOf(plain), hashOf(drawSlab({})));
}

/// Translucent sheets, metals and dielectrics, are lit as a float64 ray cast lights them.
TEST_F(MetallicRoughnessTest, SheetsLookAsInTheTruth) {
    const scene::SceneSetup setup = scenes::makeSheets(2013);
    scene::Scene scene = setup.scene;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (scene.materials[i].alphaMode == scene::AlphaMode::blend && !scene.materials[i].unlit) {
            scene.materials[i].metallicRoughness =
                MetallicRoughness{.metallic = i % 2 == 0 ? 1.0f : 0.0f, .roughness = 0.4f};
        }
    }
    const scene::Camera camera = setup.path.at(0);
    render::RenderOptions options = smallOptions(depth::parseTechnique("anchored/count:5"), 192, 108);
    options.translucency = {.method = render::Translucency::sorted, .countsFragments = true};
    const Frame frame = draw(scene, camera, options);
    const measure::LayerDifference difference = measure::compareLayers(
        frame.color, frame.fragmentCounts, layersOf(scene, camera, frame.width(), frame.height()));
    EXPECT_GT(difference.translucent, 4000u);
    EXPECT_EQ(difference.miscounted, 0u);
    EXPECT_GE(difference.withinFraction(), 0.999);
    EXPECT_NE(hashOf(frame), hashOf(draw(setup.scene, camera, options)));
}

/// What a surface sends is clamped at 16, so that half floats hold it, and sums of blended surfaces. A film that
/// lets all but a hundredth through adds at most 0.16, which is 111 in sRGB. The light that it mirrors may be of
/// any brightness.
TEST_F(MetallicRoughnessTest, WhatASurfaceSendsIsBounded) {
    scene::Scene scene = slabScene(MetallicRoughness{.metallic = 1.0f, .roughness = 0.0f});
    scene.materials[0].baseColorFactor = glm::vec4(1.0f, 1.0f, 1.0f, 0.01f);
    scene.materials[0].alphaMode = scene::AlphaMode::blend;
    scene.ambient = glm::vec3(0.0f);
    scene.lights[0].color = glm::vec3(1000.0f);
    for (const render::Translucency method : render::kTranslucencies) {
        render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"));
        options.translucency.method = method;
        EXPECT_NEAR(brightest(draw(scene, kMetallicRoughnessCamera, options))[0], 111, 2) << nameOf(method);
    }
}

/// The way to the camera and the way to such a light cancel out, so that nothing lies halfway between them.
TEST_F(MetallicRoughnessTest, ALightStraightBehindASurfaceAddsNothing) {
    scene::Scene scene = boxScene();
    for (scene::Vertex& vertex : scene.meshes[0].vertices) {
        vertex.normal = -vertex.normal; // the face towards the camera is lit from behind
    }
    scene.materials[0].metallicRoughness = MetallicRoughness{.metallic = 0.5f, .roughness = 0.5f};
    scene.lights = {{.position = {0.0, 0.0, -5.0}}};
    scene.ambient = glm::vec3(0.25f);
    addBox(scene, {0.0, 0.0, -4.5});
    render::RenderOptions options = smallOptions(depth::parseTechnique("reversed"), 1, 1);
    options.linear = true;
    const float lit = draw(scene, {}, options).linear.at(0, 0).r;
    scene.lights.clear();
    EXPECT_EQ(lit, draw(scene, {}, options).linear.at(0, 0).r);
}

} // namespace

} // namespace cdr::render_test
