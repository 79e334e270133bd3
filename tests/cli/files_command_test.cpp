#include "program.h"

#include <cdr/image/codec.h>

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
using Files = FolderTest;
using Notes = FolderTest;
using Driver = FolderTest;

/// A glTF file of which something is not drawn.
void writeNotedModel(const fs::path& path) {
    json model = json::parse(readText(CDR_SOURCE_DIR "/tests/golden/shapes.gltf"));
    model["extensionsUsed"].push_back("KHR_nobody_has_this");
    std::ofstream(path) << model.dump();
}

TEST_F(Files, AnOutputNeverReplacesTheInput) {
    writeNotedModel(at("in.gltf"));
    fs::create_symlink("in.gltf", at("link.json"));
    fs::create_hard_link(at("in.gltf"), at("other.json"));
    const std::string before = textIn("in.gltf");
    for (const char* arguments :
         {"render in.gltf --json link.json", "render in.gltf --json other.json",
          "render in.gltf --trace in.gltf", "pictures --scenes in.gltf --json link.json",
          "detail in.gltf --json link.json", "render cubes --path in.gltf --json link.json",
          "inspect cubes --path in.gltf --json link.json", "shadows alley --path in.gltf --json link.json"}) {
        expectRefusal(arguments, "would replace what the command reads");
        EXPECT_EQ(textIn("in.gltf"), before) << arguments;
    }
}

/// As it would where --json takes the first of two models for its file.
TEST_F(Files, ABareJsonNeverReplacesAModel) {
    writeNotedModel(at("in.gltf"));
    const std::string before = textIn("in.gltf");
    expectRefusal("models --json in.gltf in.gltf", "write --json=FILE, or --json last");
    EXPECT_EQ(textIn("in.gltf"), before);
}

/// Which has no numbers beyond 2^32 - 1.
TEST_F(Files, NoOutputIsTheLastPictureThatThereMayBe) {
    expectRefusal("render cubes --size 16x16 --frame 4294967294 --frames 2 -o f%d.png --json f4294967295.png",
                  "both --json and -o");
    EXPECT_TRUE(folderIsEmpty());
}

/// Which comes with the first picture.
TEST_F(Files, AFolderOfPicturesMayHoldOtherOutputsBeforeItIsThere) {
    succeed("pictures --scenes cubes --techniques log --frames 1 --size 16x16 --json out/p.json");
    EXPECT_EQ(jsonIn("out/p.json")["command"], "pictures");
    succeed("effects --frames 1 --size 16x16 --out a/b --json ./a/../a/b/e.json");
    EXPECT_EQ(jsonIn("a/b/e.json")["command"], "effects");
}

/// Whether the files are there already or not.
TEST_F(Files, NoOutputIsALaterPictureOfASequence) {
    fs::create_directory(at("d"));
    const std::string frames = "--quiet render cubes --size 16x16 --frames 3 -o d/f%d.png ";
    for (const bool isThere : {false, true}) {
        for (const char* other : {"--trace d/f1.png", "--json d/f2.png", "--state ./d/../d/f2.png"}) {
            if (isThere) {
                std::ofstream(at("d/f1.png")) << "x";
                std::ofstream(at("d/f2.png")) << "x";
            }
            expectRefusal(frames + other, "would write it");
            EXPECT_FALSE(fs::exists(at("d/f0.png"))) << other;
        }
    }
    succeed(frames + "--trace d/f3.png");
}

