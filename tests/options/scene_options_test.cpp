#include "parsing.h"

#include <gtest/gtest.h>
#include <options/camera_options.h>
#include <options/scene_options.h>

namespace cdr::options {

namespace {

TEST(SceneOptions, KeepLayersAsGivenAndAsMeant) {
    CLI::App command;
    LayerArguments layers;
    addLayers(command, layers);
    EXPECT_EQ(refusalOf(command, {"--layer", "paint=2e-3", "--layer", "#1=1"}), "");
    EXPECT_EQ(layers.texts, (std::vector<std::string>{"paint=2e-3", "#1=1"}));
    EXPECT_EQ(layers.choices, (std::vector<scenes::LayerChoice>{{"paint", 0.002f}, {"#1", 1.0f}}));
    EXPECT_NE(refusalOf(command, {"--layer", "paint"}).find("MATERIAL=LAYER"), std::string::npos);
}

TEST(SceneOptions, ShowTheColoursThatTheyBeginWith) {
    CLI::App command;
    std::optional<scenes::Colours> colours = scenes::Colours::thesis;
    addColours(command, colours);
    EXPECT_EQ(command.get_option("--colours")->get_default_str(), "thesis");
    EXPECT_EQ(refusalOf(command, {"--colours=bright"}), "");
    EXPECT_EQ(colours, scenes::Colours::bright);
    EXPECT_NE(refusalOf(command, {"--colours=brigth"}).find("did you mean 'bright'"), std::string::npos);
}

TEST(CameraOptions, ArePoints) {
    CLI::App command;
    CameraOptions camera;
    addCameraOptions(command, camera);
    EXPECT_EQ(refusalOf(command, {"--eye=1,2,-3.5", "--target", "", "--up=1,0,0"}), "");
    EXPECT_EQ(camera.eye, glm::dvec3(1.0, 2.0, -3.5));
    EXPECT_FALSE(camera.target);
    const scene::Camera seen = overridden({}, camera);
    EXPECT_EQ(seen.position, glm::dvec3(1.0, 2.0, -3.5));
    EXPECT_NE(refusalOf(command, {"--direction=0,0"}).find("--direction must be three numbers"),
              std::string::npos);
}

} // namespace

} // namespace cdr::options
