#include "planted_gltf.h"
#include "program.h"

#include <cdr/base/quantity_text.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace cdr::cli_test {

namespace {

using nlohmann::json;

const PlantedSquare kWall{"wall", {0.3, 0.0, -30.1}, 20.0};
const PlantedSquare kBoard{"board", {-3.0, 0.0, -20.0}, 3.0};

struct InspectRun {
    int status = -1;
    json document;
    std::string out;
};

/// The names of the pairs that something was found of.
std::vector<std::string> findings(const json& document) {
    std::vector<std::string> found;
    for (const json& pair : document.at("pairs")) {
        if (pair.at("finding") != "") {
            found.push_back(pair.at("finding").get<std::string>() + " " +
                            pair.at("front").get<std::string>() + " " + pair.at("back").get<std::string>());
        }
    }
    return found;
}

const json& rowOf(const json& document, const std::string& technique, const std::string& format) {
    const json& rows = document.at("results");
    return *std::find_if(rows.begin(), rows.end(), [&](const json& row) {
        return row.at("technique") == technique && row.at("format") == format;
    });
}

bool isSaid(const json& document, const std::string& words) {
    const json& lines = document.at("advice");
    return std::any_of(lines.begin(), lines.end(), [&](const json& line) {
        return line.get<std::string>().find(words) != std::string::npos;
    });
}

/// The sentences put together again from their parts.
json joined(const json& allParts) {
    json lines = json::array();
    for (const json& parts : allParts) {
        std::string line;
        for (const json& part : parts) {
            line += part.is_string() ? part.get<std::string>()
                                     : base::quantityText(part.get<double>(), base::NumberStyle::plain);
        }
        lines.push_back(line);
    }
    return lines;
}

class InspectCommand : public FolderTest {
  protected:
    InspectRun inspect(const std::string& arguments) const {
        const ProgramResult result = run("inspect " + arguments + " --json a.json");
        EXPECT_TRUE(result.status == 0 || result.status == 3) << result.err;
        return {.status = result.status, .document = jsonIn("a.json"), .out = result.out};
    }

    /// Through a camera of the file's own.
    InspectRun inspectFile(const std::string& file, const std::string& options = "") const {
        return inspect(file + " --camera 0 --size 320x180 " + options);
    }
    InspectRun inspectSquares(const std::vector<PlantedSquare>& squares,
                              const std::string& options = "") const {
        writeSquares(at("a.gltf"), squares);
        return inspectFile("a.gltf", options);
    }

