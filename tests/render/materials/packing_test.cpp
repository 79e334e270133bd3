#include "../failing_calls.h"
#include "../fixture.h"
#include "../steps.h"

#include <cdr/render/draw_source.h>
#include <cdr/render/materials/scene_textures.h>
#include <cdr/render/materials/texture_packing.h>
#include <cdr/render/uploaded_scene.h>
#include <cdr/scene/world/world.h>
#include <scenes/sheets.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace cdr::render_test {

namespace {

constexpr std::uint32_t kFive = 5;

/// Base colour, metallic and roughness, normal, occlusion, and emission, of one size.
std::vector<scene::Texture> fiveTextures(std::uint32_t seed) {
    std::vector<scene::Texture> textures;
    for (std::uint32_t i = 0; i < kFive; ++i) {
        const bool isColor = i == 0 || i == 4;
        scene::Texture texture{.name = "texture " + std::to_string(i),
                               .pixels = image::ImageRgba8(16, 16),
                               .content =
                                   isColor ? scene::TextureContent::color : scene::TextureContent::data};
        for (std::uint32_t j = 0; j < texture.pixels.pixels.size(); ++j) {
            const std::uint32_t column = j % 16;
            const std::uint32_t row = j / 16;
            texture.pixels.pixels[j] = {static_cast<std::uint8_t>(60 + 10 * column + seed),
                                        static_cast<std::uint8_t>(230 - 9 * row - seed),
                                        static_cast<std::uint8_t>(128 + 7 * ((i + column) % 16)), 255};
        }
        textures.push_back(std::move(texture));
    }
    return textures;
}

/// Reads five textures from `first` on, in the order above.
scene::Material readingFive(std::uint32_t first) {
    scene::Material material{.baseColorTexture = first,
                             .metallicRoughness =
                                 scene::MetallicRoughness{.metallic = 0.6f, .roughness = 0.8f}};
    material.detail = {.metallicRoughness = scene::TextureUse{.texture = first + 1},
                       .normal = scene::TextureUse{.texture = first + 2},
                       .occlusion = scene::TextureUse{.texture = first + 3},
                       .emissive = scene::TextureUse{.texture = first + 4},
                       .emission = glm::vec3(0.3f)};
    return material;
}

class PackingTest : public RenderTest {
  protected:
    /// Two squares of one material that reads five textures.
    static scene::Scene squares() {
        scene::Scene scene = boxScene();
        scene.ambient = glm::vec3(0.6f);
        scene.meshes = {scenes::makeSquare(1.0f)};
        for (scene::Vertex& vertex : scene.meshes[0].vertices) {
            vertex.uv = 0.5f + 0.25f * glm::vec2(vertex.position); // nowhere near an edge
            scene.meshes[0].details.push_back({.tangent = glm::vec4(1.0f, 0.0f, 0.0f, 1.0f)});
        }
        scene.textures = fiveTextures(0);
        scene.materials = {readingFive(0)};
        scene::addInstance(scene, 0, 0, 0, {-0.7, 0.0, 0.0}, glm::mat3(1.0f));
        scene::addInstance(scene, 0, 0, 1, {1.4, 0.0, -0.5}, glm::mat3(1.0f));
        return scene;
    }

    static scene::Camera camera() {
        return scene::lookAt({.fovY = 0.5, .nearView = 0.1, .farView = 100.0}, {0.5, 0.4, 4.5},
                             glm::dvec3(0.0));
    }

    static render::RenderOptions options() {
        render::RenderOptions options = withSorting(thumbnailOptions(depth::parseTechnique("anchored")));
        options.framesInFlight = 3;
        return options;
    }

