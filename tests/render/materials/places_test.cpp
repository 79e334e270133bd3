#include "../fixture.h"
#include "../steps.h"

#include <cdr/measure/truth/layered_truth.h>
#include <cdr/render/materials/scene_textures.h>
#include <cdr/shaders/shared.h>

#include <array>

namespace cdr::render_test {

namespace {

/// From a place to another: turned, stretched and moved.
constexpr glm::mat3x2 kWay{0.5f, 0.75f, -1.25f, 0.25f, 0.125f, 0.375f};

using UseOf = std::optional<scene::TextureUse> scene::MaterialDetail::*;
constexpr std::array<UseOf, 4> kUses{&scene::MaterialDetail::metallicRoughness,
                                     &scene::MaterialDetail::normal, &scene::MaterialDetail::occlusion,
                                     &scene::MaterialDetail::emissive};

/// A picture that looks like no turned copy of itself.
image::ImageRgba8 uneven() {
    image::ImageRgba8 picture(16, 16);
    for (std::uint32_t y = 0; y < 16; ++y) {
        for (std::uint32_t x = 0; x < 16; ++x) {
            picture.at(x, y) = {static_cast<std::uint8_t>(x * 16), static_cast<std::uint8_t>(255 - y * 12),
                                static_cast<std::uint8_t>(128 + x * y / 3), 255};
        }
    }
    return picture;
}

class PlacesTest : public RenderTest {
  protected:
    /// A square whose second place in textures is the first, led by kWay. All of its textures are read as `use` says.
    static scene::Scene squareWith(UseOf use, const scene::TextureUse& as) {
        scene::Scene scene = boxScene();
        scene.meshes.assign(1, scene::Mesh{});
        scene.meshes[0].name = "square";
        scene.meshes[0].indices = {0, 1, 2, 0, 2, 3};
        scene.meshes[0].boundingRadius = 1.5f;
        for (const glm::vec2& corner :
             {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
            scene.meshes[0].vertices.push_back({.position = glm::vec3(corner, 0.0f), .uv = corner});
            scene.meshes[0].details.push_back({.uv = kWay * glm::vec3(corner, 1.0f)});
        }
        scene.textures = {{.name = "uneven", .pixels = uneven(), .content = scene::TextureContent::data}};
        scene.materials = {
            {.name = "placed",
             .metallicRoughness = scene::MetallicRoughness{.metallic = 0.5f, .roughness = 0.6f}}};
        scene.materials[0].detail.emission = glm::vec3(use == &scene::MaterialDetail::emissive ? 0.5f : 0.0f);
        scene.materials[0].detail.*use = as;
        scene::addInstance(scene, 0, 0, 0, glm::dvec3(0.0), glm::mat3(1.0f));
        return scene;
    }

    static scene::Camera camera() {
        return scene::lookAt({.fovY = 0.5, .nearView = 0.1, .farView = 100.0}, {0.5, 0.4, 4.5},
                             glm::dvec3(0.0));
    }

    static render::RenderOptions options() {
        render::RenderOptions options = smallOptions(depth::parseTechnique("anchored"));
        options.width = 160;
        options.height = 90;
        options.translucency.method = render::Translucency::sorted;
        return options;
    }

    static double meanSteps(const image::ImageRgba8& a, const image::ImageRgba8& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            sum += largestStep(a.pixels[i], b.pixels[i]);
        }
        return sum / static_cast<double>(a.pixels.size());
    }
};

} // namespace

/// One picture for occlusion, roughness and metallic, as many files have it, is read once.
TEST_F(PlacesTest, ATextureOfTwoUsesLooksAsTwoTextures) {
    for (const scene::AlphaMode mode : {scene::AlphaMode::opaque, scene::AlphaMode::blend}) {
        scene::Scene scene = squareWith(&scene::MaterialDetail::metallicRoughness, {});
        scene.ambient = glm::vec3(0.6f);
        scene.materials[0].alphaMode = mode;
        const render::Frame bright = draw(scene, camera(), options());
        scene.materials[0].detail.occlusion = scene::TextureUse{};
        const render::Frame once = draw(scene, camera(), options());
        const std::uint32_t parts = render::detailPartsOf(scene.materials[0]);
        scene.textures.push_back(scene.textures[0]);
        scene.materials[0].detail.occlusion->texture = 1;
        const render::Frame twice = draw(scene, camera(), options());
        EXPECT_EQ(parts, render::detailPartsOf(scene.materials[0]) | shaders::kDetailShared);
        EXPECT_EQ(once.color, twice.color);
        EXPECT_NE(once.color, bright.color);
    }
}

/// What a transform leads to looks as what vertices say, with every texture, opaque and blended.
TEST_F(PlacesTest, TransformsLeadToAnyPlace) {
    for (const UseOf use : kUses) {
        for (const scene::AlphaMode mode : {scene::AlphaMode::opaque, scene::AlphaMode::blend}) {
            const auto pictureOf = [&](const scene::TextureUse& as) {
                scene::Scene scene = squareWith(use, as);
                scene.materials[0].alphaMode = mode;
                return draw(scene, camera(), options()).color;
            };
            const image::ImageRgba8 wanted = pictureOf({.second = true});
            EXPECT_LT(meanSteps(pictureOf({.transform = kWay}), wanted), 0.1);
            const image::ImageRgba8 plain = pictureOf({});
            EXPECT_GT(meanSteps(plain, wanted), 1.0);
            const glm::mat3 back = glm::inverse(
                glm::mat3(glm::vec3(kWay[0], 0.0f), glm::vec3(kWay[1], 0.0f), glm::vec3(kWay[2], 1.0f)));
            EXPECT_LT(meanSteps(pictureOf({.second = true, .transform = glm::mat3x2(back)}), plain), 0.1);
        }
    }
}

TEST_F(PlacesTest, LookAsFloat64TruthReadsThem) {
    platform::WorkerPool workers(2);
    for (const UseOf use : kUses) {
        const scene::Scene scene = squareWith(use, {.transform = kWay});
        const render::Frame frame = draw(scene, camera(), options());
        const measure::LayeredTruth truth =
            measure::castLayers(scene, camera(), frame.width(), frame.height(), workers);
        EXPECT_LT(meanSteps(measure::pictureOf(truth), frame.color), 1.5);
    }
}

} // namespace cdr::render_test