    /// No pair, and no pixel of anchored depth.
    static void expectNothingFound(const InspectRun& run) {
        EXPECT_EQ(run.status, 0);
        EXPECT_EQ(findings(run.document), std::vector<std::string>());
        EXPECT_EQ(run.document.at("coplanar_fraction"), 0.0);
        EXPECT_EQ(rowOf(run.document, "anchored", "d32f").at("wrong"), 0);
    }
};

TEST_F(InspectCommand, FindsNothingWhereNothingIsWrong) {
    const InspectRun run =
        inspectSquares({{"wall", {0.0, 0.0, -30.0}, 20.0}, {"sign", {1.0, 1.0, -29.5}, 4.0}, kBoard},
                       "--fail-above 0 --technique anchored");
    expectNothingFound(run);
    EXPECT_EQ(run.document.at("fails"), false);
    EXPECT_EQ(rowOf(run.document, "reversed", "d32f").at("wrong"), 0);
    EXPECT_TRUE(isSaid(run.document, "no pixels are wrong"));
    EXPECT_EQ(joined(run.document.at("advice_parts")), run.document.at("advice"));
    EXPECT_TRUE(run.document.at("advice_parts").back().at(1).is_number());
    EXPECT_TRUE(isSaid(run.document, "'sign' lies in front of 'wall' by 0.5"));
}

TEST_F(InspectCommand, NamesACoplanarPairAndItsRemedy) {
    const InspectRun run = inspectSquares({kWall, {"poster", {1.7, 1.1, -30.1}, 4.0}, kBoard},
                                          "--fail-above 0.01 --heat-map H.PNG");
    EXPECT_EQ(run.status, 3);
    EXPECT_EQ(run.document.at("fails"), true);
    EXPECT_EQ(findings(run.document), (std::vector<std::string>{"coplanar wall poster"}));
    EXPECT_GT(run.document.at("coplanar_fraction"), 0.01);
    EXPECT_EQ(rowOf(run.document, "anchored", "d32f").at("wrong"), 0) << "coplanar pixels are not wrong";
    EXPECT_TRUE(isSaid(run.document, "'wall' and 'poster' lie in one plane"));
    const std::string advice = run.document.at("advice").dump();
    EXPECT_TRUE(std::regex_search(
        advice,
        std::regex("Remove one, move it by more than [0-9.e-]+ for reversed or [0-9.e-]+ for anchored, or "
                   "give it a layer of that size")))
        << advice;
    const auto picture = readPicture(at("H.PNG")).pixels;
    EXPECT_GT(std::count(picture.begin(), picture.end(), image::Rgba8{255, 0, 255, 255}), 100);
}

/// Vertices of a wide wall are rounded by more than depths.
TEST_F(InspectCommand, FindsNothingWhereAFaceMovedByMoreThanItNames) {
    const auto inspectAt = [&](double z) {
        return inspectSquares({{"wall", {0.3, 0.0, -30.1}, 3000.0}, {"poster", {1.7, 1.1, z}, 8.0}, kBoard});
    };
    const std::string line = inspectAt(-30.1).document.at("advice").at(1);
    std::smatch named;
    ASSERT_TRUE(
        std::regex_search(line, named, std::regex("more than ([0-9.e-]+) for reversed or ([0-9.e-]+) for")))
        << line;
    for (const std::string& apart : {named[1].str(), named[2].str()}) {
        const InspectRun run = inspectAt(-30.1 + 1.001 * std::stod(apart));
        EXPECT_EQ(findings(run.document), std::vector<std::string>()) << apart;
        EXPECT_EQ(rowOf(run.document, "anchored", "d32f").at("wrong"), 0) << apart;
        EXPECT_EQ(rowOf(run.document, "reversed", "d32f").at("wrong"), 0) << apart;
    }
}

/// The remedy that it names.
TEST_F(InspectCommand, FindsNothingWhereALayerSaysWhichIsSeen) {
    expectNothingFound(inspectSquares({kWall, {"poster@layer=0.01", {1.7, 1.1, -30.1}, 4.0}, kBoard},
                                      "--fail-above 0.01 --technique anchored"));
}

/// A pixel is 0.1 wide there.
TEST_F(InspectCommand, NamesCoplanarFacesNarrowerThanThreePixels) {
    std::vector<PlantedSquare> squares{kWall};
    for (int i = 0; i < 8; ++i) {
        squares.push_back({"dot" + std::to_string(i), {0.71 * i - 2.9, 0.3, -30.1}, 0.15});
    }
    const InspectRun run = inspectSquares(squares);
    EXPECT_GT(run.document.at("coplanar_fraction"), 0.0);
    ASSERT_FALSE(findings(run.document).empty());
    EXPECT_EQ(findings(run.document).front().substr(0, 17), "coplanar wall dot");
    EXPECT_TRUE(isSaid(run.document, " in one plane, ")) << run.out;
}

/// A masked material that keeps all, or nothing, of what it covers.
json maskOf(double alpha) {
    return {{"alphaMode", "MASK"}, {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.5, 0.5, alpha}}}}};
}

TEST_F(InspectCommand, WhatAMaskCutsAwayIsNeitherWrongNorCoplanar) {
    for (const double z : {-30.1, -29.6}) {
        SCOPED_TRACE(z);
        expectNothingFound(inspectSquares({kWall, {"poster", {1.7, 1.1, z}, 4.0, maskOf(0.1)}, kBoard},
                                          "--fail-above 0 --technique anchored"));
    }
}