/// Its buffers and pictures too, and by any picture of a sequence.
TEST_F(Files, AnOutputNeverReplacesWhatAModelIsMadeOf) {
    json model = json::parse(readText(CDR_SOURCE_DIR "/tests/golden/shapes.gltf"));
    image::writeImage(at("t_0003.png"), image::ImageRgba8(4, 4, {200, 100, 50, 255}));
    model["images"] = {{{"uri", "t_0003.png"}}};
    model["textures"] = {{{"source", 0}}};
    model["materials"][0]["emissiveTexture"] = {{"index", 0}};
    std::ofstream(at("m.gltf")) << model.dump();
    const std::string before = textIn("t_0003.png");
    for (const char* arguments :
         {"render m.gltf --size 8x8 -o t_0003.png", "render m.gltf --size 8x8 -o t_%04d.png --frames 4",
          "render m.gltf --size 8x8 --json t_0003.png",
          "pictures --scenes m.gltf --size 8x8 --json t_0003.png"}) {
        expectRefusal(arguments, "would replace what the command reads");
        EXPECT_EQ(textIn("t_0003.png"), before) << arguments;
    }
    EXPECT_FALSE(fs::exists(at("t_0000.png")));
    for (const char* arguments :
         {"render m.gltf --size 8x8 -o t_%04d.png --frames 3", "models m.gltf --size 8x8 --out .",
          "pictures --scenes m.gltf --techniques log --size 8x8 --out .",
          "detail m.gltf --frames 1 --size 32x18 --out .", "effects m.gltf --frames 1 --size 32x18 --out .",
          "focus m.gltf --frames 1 --cameras 1 --size 32x18 --out ."}) {
        succeed(arguments);
        EXPECT_EQ(textIn("t_0003.png"), before) << arguments;
    }
}

/// By a link, a hard link or a way around, and where none of the files is there yet.
TEST_F(Files, NoTwoOutputsAreNamesOfOneFile) {
    fs::create_directory(at("d"));
    fs::create_directory_symlink("d", at("linked"));
    std::ofstream(at("a.json")) << "x";
    fs::create_symlink("a.json", at("link.json"));
    fs::create_hard_link(at("a.json"), at("hard.json"));
    for (const char* outputs :
         {"--trace a.json --json link.json", "--trace hard.json --json a.json",
          "--trace link.json --json hard.json", "--trace d/../a.json --json hard.json",
          "--trace new.json --json d/../new.json", "--trace d/n.json --json linked/n.json"}) {
        expectRefusal(std::string("render cubes --size 8x8 ") + outputs, "would write it");
    }
    EXPECT_EQ(textIn("a.json"), "x");
}

/// A model that has only these pictures.
void writePictureModel(const fs::path& path, const std::vector<std::string>& names) {
    json images = json::array();
    for (const std::string& name : names) {
        images.push_back({{"uri", name}});
    }
    std::ofstream(path) << json{{"asset", {{"version", "2.0"}}}, {"images", images}};
}

/// By its name or by another one.
TEST_F(Files, NoPictureInAFolderReplacesWhatAModelIsMadeOf) {
    struct Written {
        std::string command{};
        std::string picture{};
    };
    std::ofstream(at("hard.png")) << "x";
    std::ofstream(at("soft.png")) << "x";
    fs::create_directories(at("d/e"));
    for (const Written& each :
         {Written{"models m.gltf", "m.png"}, Written{"pictures --scenes m.gltf", "m_log.png"},
          Written{"detail m.gltf", "none-again.png"}, Written{"detail m.gltf", "object_cracks.png"},
          Written{"effects m.gltf", "occlusion-layers.png"}, Written{"focus m.gltf", "cameras.png"},
          Written{"focus m.gltf", "focus-blend.png"}, Written{"translucency m.gltf", "truth.png"},
          Written{"translucency m.gltf", "sorted_2_error.png"},
          Written{"shadows m.gltf", "anchored_anchored_0_0.png"},
          Written{"shadows m.gltf", "anchored_anchored_12_3_wrong.png"}}) {
        std::ofstream(at(each.picture)) << "x";
        fs::create_hard_link(at("hard.png"), at("d") / each.picture);
        fs::create_symlink("../../soft.png", at("d/e") / each.picture);
        writePictureModel(at("m.gltf"), {each.picture, "hard.png", "soft.png"});
        for (const char* out : {" --out .", " --out d", " --out d/e"}) {
            expectRefusal(each.command + out, each.picture + ": --out would replace what the command reads");
        }
        fs::remove(at("d") / each.picture);
        fs::remove(at("d/e") / each.picture);
        EXPECT_EQ(textIn(each.picture) + textIn("hard.png") + textIn("soft.png"), "xxx") << each.command;
    }
}

