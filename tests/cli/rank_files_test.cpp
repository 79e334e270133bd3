#include "rank_test.h"

#include <cdr/platform/file.h>

#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace cdr::cli_test {
namespace {

namespace fs = std::filesystem;

const fs::path kModelFolder = CDR_SOURCE_DIR "/tests/assets";

/// Three ranks, each in a folder of its own, 0, 1 and 2, as on nodes that see other files.
class RankFiles : public RankTest {
  protected:
    void SetUp() override {
        RankTest::SetUp();
        if (IsSkipped()) {
            return;
        }
        for (const char* rank : {"0", "1", "2"}) {
            fs::create_directory(at(rank));
            fs::copy_file(kModelFolder / "well.gltf", at(rank) / "well.gltf");
            fs::copy_file(kModelFolder / "well.bin", at(rank) / "well.bin");
            fs::copy_file(kModelFolder / "stone.jpg", at(rank) / "stone.jpg");
        }
    }

    ProgramResult run(const std::string& arguments) const {
        return RankTest::run(arguments, "timeout 1200 env CDR_ORBIT_DATA=maps " +
                                            test::launched(CDR_MPIEXEC, 3) +
                                            " sh -c 'cd $OMPI_COMM_WORLD_RANK$PMI_RANK && exec \"$@\"' sh");
    }

    ProgramResult render() const {
        return run("render well.gltf --size 32x18 --frames 2 -o f%d.png --json all.json");
    }

    /// Whether all end with this line, and nothing is left behind.
    void expectRefused(const std::string& line) const {
        const ProgramResult result = render();
        EXPECT_EQ(result.status, 2);
        EXPECT_TRUE(std::regex_match(result.err, std::regex("cdr: " + line + "\n"))) << result.err;
        EXPECT_FALSE(fs::exists(at("0/all.json")));
    }
};

TEST_F(RankFiles, AModelIsAlikeOnAllRanks) {
    platform::writeText(at("2/well.gltf"), textIn("2/well.gltf") + " ");
    expectRefused("rank 2 on .+: well.gltf: its file well.gltf is another one than the first rank's");
    fs::remove(at("1/well.gltf"));
    expectRefused("rank 1 on .+: well.gltf: .+");
    fs::remove(at("0/well.gltf"));
    expectRefused("well.gltf: .+");
}

/// Of the same length each time, and of a file that another file refers to.
TEST_F(RankFiles, BuffersAndPicturesOfAModelAreAlikeOnAllRanks) {
    EXPECT_EQ(render().status, 0);
    fs::remove(at("0/all.json"));
    std::string buffer = readText(kModelFolder / "well.bin");
    buffer.back() = static_cast<char>(buffer.back() ^ 1);
    platform::writeText(at("1/well.bin"), buffer);
    expectRefused("rank 1 on .+: well.gltf: its file well.bin is another one than the first rank's");
    fs::copy_file(at("0/well.bin"), at("1/well.bin"), fs::copy_options::overwrite_existing);

    std::string picture = textIn("0/stone.jpg");
    picture[picture.size() / 2] = static_cast<char>(picture[picture.size() / 2] ^ 1);
    platform::writeText(at("2/stone.jpg"), picture);
    expectRefused("rank 2 on .+: well.gltf: its file stone.jpg is another one than the first rank's");
}

/// A link that leads out of the folder is refused, so that rank knows of one file less.
TEST_F(RankFiles, AFileThatOneRankRefusesIsNamed) {
    fs::remove(at("1/well.bin"));
    fs::create_symlink(at("0/well.bin"), at("1/well.bin"));
    expectRefused("rank 1 on .+: well.gltf: its file well.bin is another one than the first rank's");
}

TEST_F(RankFiles, AMissingFileOfAModelIsNamed) {
    fs::remove(at("2/stone.jpg"));
    expectRefused("rank 2 on .+: well.gltf: its file stone.jpg is another one than the first rank's");
    fs::remove(at("0/stone.jpg"));
    fs::remove(at("1/stone.jpg"));
    const ProgramResult one = runProgram("render well.gltf --size 32x18", at("1"));
    EXPECT_EQ(one.status, 2);
    EXPECT_NE(one.err.find("stone.jpg: no such file"), std::string::npos) << one.err;
    const ProgramResult three = render();
    EXPECT_EQ(three.status, 2);
    // The message has the whole path, which is in another folder here.
    EXPECT_TRUE(std::regex_match(three.err, std::regex("cdr: well.gltf: .+/0/stone[.]jpg: no such file\n")))
        << three.err;
}

/// As in a shared folder that may not be entered, which root may all the same: so here a link to itself.
TEST_F(RankFiles, WhatCannotBeLookedAtIsOneLine) {
    fs::create_symlink("state.json", at("0/state.json"));
    const ProgramResult state = run("flicker --frames 1 --size 32x18 --state state.json");
    EXPECT_EQ(state.status, 2);
    EXPECT_EQ(state.err, "cdr: state.json: too many links\n");
    fs::remove(at("1/well.gltf"));
    fs::create_symlink("well.gltf", at("1/well.gltf"));
    expectRefused("rank 1 on .+: well.gltf: Too many levels of symbolic links");
}

TEST_F(RankFiles, ThePicturesOfTheEarthAreAlikeOnAllRanks) {
    const fs::path maps = CDR_SOURCE_DIR "/.cache/orbit-data";
    if (!fs::exists(maps)) {
        GTEST_SKIP() << "the Earth of the scene orbit is not installed; tools/setup.sh fetches it";
    }
    for (const char* rank : {"0", "1", "2"}) {
        fs::copy(maps, at(rank) / "maps");
    }
    fs::resize_file(at("1/maps/earth-topology.png"), 1000);
    for (const char* arguments :
         {"render orbit --size 32x18", "render eclipse --size 32x18", "render earth --size 32x18",
          "orbit --frames 1 --size 32x18", "report --smallest -o r"}) {
        const ProgramResult result = run(arguments);
        if (lacksPage(result)) {
            continue;
        }
        EXPECT_EQ(result.status, 2);
        EXPECT_TRUE(std::regex_match(result.err,
                                     std::regex("cdr: rank 1 on .+: orbit: its file earth-topology.png is "
                                                "another one than the first rank's\n")))
            << result.err;
    }
}

} // namespace
} // namespace cdr::cli_test
