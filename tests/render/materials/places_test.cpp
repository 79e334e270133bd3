#include "../fixture.h"
#include "../steps.h"

#include <cdr/measure/truth/layered_truth.h>
#include <cdr/render/materials/scene_textures.h>
#include <cdr/render/materials/texture_packing.h>
#include <cdr/shaders/shared.h>
#include <scenes/sheets.h>

#include <algorithm>
#include <array>
#include <vector>

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
        scene.meshes = {scenes::makeSquare(1.0f)};
        for (scene::Vertex& vertex : scene.meshes[0].vertices) {
            vertex.uv = glm::vec2(vertex.position);
            scene.meshes[0].details.push_back({.uv = kWay * glm::vec3(vertex.uv, 1.0f)});
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
        return withSorting(smallOptions(depth::parseTechnique("anchored"), 160, 90));
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

/// The truth lights such a material by Lambert's law alone, too.
TEST_F(PlacesTest, ATextureAloneMakesNoMetallicRoughness) {
    for (const scene::AlphaMode mode : {scene::AlphaMode::opaque, scene::AlphaMode::blend}) {
        scene::Scene scene = squareWith(&scene::MaterialDetail::metallicRoughness, {});
        scene.materials[0].metallicRoughness.reset();
        scene.materials[0].alphaMode = mode;
        const render::Frame alone = draw(scene, camera(), options());
        scene.materials.push_back(
            {.name = "glossy, of nothing", .metallicRoughness = scene::MetallicRoughness{}});
        EXPECT_EQ(draw(scene, camera(), options()).color, alone.color);
    }
}

/// Five textures of one size and sampler are read as three; a sampler that differs, in a way that does not show, parts them.
TEST_F(PlacesTest, FivePackedTexturesLookAsFive) {
    scene::Scene scene = squareWith(&scene::MaterialDetail::metallicRoughness, {});
    scene.ambient = glm::vec3(0.6f);
    scene.meshes[0].details.assign(scene.meshes[0].vertices.size(),
                                   {.tangent = glm::vec4(1.0f, 0.0f, 0.0f, 1.0f)});
    for (scene::Vertex& vertex : scene.meshes[0].vertices) {
        vertex.uv = 0.25f + 0.5f * (0.5f + 0.5f * vertex.uv); // nowhere near an edge of a texture
    }
    scene.textures.assign(5, scene.textures[0]);
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        for (image::Rgba8& pixel : scene.textures[i].pixels.pixels) {
            std::rotate(pixel.begin(), pixel.begin() + static_cast<std::ptrdiff_t>(i % 3), pixel.begin() + 3);
            pixel[3] = 7; // of no meaning here
        }
    }
    scene.textures[0].content = scene::TextureContent::color;
    scene.textures[4].content = scene::TextureContent::color;
    scene::Material& material = scene.materials[0];
    material.baseColorTexture = 0;
    material.detail.emission = glm::vec3(0.5f);
    for (std::uint32_t i = 0; i < kUses.size(); ++i) {
        material.detail.*kUses[i] = scene::TextureUse{.texture = i + 1};
    }
    EXPECT_TRUE(render::isPackable(material, scene.textures));
    const image::ImageRgba8 packed = draw(scene, camera(), options()).color;
    scene.textures[3].wrapU = scene::WrapMode::clampToEdge;
    EXPECT_FALSE(render::isPackable(material, scene.textures));
    const image::ImageRgba8 apart = draw(scene, camera(), options()).color;
    EXPECT_LT(meanSteps(packed, apart), 0.1);
    EXPECT_GT(meanSteps(packed, image::ImageRgba8(packed.width, packed.height, packed.pixels[0])), 5.0);
    for (std::uint32_t i = 0; i < kUses.size(); ++i) { // each of them is seen
        scene::Scene other = scene;
        other.textures[3].wrapU = scene::WrapMode::repeat;
        other.textures[i + 1].pixels = image::ImageRgba8(16, 16, {40, 90, 200, 255});
        EXPECT_GT(meanSteps(draw(other, camera(), options()).color, packed), 1.0) << i;
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
    for (const UseOf use : kUses) {
        const scene::Scene scene = squareWith(use, {.transform = kWay});
        const render::Frame frame = draw(scene, camera(), options());
        const measure::LayeredTruth truth = layersOf(scene, camera(), frame.width(), frame.height());
        EXPECT_LT(meanSteps(measure::pictureOf(truth), frame.color), 1.5);
    }
}

} // namespace cdr::render_test