TEST_F(InspectCommand, WhatAMaskKeepsIsFound) {
    const InspectRun run =
        inspectSquares({kWall, {"poster", {1.7, 1.1, -30.1}, 4.0, maskOf(1.0)}, kBoard}, "--fail-above 0.01");
    EXPECT_EQ(run.status, 3);
    EXPECT_EQ(findings(run.document), (std::vector<std::string>{"coplanar wall poster"}));
}

/// Most decals blend. Depth does not say whether they are laid over the wall.
TEST_F(InspectCommand, FindsABlendedDecalInThePlaneOfItsWall) {
    const json decal{{"alphaMode", "BLEND"},
                     {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.5, 0.5, 0.5}}}}};
    const auto inspectAt = [&](double z, const std::string& name) {
        return inspectSquares({kWall, {name, {1.7, 1.1, z}, 4.0, decal}, kBoard},
                              "--fail-above 0.01 --technique anchored --heat-map H.png");
    };
    const InspectRun run = inspectAt(-30.1, "poster");
    EXPECT_EQ(run.status, 3);
    EXPECT_EQ(findings(run.document), (std::vector<std::string>{"coplanar wall poster"}));
    EXPECT_EQ(rowOf(run.document, "anchored", "d32f").at("wrong"), 0);
    const auto picture = readPicture(at("H.png")).pixels;
    EXPECT_GT(std::count(picture.begin(), picture.end(), image::Rgba8{255, 0, 255, 255}), 100);
    // Before the wall, and with a layer offset.
    EXPECT_EQ(findings(inspectAt(-30.09, "poster").document), std::vector<std::string>());
    EXPECT_EQ(findings(inspectAt(-30.1, "poster@layer=0.01").document), std::vector<std::string>());
}

/// A mesh with a primitive for each material, as modelling programs write it.
TEST_F(InspectCommand, PartsOfAMeshAreComparedWithEachOther) {
    writeSquares(at("a.gltf"), {{"house", {0.3, 0.0, -30.1}, 8.0, {{"name", "wall"}}},
                                {"sign", {0.0, 0.0, 5.0}, 1.0, {{"name", "paint"}}},
                                kBoard});
    json document = jsonIn("a.gltf");
    json& meshes = document["meshes"];
    meshes[1]["primitives"].push_back(meshes[2]["primitives"][0]);
    std::ofstream(at("a.gltf")) << document;
    const InspectRun run = inspectFile("a.gltf", "--fail-above 0.01");
    EXPECT_EQ(run.status, 3);
    EXPECT_EQ(findings(run.document), (std::vector<std::string>{"coplanar house / wall house / paint"}));
}

