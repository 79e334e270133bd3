#include "program.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <ostream>
#include <set>
#include <string>

namespace cdr::cli_test {

namespace {

using nlohmann::json;
using ShadowCommand = FolderTest;

constexpr const char* kStage = " " CDR_SOURCE_DIR "/tests/assets/stage.glb ";

/// A command that shows one moment of a glTF file.
struct Still {
    const char* command;
    const char* options; ///< at its smallest
    const char* picture; ///< a file that it writes
    bool isLit;          ///< whether it takes --light

    friend std::ostream& operator<<(std::ostream& out, const Still& still) { return out << still.command; }
};

class StillCommand : public FolderTest, public testing::WithParamInterface<Still> {};

TEST_P(StillCommand, ShowsTheChosenMomentCameraAndLights) {
    const Still& still = GetParam();
    const auto pictureOf = [&](const std::string& choice) {
        const TemporaryFolder folder;
        const ProgramResult result = cli_test::succeed(still.command + (kStage + std::string(still.options)) +
                                                           " --json s.json " + choice,
                                                       folder.path());
        if (result.status != 0) {
            return std::string();
        }
        const json options = json::parse(readText(folder.path() / "s.json"))["options"];
        const auto has = [&](const char* option) { return choice.find(option) != std::string::npos; };
        EXPECT_EQ(options.value("time", -1.0), has("--time") ? 0.7 : -1.0);
        EXPECT_EQ(options.value("camera", -1), has("--camera") ? 0 : -1);
        EXPECT_EQ(options.value("light", ""), has("--light") ? "file" : "");
        return readText(folder.path() / still.picture);
    };
    std::set<std::string> pictures{pictureOf(""), pictureOf("--camera 0"),
                                   pictureOf("--camera 0 --time 0.7")};
    EXPECT_EQ(pictures.size(), 3u);
    if (still.isLit) {
        pictures.insert(pictureOf("--camera 0 --light file"));
        pictures.insert(pictureOf("--camera 0 --light file --time 0.7"));
        EXPECT_EQ(pictures.size(), 5u);
    }
}

TEST_P(StillCommand, RefusesWhatThereIsNot) {
    const Still& still = GetParam();
    std::set<std::string> bad{std::string("cubes --time 1"),           std::string("cubes --camera 0"),
                              std::string("cubes --animation 0"),      kStage + std::string("--camera 9"),
                              kStage + std::string("--animation fly"), kStage + std::string("--time -1"),
                              kStage + std::string("--gltf-scene 9")};
    if (still.isLit) {
        bad.insert({std::string("cubes --light file"), kStage + std::string("--light skies")});
    }
    for (const std::string& arguments : bad) {
        expectRefusal(fmt::format("{} {} {} --json s.json", still.command, arguments, still.options));
        EXPECT_FALSE(std::filesystem::exists(at("s.json"))) << arguments;
    }
}

INSTANTIATE_TEST_SUITE_P(
    , StillCommand,
    testing::Values(Still{"inspect", "--frames 1 --size 96x54 --techniques reversed --heat-map h.png",
                          "h.png", false},
                    Still{"shadows", "--size 96x54 --out p", "p/anchored_anchored_0_0.png", true},
                    Still{"effects", "--frames 1 --size 96x54 --out p", "p/plain.png", true},
                    Still{"detail", "--frames 1 --size 96x54 --out p", "p/none.png", true},
                    Still{"focus", "--frames 1 --cameras 1 --size 96x54 --out p", "p/single.png", true}),
    [](const testing::TestParamInfo<Still>& info) { return std::string(info.param.command); });

/// A spot, a point light inside its bulb, where all is in shadow, and a directional one, each against float64 rays.
TEST_F(ShadowCommand, MeasuresAFilesOwnLights) {
    const json rows = documentOf("shadows" + std::string(kStage) +
                                 "--camera 0 --light file --time 0.7 --size 640x360 --threads 2")["results"];
    ASSERT_EQ(rows.size(), 3u);
    for (const json& row : rows) {
        EXPECT_GT(row["pixels"], 1000) << row;
        EXPECT_GT(row["shadowed"], 100) << row;
        EXPECT_LE(row["wrong_fraction"], 0.0001) << row;
    }
}

} // namespace

} // namespace cdr::cli_test