TEST_F(Files, OtherPicturesInAFolderAreLeftAlone) {
    const std::vector<std::string> names{"truth_0.png", "sorted_9.png", "anchored_anchored_0_0_old.png",
                                         "anchored_plain_0_0.png"};
    for (const std::string& name : names) {
        std::ofstream(at(name)) << "x";
    }
    writePictureModel(at("m.gltf"), names); // which has nothing to draw
    const ProgramResult translucency = run("translucency m.gltf --size 16x16 --out .");
    expectOneLine(translucency, 2, "m: the scene has no translucent surfaces");
    const ProgramResult shadows = run("shadows m.gltf --size 16x16 --out .");
    EXPECT_EQ(shadows.status, 0);
    EXPECT_EQ(shadows.err, "");
    for (const ProgramResult& result : {translucency, shadows}) {
        EXPECT_TRUE(result.out.starts_with("m.gltf: ignored: the scene: nothing of it is drawn\n"))
            << result.out;
    }
    for (const std::string& name : names) {
        EXPECT_EQ(textIn(name), "x") << name;
    }
}

TEST_F(Files, NoOutputIsAFileInTheFolderOfAnother) {
    fs::create_directories(at("v/log"));
    for (const char* file : {"v/standard_cdr.png", "v/standard_cdr.mp4", "v/log/../log_logcdr.png"}) {
        expectRefusal(std::string("flicker --frames 1 --size 16x16 --videos v --json ") + file,
                      "both --videos and --json would write it");
    }
    expectRefusal("flicker --frames 1 --size 16x16 --tga v --json v/log/0000.tga",
                  "both --tga and --json would write it");
    expectRefusal("coplanar --frames 1 --size 16x16 --out v --json v/anchored_polygon_offset.png",
                  "both --out and --json would write it");
    succeed("coplanar --frames 1 --search-views 1 --size 16x16 --techniques log "
            "--slopes 0 --constants 0 --out v --json v/cdr_none.png");
    fs::create_directory(at("elsewhere"));
    std::ofstream(at("elsewhere/y")) << "y";
    fs::create_directory(at("out"));
    fs::create_symlink("../elsewhere/y", at("out/x")); // a folder's name comes from none of its files
    for (const char* out : {"out", "out/", "./out/."}) {
        expectRefusal(std::string("effects --frames 1 --size 16x16 --json out/plain.png --out ") + out,
                      "both --out and --json would write it");
    }
}

TEST_F(Files, NoPictureOfASequenceIsAnotherNameOfWhatAModelIsMadeOf) {
    fs::create_directory(at("d"));
    fs::create_directory_symlink("d", at("linked"));
    std::ofstream(at("t.png")) << "x";
    writePictureModel(at("m.gltf"), {"none.png", "t.png"});
    fs::create_symlink("../t.png", at("d/soft1.png"));
    fs::create_hard_link(at("t.png"), at("d/hard2.png"));
    for (const char* name : {"d/soft%d.png", "d/hard%d.png", "linked/hard%d.png", "d/../d/soft%d.png"}) {
        expectRefusal(std::string("render m.gltf --size 8x8 --frames 3 -o ") + name,
                      "-o would replace what the command reads");
    }
    EXPECT_EQ(textIn("t.png"), "x");
}

/// To compare each with each would take many minutes.
TEST_F(Files, ManyOfAModelAndASequenceAreCheckedInSecondsOfAProcessor) {
    for (int frame = 0; frame < 1000; ++frame) {
        std::ofstream(folder() / ("f" + std::to_string(frame) + ".png")) << "x";
    }
    std::vector<std::string> pictures;
    for (int picture = 0; picture < 600; ++picture) {
        pictures.push_back("t" + std::to_string(picture) + ".png");
    }
    pictures.push_back("f999.png");
    writePictureModel(at("m.gltf"), pictures);
    expectRefusal("render m.gltf --size 8x8 --frames 1000 -o f%d.png",
                  "f999.png: -o would replace what the command reads", "ulimit -t 20 &&");
}

