#include <viewer/state/picking.h>
#include <viewer/state/view_settings.h>

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace cdr::viewer {

namespace {

/// Two objects; of the second the parts have two materials.
scene::Scene sceneOfObjects() {
    scene::Scene scene;
    scene.meshes.push_back(scene::makeBox(glm::vec3(1.0f)));
    for (const char* name : {"land", "paint", "paint"}) {
        scene.materials.push_back({.name = name});
    }
    scene::addInstance(scene, 0, 0, 4, {0.0, 0.0, -5.0}, glm::mat3(1.0f));
    scene::addInstance(scene, 0, 2, 9, {2.0, 0.0, -5.0}, glm::mat3(1.0f));
    scene::addInstance(scene, 0, 1, 9, {4.0, 0.0, -5.0}, glm::mat3(1.0f));
    scene::addInstance(scene, 0, 2, 9, {6.0, 0.0, -5.0}, glm::mat3(1.0f));
    return scene;
}

TEST(LayerEdits, ListTheMaterialsOfAnObject) {
    const scene::Scene scene = sceneOfObjects();
    EXPECT_EQ(materialsOf(scene, 4), (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(materialsOf(scene, 9), (std::vector<std::uint32_t>{1, 2}));
    EXPECT_TRUE(materialsOf(scene, 5).empty());
}

/// What is picked is an object. A scene opened anew may give it other materials, or have it no more.
TEST(LayerEdits, ListTheMaterialsOfWhatIsPickedInEachScene) {
    const scene::Scene scene = sceneOfObjects();
    scene::Scene grey = scene;
    grey.materials.resize(1);
    grey.instances.material.assign(grey.instances.size(), 0);
    Measuring measuring;
    EXPECT_TRUE(measuring.materialsIn(scene).empty());
    PickedPoint point;
    point.object = 4;
    measuring.click(point);
    EXPECT_EQ(measuring.materialsIn(scene), (std::vector<std::uint32_t>{0}));
    point.object = 9;
    measuring.click(point);
    EXPECT_EQ(measuring.materialsIn(scene), (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(measuring.materialsIn(grey), (std::vector<std::uint32_t>{0}));
    EXPECT_TRUE(measuring.materialsIn({}).empty());
}

TEST(LayerEdits, ChooseForOneMaterialAndClear) {
    const scene::Scene scene = sceneOfObjects();
    ViewSettings settings;
    EXPECT_EQ(chosenLayer(settings, scene, 1), std::nullopt);
    chooseLayer(settings, scene, 1, 0.5f);
    chooseLayer(settings, scene, 0, 0.25f);
    chooseLayer(settings, scene, 1, 2.0f);
    EXPECT_EQ(settings.layers.size(), 2u);
    EXPECT_EQ(scenes::layersOf(scene, settings.layers), (std::vector<float>{0.25f, 2.0f, 0.0f}));
    EXPECT_EQ(chosenLayer(settings, scene, 1), 2.0f);
    EXPECT_EQ(chosenLayer(settings, scene, 2), std::nullopt);
    clearLayer(settings, scene, 1);
    EXPECT_EQ(scenes::layersOf(scene, settings.layers), (std::vector<float>{0.25f, 0.0f, 0.0f}));
    clearLayer(settings, scene, 0);
    EXPECT_TRUE(settings.layers.empty());
}

/// As a command line may give them: one for all materials of a name.
TEST(LayerEdits, StandBesideChoicesOfSeveralMaterials) {
    const scene::Scene scene = sceneOfObjects();
    ViewSettings settings;
    settings.layers = {{"paint", 1.0f}};
    EXPECT_EQ(chosenLayer(settings, scene, 2), 1.0f);
    chooseLayer(settings, scene, 2, 3.0f);
    EXPECT_EQ(scenes::layersOf(scene, settings.layers), (std::vector<float>{0.0f, 1.0f, 3.0f}));
    clearLayer(settings, scene, 2);
    EXPECT_TRUE(settings.layers.empty());
}

/// The grey scene has not the materials that a layer is of.
TEST(LayerEdits, GoWithTheColoursThatTheyAreOf) {
    ViewSettings settings;
    settings.colours = scenes::Colours::bright;
    settings.layers = {{"#3", 1.0f}};
    chooseColours(settings, scenes::Colours::thesis);
    EXPECT_EQ(settings.colours, scenes::Colours::thesis);
    EXPECT_TRUE(settings.layers.empty());
}

TEST(LayerEdits, GoWithTheSceneThatTheyAreOf) {
    ViewSettings settings;
    settings.layers = {{"paint", 1.0f}};
    chooseScene(settings, "cubes");
    EXPECT_EQ(settings.scene, "cubes");
    EXPECT_TRUE(settings.layers.empty());
}

} // namespace

} // namespace cdr::viewer