/// A pond, leaves that are cut out of their squares, nodes that mirror.
TEST_F(InspectCommand, FindsNothingWrongInAGardenOfMasks) {
    const std::string garden = "'" + std::string(CDR_SOURCE_DIR) + "/tests/assets/garden.glb'";
    const InspectRun run =
        inspectFile(garden, "--techniques reversed,anchored --technique anchored --fail-above 0.001");
    EXPECT_EQ(run.status, 0);
    for (const char* technique : {"reversed", "anchored"}) {
        const json& row = rowOf(run.document, technique, "d32f");
        EXPECT_GT(row.at("pixels"), 20'000) << technique;
        EXPECT_LE(row.at("wrong"), 1) << technique;
    }
}

TEST_F(InspectCommand, FindsANearPairFarAwayAndWhatSuffices) {
    constexpr double kGap = 3e-5; // at 3000: 1e-8 of the distance, finer than reversed depth
    const InspectRun run = inspectSquares(
        {{"road", {5.0, 0.0, -3000.0 + kGap}, 25.0}, {"hill", {0.0, 0.0, -3000.0}, 60.0}, kBoard},
        "--fov 3 --fail-above 0.01");
    EXPECT_EQ(run.status, 3);
    EXPECT_EQ(findings(run.document), std::vector<std::string>()) << "anchored depth tells them apart";
    const json& pair = run.document.at("pairs").at(0);
    EXPECT_EQ(pair.at("front"), "road");
    EXPECT_EQ(pair.at("back"), "hill");
    EXPECT_NEAR(pair.at("gap").get<double>(), kGap, 0.05 * kGap);
    EXPECT_NEAR(pair.at("at").get<double>(), 3000.0, 1.0);
    const json& reversed = rowOf(run.document, "reversed", "d32f");
    EXPECT_GT(reversed.at("wrong_fraction"), 0.05);
    EXPECT_GT(reversed.at("predicted_fraction"), 0.05);
    const json& anchored = rowOf(run.document, "anchored", "d32f");
    EXPECT_EQ(anchored.at("wrong"), 0);
    EXPECT_LT(anchored.at("predicted_fraction"), 1e-3);
    EXPECT_EQ(run.document.at("simplest").at("technique"), "anchored");
    EXPECT_EQ(inspectFile("a.gltf", "--fov 3 --fail-above 0.01 --technique anchored").status, 0);
}

/// Wrong pixels off planes and those in planes are shares of one total, so all of them together are at most all.
TEST_F(InspectCommand, AddsSharesOfOneTotal) {
    const InspectRun run = inspectSquares({{"wall", {-5.2, 0.0, -20.1}, 10.0},
                                           {"poster", {-5.2, 0.0, -20.1}, 9.9},
                                           {"road", {0.0, 0.0, -3000.0 + 3e-5}, 40.0},
                                           {"hill", {0.0, 0.0, -3000.0}, 60.0}},
                                          "--fov 3 --techniques reversed --format d16 --fail-above 1");
    const double wrong = rowOf(run.document, "reversed", "d16").at("wrong_fraction");
    EXPECT_GT(wrong + run.document.at("coplanar_fraction").get<double>(), 1.0) << "of what is judged, of all";
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.out.find("reversed with d16: of the object pixels, "), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("Other pixels at edges are not judged and count as right.\n"), std::string::npos)
        << run.out;
}

/// Of its inner pixels alone a quarter is wrong.
TEST_F(InspectCommand, TheVerdictIsOfObjectPixelsAsTheStatusIs) {
    const std::string standard =
        "afc --techniques standard --technique standard --frames 2 --size 320x180 --fail-above ";
    const InspectRun wide = inspect(standard + "0.2");
    EXPECT_GT(rowOf(wide.document, "standard", "d32f").at("wrong_fraction"), 0.2);
    EXPECT_EQ(wide.status, 0);
    EXPECT_TRUE(isSaid(wide.document, " is the simplest technique that is enough"));
    const InspectRun narrow = inspect(standard + "0.1");
    EXPECT_EQ(narrow.status, 0);
    EXPECT_TRUE(isSaid(narrow.document, "No technique is enough"));
    EXPECT_TRUE(isSaid(narrow.document, " object pixels wrong"));
    EXPECT_TRUE(isSaid(narrow.document, "but depth does not decide the order of ")) << narrow.out;
}

/// The order of drawing may hide that the depth buffer stores one number for both.
TEST_F(InspectCommand, LuckDoesNotSuffice) {
    const InspectRun run = inspectSquares(
        {{"hill", {0.0, 0.0, -3000.0}, 60.0}, {"road", {5.0, 0.0, -3000.0 + 3e-5}, 25.0}}, "--fov 3");
    EXPECT_EQ(rowOf(run.document, "standard", "d32f").at("wrong"), 0);
    EXPECT_GT(rowOf(run.document, "standard", "d32f").at("undecided_fraction"), 0.05);
    EXPECT_EQ(run.document.at("simplest").at("technique"), "anchored");
}

