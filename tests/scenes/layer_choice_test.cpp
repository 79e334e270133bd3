#include <cdr/base/error.h>
#include <cdr/platform/worker_pool.h>
#include <scenes/layer_choice.h>
#include <scenes/moving_scene.h>
#include <scenes/open_scene.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace cdr::scenes;
using cdr::base::InputError;
using cdr::scene::Scene;

Scene sceneWith(const std::vector<std::string>& names) {
    Scene scene;
    for (const std::string& name : names) {
        scene.materials.push_back({.name = name, .layer = 0.5f});
    }
    return scene;
}

TEST(LayerChoice, MeansMaterialsByNameAndByNumber) {
    const Scene scene = sceneWith({"land", "paint", "paint", "#1", ""});
    const auto layers = [&](const std::vector<LayerChoice>& choices) { return layersOf(scene, choices); };
    EXPECT_EQ(layers({}), (std::vector<float>{0.5f, 0.5f, 0.5f, 0.5f, 0.5f}));
    EXPECT_EQ(layers({{"paint", 2.0f}}), (std::vector<float>{0.5f, 2.0f, 2.0f, 0.5f, 0.5f}));
    EXPECT_EQ(layers({{"paint", 2.0f}, {"#1", 3.0f}, {"#4", 4.0f}}),
              (std::vector<float>{0.5f, 3.0f, 2.0f, 0.5f, 4.0f}));
    EXPECT_EQ(layers({{"#1", 3.0f}, {"paint", 2.0f}}), (std::vector<float>{0.5f, 2.0f, 2.0f, 0.5f, 0.5f}));
    for (const char* material : {"pain", "#5", "#", "#-1", "#1x", "#99999999999999999999"}) {
        EXPECT_THROW(layers({{material, 1.0f}}), InputError) << material;
    }
}

TEST(LayerChoice, NamesEachMaterialSoThatItAloneIsMeant) {
    const Scene scene = sceneWith({"land", "paint", "paint", "#1", ""});
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
        const LayerChoice choice{materialName(scene, i), 7.0f};
        std::vector<float> expected(scene.materials.size(), 0.5f);
        expected[i] = 7.0f;
        EXPECT_EQ(layersOf(scene, {&choice, 1}), expected) << choice.material;
    }
    EXPECT_EQ(materialName(scene, 0), "land");
}

TEST(LayerChoice, ARefusedOneChangesNothing) {
    Scene scene = sceneWith({"land", "paint"});
    const std::vector<LayerChoice> choices{{"land", 1.0f}, {"nosuch", 2.0f}};
    EXPECT_THROW(setLayers(scene, choices), InputError);
    EXPECT_EQ(scene.materials[0].layer, 0.5f);
    setLayers(scene, {choices.data(), 1});
    EXPECT_EQ(scene.materials[0].layer, 1.0f);
}

TEST(MovingScene, ChangesLayersOfWhatMovesAndOfWhatRests) {
    cdr::platform::WorkerPool workers(1);
    for (const char* name : {"coplanar", "traffic"}) {
        const auto setup = openScene(name, kDefaultSeed).setup;
        MovingScene moving(setup.scene, setup.motion);
        std::vector<float> layers = layersOf(setup.scene, {});
        layers.front() = 0.25f;
        moving.setLayers(layers);
        moving.show(1, workers);
        EXPECT_EQ(layersOf(moving.world().scene(), {}), layers) << name;
    }
}

} // namespace
