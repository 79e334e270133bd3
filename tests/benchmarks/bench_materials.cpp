// Frames of a model with all five textures against those with base colour alone. They take turns, and what is reported is the
// median of the ratios of neighbours: of time, and of CPU time. Textures that the model lacks are made, each as large as its
// base colour's. The model is flight_helmet, or where that is not there, tests/assets/materials.glb.

#include "paired_cost.h"

#include <cdr/render/renderer.h>
#include <scenes/open_scene.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace {

using namespace cdr;

/// Which textures of a material are drawn beside its base colour's; a sum. Packed: occlusion is in red of the texture of
/// metallic and roughness, as in the original files of the helmet.
enum Parts : unsigned {
    kNone = 0,
    kMetallicRoughness = 1,
    kNormal = 2,
    kOcclusion = 4,
    kEmission = 8,
    kAll = 15,
    kPacked = 16
};

/// What is added to a model, and to which light.
struct MaterialsCase {
    const char* name;
    scene::ModelLight light;
    unsigned textures = kAll;
};

constexpr std::array kCases{
    MaterialsCase{"shine alone, lamps", scene::ModelLight::lamps, kNone},
    MaterialsCase{"metallic and roughness, lamps", scene::ModelLight::lamps, kMetallicRoughness},
    MaterialsCase{"normal, lamps", scene::ModelLight::lamps, kNormal},
    MaterialsCase{"occlusion, lamps", scene::ModelLight::lamps, kOcclusion},
    MaterialsCase{"emission, lamps", scene::ModelLight::lamps, kEmission},
    MaterialsCase{"normal and packed, lamps", scene::ModelLight::lamps,
                  kNormal | kMetallicRoughness | kPacked},
    MaterialsCase{"five textures, lamps", scene::ModelLight::lamps},
    MaterialsCase{"five textures, sky", scene::ModelLight::sky}};

std::string modelFile() {
    const std::string helmet = CDR_ASSETS_DIR "/flight_helmet/flight_helmet.gltf";
    return std::filesystem::exists(helmet) ? helmet : CDR_SOURCE_DIR "/tests/assets/materials.glb";
}

/// Bumps and stains: values that differ from texel to texel, about a mean.
scene::Texture madeTexture(std::string name, std::uint32_t width, std::uint32_t height,
                           const image::Rgba8& mean, scene::TextureContent content) {
    scene::Texture texture{
        .name = std::move(name), .pixels = image::ImageRgba8(width, height), .content = content};
    for (std::size_t i = 0; i < texture.pixels.pixels.size(); ++i) {
        const auto noise = static_cast<std::uint32_t>(i * 2654435761u);
        for (std::size_t c = 0; c < 3; ++c) {
            const int off = static_cast<int>((noise >> (8 * c + 3)) % 32) - 16;
            texture.pixels.pixels[i][c] = static_cast<std::uint8_t>(std::clamp(mean[c] + off, 0, 255));
        }
        texture.pixels.pixels[i][3] = 255;
    }
    return texture;
}

/// Adds a texture, as large as the material's base colour's, where the material has none.
void provide(scene::Scene& scene, std::uint32_t width, std::uint32_t height,
             std::optional<scene::TextureUse>& use, const image::Rgba8& mean, scene::TextureContent content) {
    if (!use) {
        use = scene::TextureUse{.texture = static_cast<std::uint32_t>(scene.textures.size())};
        scene.textures.push_back(madeTexture("made", width, height, mean, content));
    }
}

void giveTextures(scene::Scene& scene, unsigned parts) {
    for (scene::Material& material : scene.materials) {
        if (!material.baseColorTexture || material.unlit) {
            continue;
        }
        const image::ImageRgba8& base = scene.textures[*material.baseColorTexture].pixels;
        const auto give = [&, width = base.width,
                           height = base.height](Parts part, std::optional<scene::TextureUse>& use,
                                                 const image::Rgba8& mean, scene::TextureContent content) {
            if ((parts & part) != 0) {
                provide(scene, width, height, use, mean, content);
            } else {
                use.reset();
            }
        };
        scene::MaterialDetail& detail = material.detail;
        give(kMetallicRoughness, detail.metallicRoughness, {255, 150, 90, 255}, scene::TextureContent::data);
        give(kNormal, detail.normal, {128, 128, 239, 255}, scene::TextureContent::data);
        give(kOcclusion, detail.occlusion, {200, 200, 200, 255}, scene::TextureContent::data);
        detail.occlusion = (parts & kPacked) != 0 ? detail.metallicRoughness : detail.occlusion;
        give(kEmission, detail.emissive, {20, 20, 30, 255}, scene::TextureContent::color);
        detail.emission = glm::vec3((parts & kEmission) != 0 ? 1.0f : 0.0f);
    }
}

/// Tangents for meshes that have none: which way they point makes no difference to the time.
void giveTangents(scene::Scene& scene) {
    for (scene::Mesh& mesh : scene.meshes) {
        for (std::size_t i = mesh.details.size(); i < mesh.vertices.size(); ++i) {
            const glm::vec3 normal = mesh.vertices[i].normal;
            const glm::vec3 beside = std::abs(normal.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
            mesh.details.push_back({.tangent = glm::vec4(glm::normalize(glm::cross(normal, beside)), 1.0f)});
        }
    }
}

/// @param state case, threads
void materials(benchmark::State& state) {
    static const benchmarks::Gpu gpu;
    const MaterialsCase& drawn = kCases[static_cast<std::size_t>(state.range(0))];
    state.SetLabel(std::filesystem::path(modelFile()).stem().string() + ", " + drawn.name);
    scene::GltfChoice choice;
    choice.light = drawn.light;
    scene::SceneSetup setup = scenes::openScene(modelFile(), scenes::kDefaultSeed, choice).setup;
    scene::Scene plain = setup.scene;
    for (scene::Material& material : plain.materials) {
        material.metallicRoughness.reset();
        material.detail = {};
    }
    giveTextures(setup.scene, drawn.textures);
    giveTangents(setup.scene);
    const render::GpuScene plainOnDevice(gpu.device, plain);
    const render::GpuScene wholeOnDevice(gpu.device, setup.scene);
    const render::RenderOptions options{.technique = depth::parseTechnique("anchored"),
                                        .threads = static_cast<std::size_t>(state.range(1))};
    render::Renderer base(gpu.device, plain, plainOnDevice, options);
    render::Renderer whole(gpu.device, setup.scene, wholeOnDevice, options);
    benchmarks::reportOver(state, setup.path, base, whole);
}

BENCHMARK(materials)
    ->ArgNames({"case", "threads"})
    ->ArgsProduct({benchmark::CreateDenseRange(0, kCases.size() - 1, 1), {1}})
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(40);

} // namespace