    /// So many kinds of draws read packed textures.
    static std::ptrdiff_t packedKinds(const render::GpuScene& onDevice) {
        const std::vector<render::DrawKind>& kinds = onDevice.uploaded().kinds();
        return std::count_if(kinds.begin(), kinds.end(), [](const render::DrawKind& kind) {
            return (kind.variant / render::kDetailStep & shaders::kDetailPacked) != 0;
        });
    }
};

/// Alpha is always linear, so what is stored in sRGB cannot be put there.
TEST_F(PackingTest, GuestsThatAreColoursAreReadByThemselves) {
    for (const std::uint32_t guest : {1u, 3u}) {
        scene::Scene scene = squares();
        EXPECT_TRUE(render::isPackable(scene.materials[0], scene.textures));
        scene.textures[guest].content = scene::TextureContent::color;
        EXPECT_FALSE(render::isPackable(scene.materials[0], scene.textures)) << guest;
        const image::ImageRgba8 picture = draw(scene, camera(), options()).color;
        scene.textures[guest].wrapU = scene::WrapMode::clampToEdge; // shows nowhere, and parts them
        EXPECT_EQ(picture, draw(scene, camera(), options()).color) << guest;
    }
}

/// What needs alpha for itself, or says nothing of light.
TEST_F(PackingTest, MaterialsWithAlphaAreReadByThemselves) {
    const scene::Scene scene = squares();
    for (const scene::AlphaMode mode : {scene::AlphaMode::mask, scene::AlphaMode::blend}) {
        scene::Material material = scene.materials[0];
        material.alphaMode = mode;
        EXPECT_FALSE(render::isPackable(material, scene.textures));
    }
    scene::Material unlit = scene.materials[0];
    unlit.unlit = true;
    EXPECT_FALSE(render::isPackable(unlit, scene.textures));
}

/// One sampler reads what is packed, at one place, and all five are there.
TEST_F(PackingTest, TexturesThatAreReadOtherwiseAreReadByThemselves) {
    using Change = void (*)(scene::Texture&);
    const std::vector<Change> changes{
        [](scene::Texture& texture) { texture.pixels = image::ImageRgba8(16, 8); },
        [](scene::Texture& texture) { texture.wrapU = scene::WrapMode::mirroredRepeat; },
        [](scene::Texture& texture) { texture.wrapV = scene::WrapMode::clampToEdge; },
        [](scene::Texture& texture) { texture.magFilter = scene::Filter::nearest; },
        [](scene::Texture& texture) { texture.minFilter = scene::Filter::nearest; },
        [](scene::Texture& texture) { texture.levels = scene::TextureLevels::nearest; },
        [](scene::Texture& texture) { texture.alphaWeighs = true; },
        [](scene::Texture& texture) { texture.cutoff = 0.5f; },
    };
    const scene::Scene scene = squares();
    for (std::size_t change = 0; change < changes.size(); ++change) {
        for (std::uint32_t i = 0; i < kFive; ++i) {
            std::vector<scene::Texture> textures = scene.textures;
            changes[change](textures[i]);
            EXPECT_FALSE(render::isPackable(scene.materials[0], textures)) << change << ", " << i;
        }
    }
    for (const auto use : {&scene::MaterialDetail::metallicRoughness, &scene::MaterialDetail::normal,
                           &scene::MaterialDetail::occlusion, &scene::MaterialDetail::emissive}) {
        scene::Material material = scene.materials[0];
        (material.detail.*use)->second = true;
        EXPECT_FALSE(render::isPackable(material, scene.textures));
        (material.detail.*use)->second = false;
        (material.detail.*use)->transform[2].x = 0.5f;
        EXPECT_FALSE(render::isPackable(material, scene.textures));
        (material.detail.*use).reset();
        EXPECT_FALSE(render::isPackable(material, scene.textures));
    }
}

/// Materials that differ in base colour alone share the rest, as they did before they were packed.
TEST_F(PackingTest, MaterialsShareWhatTheyHaveInCommon) {
    scene::Scene scene = squares();
    const std::uint64_t three = render::SceneTextures::predictBytes(scene);
    for (std::uint32_t i = 0; i < 6; ++i) {
        scene.materials.push_back(scene.materials[0]);
        scene.materials.back().baseColorTexture = static_cast<std::uint32_t>(scene.textures.size());
        scene.textures.push_back(scene.textures[0]);
    }
    EXPECT_EQ(render::SceneTextures::predictBytes(scene), 3 * three);
}

/// Materials become packed and cease to be, and textures go while frames in flight read them. Others take their places.
TEST_F(PackingTest, EditsGiveThePictureOfASceneBuiltAnew) {
    for (const render::Submission submission : submissions()) {
        scene::World world(squares());
        render::GpuScene onDevice(device(), world);
        render::RenderOptions chosen = options();
        chosen.submission = submission;
        render::Renderer renderer(device(), onDevice, chosen);
        const auto expectSame = [&](std::ptrdiff_t packed) {
            EXPECT_EQ(hashOf(renderer.render(camera())), hashOf(draw(world.scene(), camera(), chosen)));
            EXPECT_EQ(packedKinds(onDevice), packed);
        };
        expectSame(1);
        scene::Material glass = readingFive(0);
        glass.alphaMode = scene::AlphaMode::blend;
        world.setMaterial(world.material(0), glass);
        expectSame(0);
        renderer.submit(camera());
        world.setMaterial(world.material(0), readingFive(0));
        expectSame(1);
        renderer.submit(camera());
        world.setMaterial(world.material(0), {.name = "plain"});
        for (std::uint32_t i = kFive; i-- > 0;) {
            world.removeTexture(world.texture(i));
        }
        std::uint32_t place = 0;
        for (scene::Texture& texture : fiveTextures(20)) {
            ASSERT_EQ(world.addTexture(std::move(texture)).index, place++);
        }
        world.setMaterial(world.material(0), readingFive(0));
        expectSame(1);
    }
}

/// Wherever an upload runs out of memory, the next frame is drawn right.
TEST_F(PackingTest, AFailedUploadIsMadeUpFor) {
    std::size_t failed = 0;
    for (std::size_t after = 0; after < 12; ++after) {
        scene::World world(squares());
        render::GpuScene onDevice(device(), world);
        render::Renderer renderer(device(), onDevice, options());
        renderer.submit(camera());
        for (scene::Texture& texture : fiveTextures(20)) {
            world.addTexture(std::move(texture));
        }
        world.setMaterial(world.material(0), readingFive(kFive));
        failed += failsAt("vkCreateBuffer", after, [&] { renderer.draw(camera()); }) ? 1 : 0;
        EXPECT_EQ(hashOf(renderer.render(camera())), hashOf(draw(world.scene(), camera(), options())))
            << after;
        EXPECT_EQ(packedKinds(onDevice), 1);
    }
    EXPECT_GT(failed, 3u);
}

} // namespace

} // namespace cdr::render_test
