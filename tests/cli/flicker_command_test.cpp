#include "program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace cdr::cli_test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using FlickerCommand = FolderTest;

/// The result to reproduce: in wrong pixels, not in flips.
TEST_F(FlickerCommand, WrongPixelsComeInTheThesisOrder) {
    const ProgramResult result = succeed("flicker --frames 12 --size 640x360 --threads 2 --json f.json");
    const json document = jsonIn("f.json");
    EXPECT_EQ(document.at("command"), "flicker");
    std::vector<std::string> order;
    std::vector<double> fractions;
    for (const json& row : document.at("results")) {
        order.push_back(row.at("technique"));
        fractions.push_back(row.at("wrong_fraction"));
        EXPECT_EQ(row.at("scene"), "afc");
        EXPECT_EQ(row.at("frames"), 12);
        EXPECT_NEAR(row.at("wrong").get<double>() / row.at("pixels").get<double>(), fractions.back(), 1e-12);
        EXPECT_NEAR(row.at("flips_per_thousand").get<double>(),
                    1000.0 * row.at("flips").get<double>() / row.at("compared").get<double>(), 1e-9);
        EXPECT_GE(row.at("mean_flip"), 0.0);
        EXPECT_LT(row.at("mean_flip"), 1.0);
        EXPECT_GE(row.at("duplication"), 1.0);
        EXPECT_GE(row.at("cascades"), 1);
    }
    EXPECT_EQ(order, (std::vector<std::string>{"standard", "cdr", "log", "logcdr", "reversed", "anchored"}));
    EXPECT_TRUE(std::is_sorted(fractions.rbegin(), fractions.rend())) << result.out;
    EXPECT_GT(fractions.front(), 0.2);
    EXPECT_LT(fractions.back(), fractions.front());
    // A tenth of the pixels lies on edges, and snapping moves those.
    EXPECT_LT(document.at("results")[5].at("mean_flip"),
              0.1 * document.at("results")[0].at("mean_flip").get<double>() + 0.1 * snapReach());

    const json& pairs = document.at("pairs");
    ASSERT_EQ(pairs.size(), 6u);
    std::vector<double> chiSquared;
    for (const json& pair : pairs) {
        chiSquared.push_back(pair.at("chi_squared"));
        EXPECT_EQ(pair.at("humans_left").get<int>() + pair.at("humans_right").get<int>(), 12);
        EXPECT_EQ(pair.at("agree").get<bool>(), pair.at("observer") == pair.at("humans"));
    }
    const std::vector<double> thesis{5.333, 12, 12, 12, 12, 8.333};
    EXPECT_TRUE(std::equal(thesis.begin(), thesis.end(), chiSquared.begin(),
                           [](double a, double b) { return std::abs(a - b) < 1e-3; }));
}

TEST_F(FlickerCommand, SharesOfNothingAreNullAndBlank) {
    const ProgramResult result =
        succeed("flicker --frames 2 --size 64x36 --techniques standard,log --json f.json");
    const json document = jsonIn("f.json");
    for (const json& row : document.at("results")) {
        EXPECT_EQ(row.at("pixels"), 0) << "the cubes are too small here to have pixels off edges";
        EXPECT_EQ(row.at("wrong_fraction"), nullptr);
        EXPECT_EQ(row.at("overlap_wrong_fraction"), nullptr);
        EXPECT_EQ(row.at("flips_per_thousand"), nullptr);
    }
    ASSERT_EQ(document.at("pairs").size(), 1u);
    EXPECT_EQ(document.at("pairs")[0].at("observer"), nullptr);
    EXPECT_EQ(document.at("pairs")[0].at("agree"), nullptr);
    EXPECT_EQ(result.out.find("neither"), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("0 %"), std::string::npos) << result.out;
}

TEST_F(FlickerCommand, WritesVideosFramesAndStateAndGoesOnFromIt) {
    const std::string arguments = "--validate flicker --frames 3 --size 128x72 --techniques standard,log "
                                  "--format d16 --state . --tga frames --videos v --json ";
    const ProgramResult first = run(arguments + "a.json");
    if (first.err.find("need ffmpeg") != std::string::npos) {
        GTEST_SKIP() << "ffmpeg is not installed";
    }
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(first.err, ""); // progress is for terminals
    EXPECT_GT(fs::file_size(at("v/standard_log.mp4")), 1000u);
    EXPECT_TRUE(fs::exists(at("v/standard_log.png")));
    EXPECT_TRUE(fs::exists(at("flicker_state.json")));
    const std::string frame = textIn("frames/log/0002.tga");
    EXPECT_EQ(frame.size(), 18u + 3 * 128 * 72);
    fs::remove_all(at("frames"));

    const ProgramResult again = succeed(arguments + "b.json");
    EXPECT_NE(again.out.find("results kept in ./flicker_state.json: 3\n"), std::string::npos) << again.out;
    EXPECT_EQ(first.out.find("results kept"), std::string::npos) << first.out;
    EXPECT_EQ(textIn("a.json"), textIn("b.json"));
    EXPECT_EQ(textIn("frames/log/0002.tga"), frame);
    EXPECT_EQ(jsonIn("a.json").at("results")[0].at("format"), "d16");

    expectRefusal("flicker --frames 4 --size 128x72 --state .", "another version");
}

TEST_F(FlickerCommand, AMissingEncoderIsNamed) {
    expectRefusal("flicker --frames 1 --size 64x36 --videos v",
                  "cdr: videos need ffmpeg, which is not installed (Debian, Ubuntu: ffmpeg)\n",
                  "PATH=/nowhere");
    EXPECT_TRUE(folderIsEmpty());
}

/// Before anything is measured and kept.
TEST_F(FlickerCommand, AFileInPlaceOfAFolderOfFramesIsRefused) {
    std::ofstream(at("file")) << "x";
    fs::create_directory(at("frames"));
    std::ofstream(at("frames/log")) << "x";
    for (const char* folder : {"file", "frames"}) {
        expectRefusal("flicker --frames 1 --size 64x36 --techniques log --state s --tga " +
                          std::string(folder),
                      ": cannot be made: ");
        EXPECT_FALSE(fs::exists(at("s")));
    }
}

} // namespace

} // namespace cdr::cli_test