TEST_F(Files, ScenesOfOneNameAreRefused) {
    for (const char* name : {"a", "b"}) {
        fs::create_directory(at(name));
        writeNotedModel(at(name) / "m.gltf");
    }
    const ProgramResult result = run("--quiet pictures --scenes a/m.gltf,b/m.gltf");
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("a/m.gltf and b/m.gltf would both be written as m_*.png"), std::string::npos)
        << result.err; // after what is not drawn of each
    EXPECT_FALSE(fs::exists(at("out")));
}

/// Every command that opens a file takes the budget, in front of the command or behind it.
TEST_F(Files, ABudgetShrinksTexturesAndSaysSo) {
    json model = json::parse(readText(CDR_SOURCE_DIR "/tests/golden/shapes.gltf"));
    image::writeImage(at("large.png"), image::ImageRgba8(600, 600, {200, 100, 50, 255}));
    model["images"] = {{{"uri", "large.png"}}};
    model["textures"] = {{{"source", 0}}};
    for (json& material : model["materials"]) {
        material["emissiveTexture"] = {{"index", 0}};
        material["emissiveFactor"] = {1, 1, 1}; // else the texture is not used
    }
    std::ofstream(at("m.gltf")) << model.dump();
    fs::create_directory(at("maps")); // of an Earth without relief
    image::writeImage(at("maps/earth-topology.png"), image::ImageRgba8(8, 4, {0, 0, 0, 255}));
    fs::copy(at("maps/earth-topology.png"), at("maps/earth-blue-marble.jpg"));
    const std::string said = "shown smaller than it is, so that all textures fit in 1 MiB";
    for (const char* arguments : {"render m.gltf --size 16x16 --texture-memory 1 -o a.png",
                                  "--texture-memory 1 render m.gltf --size 16x16 -o b.png",
                                  "inspect m.gltf --size 16x16 --texture-memory 1",
                                  "effects m.gltf --frames 1 --size 16x16 --texture-memory 1",
                                  "orbit --data maps --model m.gltf --frames 1 --techniques log --size 16x16 "
                                  "--texture-memory 1",
                                  "render orbit --size 16x16 --texture-memory 1 -o d.png"}) {
        const ProgramResult result = succeed(arguments, "CDR_ORBIT_DATA=maps CDR_ORBIT_MODEL=m.gltf");
        EXPECT_NE(result.out.find(said), std::string::npos) << arguments << result.out;
    }
    const ProgramResult whole = succeed("render m.gltf --size 16x16 -o c.png");
    EXPECT_EQ(whole.out.find("shown smaller"), std::string::npos) << whole.out;
}

/// In front of a command or behind it, and whatever command opens the file.
TEST_F(Files, ARadiusOfPointsChangesThePicture) {
    const std::string survey = CDR_SOURCE_DIR "/tests/assets/survey.glb --camera 0 --size 64x36 ";
    const std::vector<std::string> lines{"render " + survey + "-o plain.png",
                                         "render " + survey + "--points 0.2 -o behind.png",
                                         "--points 0.2 render " + survey + "-o before.png",
                                         "models " + survey + "--out plain",
                                         "models " + survey + "--points 0.2 --out thick",
                                         "render sheets --size 64x36 --points 0.2 -o sheets.png"};
    for (const std::string& arguments : lines) {
        succeed(arguments);
    }
    EXPECT_NE(textIn("plain.png"), textIn("behind.png"));
    EXPECT_EQ(textIn("before.png"), textIn("behind.png"));
    EXPECT_NE(textIn("plain/survey.png"), textIn("thick/survey.png"));
}

TEST_F(Files, DevicesTakeSeveralOutputs) {
    succeed("precision --json /dev/null --curve /dev/null");
}

class NotesTest : public FolderTest, public testing::WithParamInterface<const char*> {};