TEST_F(InspectCommand, FindsADecalThatSank) {
    const InspectRun run = inspectSquares({{"wall", {0.0, 0.0, -30.0}, 20.0},
                                           {"decal", {1.0, 1.0, -30.001}, 4.0},
                                           {"box", {-3.0, 0.0, -40.0}, 3.0}}); // hidden, and rightly so
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(findings(run.document), (std::vector<std::string>{"sunk wall decal"}));
    EXPECT_TRUE(isSaid(run.document, "'decal' lies behind 'wall' by 0.001, and no view shows it"));
}

/// Cubes that lie whole behind others, as solid things do, are no decals that sank.
TEST_F(InspectCommand, CallsNothingSunkInMixed) {
    const InspectRun run = inspect("mixed --size 320x180");
    EXPECT_GT(run.document.at("pairs_found"), 20);
    EXPECT_EQ(findings(run.document), std::vector<std::string>());
    EXPECT_FALSE(isSaid(run.document, "no view shows it"));
}

TEST_F(InspectCommand, FormulasAndPicturesAgreeOnGeneratedScenes) {
    const InspectRun run = inspect("afc --frames 2 --size 320x180");
    EXPECT_EQ(findings(run.document), std::vector<std::string>());
    for (const char* technique : {"log", "logcdr", "reversed"}) {
        const json& row = rowOf(run.document, technique, "d32f");
        const double predicted = row.at("predicted_fraction");
        const double measured = row.at("wrong_fraction");
        EXPECT_LT(std::abs(predicted - measured), 0.01 + 0.5 * measured)
            << technique << " " << predicted << " " << measured;
    }
    EXPECT_EQ(run.document.at("simplest").at("technique"), "anchored");
}

TEST_F(InspectCommand, LooksAtAFileFromAllSides) {
    // Seen from +z the poster lies before the wall; from behind neither shows, since both are single-sided.
    writeSquares(at("a.gltf"), {{"wall", {0.0, 0.0, -30.0}, 20.0}, {"poster", {1.0, 1.0, -29.9}, 4.0}});
    const InspectRun run = inspect("a.gltf --frames 6 --size 160x90");
    EXPECT_EQ(run.document.at("options").at("views"), 6);
    EXPECT_EQ(run.document.at("pairs_found"), 1);
    for (const char* bad : {"inspect a.gltf --fail-above 2", "inspect a.gltf --heat-map a.jpg",
                            "inspect a.gltf --technique none", "inspect nosuch"}) {
        expectRefusal(bad);
    }
}

/// A picture without surfaces tells nothing of a technique.
TEST_F(InspectCommand, JudgesNothingByAnEmptyView) {
    const std::string away =
        "inspect cubes --eye 0,0,0 --direction 0,-1,0 --near 0.1 --far 1 --size 64x36 --json a.json";
    succeed(away);
    const json document = jsonIn("a.json");
    EXPECT_TRUE(document.at("simplest").is_null());
    for (const char* share : {"predicted_fraction", "undecided_fraction", "wrong_fraction"}) {
        EXPECT_TRUE(document.at("results")[0].at(share).is_null()) << share;
    }
    EXPECT_TRUE(document.at("coplanar_fraction").is_null());
    EXPECT_TRUE(isSaid(document, "No technique could be judged"));
    EXPECT_EQ(run(away + " --fail-above 0.5").status, 3);
}

TEST_F(InspectCommand, SaysHowMuchMemoryAPictureNeeds) {
    if (std::string(CDR_FILE_FAULTS).empty()) {
        GTEST_SKIP() << "sanitizers take more addresses than the limit";
    }
    expectOneLine(run("inspect cubes --size 16384x16384", "ulimit -v 4000000 && "), 1,
                  "the truth of 16384x16384 pixels needs 8192.0 MiB of memory, ");
}

} // namespace

} // namespace cdr::cli_test
