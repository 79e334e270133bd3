#include "../fixture.h"
#include "../steps.h"

#include <scenes/sheets.h>

#include <algorithm>
#include <array>

namespace cdr::render_test {

namespace {

const scene::Camera kMaterialCamera =
    scene::lookAt({.fovY = 0.6, .nearView = 0.1, .farView = 100.0}, {0.5, 0.4, 8.0}, glm::dvec3(0.0));

/// A square across the z axis, corners in colours of their own, its texture tiled twice.
scene::Mesh paintedSquare() {
    scene::Mesh mesh = scenes::makeSquare(1.0f);
    const std::array colors{glm::u8vec4(255), glm::u8vec4(255, 128, 0, 255), glm::u8vec4(0, 255, 128, 255),
                            glm::u8vec4(128, 0, 255, 255)};
    for (std::size_t i = 0; i < colors.size(); ++i) {
        mesh.vertices[i].uv = glm::vec2(mesh.vertices[i].position);
        mesh.vertices[i].color = colors[i];
    }
    return mesh;
}

/// Four squares that differ by what their materials say: texture, mask, double-sided (seen from behind),
/// plain.
scene::Scene paintedScene(const std::optional<scene::MetallicRoughness>& metallicRoughness) {
    scene::Scene scene = boxScene();
    scene.meshes = {paintedSquare()};
    image::ImageRgba8 picture(8, 8);
    for (std::uint32_t y = 0; y < 8; ++y) {
        for (std::uint32_t x = 0; x < 8; ++x) {
            const auto alpha = static_cast<std::uint8_t>((x + y) % 3 == 0 ? 10 : 240);
            picture.at(x, y) = {static_cast<std::uint8_t>(30 * x + 40),
                                static_cast<std::uint8_t>(30 * y + 40), 90, alpha};
        }
    }
    scene.textures.push_back({.name = "tiles", .pixels = picture});
    scene.materials = {
        {.name = "textured", .baseColorFactor = glm::vec4(0.8f, 1.0f, 0.6f, 1.0f), .baseColorTexture = 0},
        {.name = "masked", .baseColorTexture = 0, .alphaMode = scene::AlphaMode::mask, .alphaCutoff = 0.4f},
        {.name = "both sides", .baseColorFactor = glm::vec4(0.9f, 0.7f, 0.5f, 1.0f), .doubleSided = true},
        {.name = "one side"}};
    const glm::mat3 turned(-1.0f, 0.0f, 0.2f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, -1.0f);
    for (std::uint32_t i = 0; i < 4; ++i) {
        scene.materials[i].metallicRoughness = metallicRoughness;
        scene::addInstance(scene, 0, i, i, {i % 2 == 0 ? -1.1 : 1.1, i < 2 ? 1.1 : -1.1, 0.05 * i},
                           i == 2 ? turned : glm::mat3(1.0f));
    }
    return scene;
}

using MaterialTest = RenderTest;

/// Textures, vertex colours, masks and sides, matt and shiny, beside a float64 ray cast that samples and cuts
/// itself.
TEST_F(MaterialTest, LooksAsTheTruthDoes) {
    for (const std::optional<scene::MetallicRoughness>& metallicRoughness :
         {std::optional<scene::MetallicRoughness>(),
          std::optional(scene::MetallicRoughness{.metallic = 1.0f, .roughness = 0.5f}),
          std::optional(scene::MetallicRoughness{.metallic = 0.0f, .roughness = 0.3f})}) {
        const scene::Scene scene = paintedScene(metallicRoughness);
        const render::Frame frame =
            draw(scene, kMaterialCamera, smallOptions(depth::parseTechnique("reversed")));
        const auto [off, inner] =
            offTruth(layersOf(scene, kMaterialCamera, frame.width(), frame.height()), frame.color);
        EXPECT_GT(inner, frame.color.pixels.size() * 9 / 10);
        EXPECT_LT(off * 200, inner) << (metallicRoughness ? metallicRoughness->metallic : -1.0f);
        // Each square shows, and through the mask the background.
        std::array<std::size_t, 5> pixels{};
        for (const std::uint32_t id : frame.ids().pixels) {
            ++pixels[id];
        }
        EXPECT_GT(pixels[1], 5000u);
        EXPECT_GT(pixels[2], 2000u);
        EXPECT_LT(pixels[2], pixels[4] * 19 / 20);
        EXPECT_GT(pixels[3], 5000u);
        EXPECT_GT(pixels[4], 5000u);
    }
}

/// Seen from behind only what has two sides is there.
TEST_F(MaterialTest, BacksOfOneSideAreNotDrawn) {
    scene::Scene scene = paintedScene({});
    for (std::size_t i = 0; i < 4; ++i) {
        scene.instances.basis[i] = glm::mat3(-1, 0, 0, 0, 1, 0, 0, 0, -1);
    }
    const render::Frame frame = draw(scene, kMaterialCamera, smallOptions(depth::parseTechnique("reversed")));
    const std::vector<std::uint32_t> ids = frame.ids().pixels;
    for (const std::uint32_t id : {1u, 2u, 4u}) {
        EXPECT_EQ(std::count(ids.begin(), ids.end(), id), 0) << id;
    }
    EXPECT_GT(std::count(ids.begin(), ids.end(), 3u), 5000);
}

} // namespace

} // namespace cdr::render_test