/// A command prints what of a file is not drawn, also with --quiet, and JSON has it.
TEST_P(NotesTest, AreSaidEverywhere) {
    writeNotedModel(at("m.gltf"));
    const std::string arguments = std::string(GetParam()) + " --size 32x18 --json r.json";
    const ProgramResult loud = succeed(arguments);
    EXPECT_NE(loud.out.find("m.gltf: ignored: KHR_nobody_has_this: extension not used"), std::string::npos)
        << loud.out;
    const json document = jsonIn("r.json");
    const json& notes = document.at("notes");
    EXPECT_NE(std::find(notes.begin(), notes.end(), "KHR_nobody_has_this: extension not used"), notes.end());
    EXPECT_EQ(document.at("noted_files"), json(std::vector<std::string>(notes.size(), "m.gltf")));
    const ProgramResult quiet = run("--quiet " + arguments);
    EXPECT_EQ(quiet.out, "");
    EXPECT_NE(quiet.err.find("ignored: KHR_nobody_has_this: extension not used"), std::string::npos)
        << quiet.err;
}

INSTANTIATE_TEST_SUITE_P(Commands, NotesTest,
                         testing::Values("render m.gltf",
                                         "pictures --scenes m.gltf --frames 1 --techniques log",
                                         "detail m.gltf --frames 1", "effects m.gltf --frames 1",
                                         "focus m.gltf --frames 1 --cameras 1"));

/// Of several files, each note says its own.
TEST_F(Notes, SayWhichFileTheyAreAbout) {
    for (const char* name : {"first.gltf", "second.gltf"}) {
        writeNotedModel(at(name));
    }
    fs::copy_file(CDR_SOURCE_DIR "/tests/golden/shapes.gltf", at("whole.gltf"));
    for (const char* arguments :
         {"models first.gltf whole.gltf second.gltf",
          "pictures --scenes first.gltf,whole.gltf,second.gltf --frames 1 --techniques log"}) {
        const ProgramResult result = succeed(arguments + std::string(" --size 16x16 --json r.json"));
        const json document = jsonIn("r.json");
        ASSERT_EQ(document.at("notes").size(), document.at("noted_files").size()) << arguments;
        const json& files = document["noted_files"];
        for (const char* name : {"first.gltf", "second.gltf"}) {
            EXPECT_NE(result.out.find(std::string(name) + ": ignored: KHR_nobody"), std::string::npos)
                << result.out;
            EXPECT_EQ(std::count(files.begin(), files.end(), name) * 2, std::ssize(files)) << files;
        }
    }
}

TEST_F(Notes, AreAnEmptyListWhereAllIsDrawn) {
    const json document = documentOf("render cubes --size 32x18");
    EXPECT_EQ(document.at("notes"), json::array());
    EXPECT_EQ(document.at("noted_files"), json::array());
}

TEST_F(Driver, AMissingOneIsNamedWithItsPackage) {
    for (const char* arguments : {"render cubes", "devices"}) {
        SCOPED_TRACE(arguments);
        expectOneLine(run(arguments, "VK_DRIVER_FILES=/nowhere VK_ICD_FILENAMES=/nowhere"), 1,
                      "mesa-vulkan-drivers");
    }
}

/// Names of files may hold any byte.
TEST_F(Files, NotesAndTablesHaveANameOnOneLine) {
    writeNotedModel(at("a\nb.gltf"));
    const ProgramResult result = succeed("render 'a\nb.gltf' --size 16x16 -o a.png");
    EXPECT_NE(result.out.find("a b.gltf: ignored: "), std::string::npos) << result.out;
    const ProgramResult table = succeed("models 'a\nb.gltf' --size 16x16");
    EXPECT_NE(table.out.find("\na b  "), std::string::npos) << table.out;
}

TEST_F(Files, WhatIsMissingForASpecialFileIsNamedWithIt) {
    const ProgramResult result = run("precision --json /dev/stdout", "TMPDIR=/nosuch");
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.err, "cdr: /dev/stdout: cannot be written, the folder for temporary files is missing\n");
}

TEST_F(Files, AFolderThatIsGoneIsNoPlaceForAReport) {
    for (const char* arguments : {"report --smallest --sections precision -o x", "shadows cubes --out x"}) {
        fs::create_directory(at("gone"));
        const ProgramResult result = run(arguments, "cd gone && rmdir ../gone &&");
        expectOneLine(result, 2);
        EXPECT_TRUE(result.err.starts_with("cdr: x: cannot be ")) << result.err;
        EXPECT_EQ(result.err.find(" is no folder"), std::string::npos) << result.err;
    }
}

} // namespace

} // namespace cdr::cli_test
