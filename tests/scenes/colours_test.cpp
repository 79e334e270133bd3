#include <cdr/base/error.h>
#include <scenes/colours.h>
#include <scenes/open_scene.h>

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace cdr::scenes;
using cdr::scene::Scene;

Scene sceneOf(const std::string& name) {
    return openScene(name, 2013).setup.scene;
}

std::set<std::uint32_t> materialsIn(const Scene& scene) {
    return {scene.instances.material.begin(), scene.instances.material.end()};
}

TEST(Colours, ChangeColoursAndNothingElse) {
    for (const char* name : {"cubes", "afc", "afc-near", "rotation", "ladder", "mixed", "traffic"}) {
        const Scene grey = sceneOf(name);
        Scene bright = grey;
        paint(bright, name, Colours::bright);
        EXPECT_EQ(bright.instances.x, grey.instances.x) << name;
        EXPECT_EQ(bright.instances.object, grey.instances.object) << name;
        EXPECT_EQ(bright.instances.mesh, grey.instances.mesh) << name;
        EXPECT_GE(materialsIn(bright).size(), 7u) << name;
        EXPECT_GT(bright.background.b, 0.0f) << name;
        EXPECT_TRUE(isGreyInThesis(name)) << name;
    }
}

TEST(Colours, LeaveWhatHasColoursAndWhatIsTheThesis) {
    for (const char* name : {"boulders", "sheets", "alley"}) {
        const Scene own = sceneOf(name);
        Scene painted = own;
        paint(painted, name, Colours::bright);
        EXPECT_EQ(painted.instances.material, own.instances.material) << name;
        EXPECT_EQ(painted.background, own.background) << name;
        EXPECT_FALSE(isGreyInThesis(name)) << name;
    }
    Scene grey = sceneOf("afc");
    paint(grey, "afc.gltf", Colours::bright); // a file may call its materials as it likes
    EXPECT_EQ(materialsIn(grey).size(), 1u);
    paint(grey, "afc", Colours::thesis);
    EXPECT_EQ(materialsIn(grey).size(), 1u);
}

TEST(Colours, KeepTheRedThatMarksWrongPixelsOfMixed) {
    const Scene grey = sceneOf("mixed");
    Scene bright = grey;
    paint(bright, "mixed", Colours::bright);
    for (std::size_t i = 0; i < grey.instances.size(); ++i) {
        const bool isTwin = grey.materials[grey.instances.material[i]].name == "twin";
        EXPECT_EQ(bright.materials[bright.instances.material[i]].name == "twin", isTwin);
    }
}

TEST(Colours, OfManyObjectsLeaveRunsThatAreOneDraw) {
    Scene bright = sceneOf("rotation");
    paint(bright, "rotation", Colours::bright);
    const std::vector<std::uint32_t>& materials = bright.instances.material;
    std::size_t runs = 1;
    for (std::size_t i = 1; i < materials.size(); ++i) {
        runs += materials[i] != materials[i - 1];
    }
    EXPECT_LE(runs, 4096u) << materials.size();
}

TEST(Colours, OfAnotherNameAreRefused) {
    EXPECT_EQ(parseColours(nameOf(Colours::bright)), Colours::bright);
    EXPECT_THROW(parseColours("brigth"), cdr::base::InputError);
}

} // namespace
