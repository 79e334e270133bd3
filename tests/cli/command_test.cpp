#include "program.h"

#include <cdr/base/quantity_text.h>
#include <cdr/image/codec.h>
#include <cdr/platform/file.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <utility>

namespace cdr::cli_test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Commands = FolderTest;
using RenderTable = FolderTest;

/// What the device has of the formats with 24 bits and more.
std::string fineFormats() {
    return hasD24() ? "d24,d32f" : "d32f";
}

void expectEnvelope(const json& document, const std::string& command) {
    EXPECT_EQ(document.at("command"), command);
    EXPECT_TRUE(document.at("version").is_string());
    EXPECT_TRUE(document.at("commit").is_string());
    EXPECT_TRUE(document.at("device").contains("driver"));
    EXPECT_GE(document.at("host").at("cpus"), 1);
    EXPECT_TRUE(document.at("options").is_object());
    EXPECT_TRUE(document.at("results").is_array());
}

TEST_F(Commands, DevicesListsAUsableOne) {
    const ProgramResult result = succeed("devices --json d.json");
    const json document = jsonIn("d.json");
    expectEnvelope(document, "devices");
    ASSERT_FALSE(document["results"].empty());
    EXPECT_NE(result.out.find(document["results"][0]["name"].get<std::string>()), std::string::npos);
    const std::set<std::string> kinds{"discrete", "integrated", "virtual", "cpu", "other"};
    for (const json& device : document["results"]) {
        const std::string name = device["name"];
        const std::string kind = device["kind"];
        EXPECT_TRUE(kinds.contains(kind)) << kind;
        // The least that Vulkan promises.
        EXPECT_GE(device.at("max_index").get<std::uint64_t>(), (1u << 24u) - 1u) << name;
        EXPECT_GE(device.at("max_buffer_bytes").get<std::uint64_t>(), 1u << 27u) << name;
        if (name == deviceInfo().name) {
            EXPECT_EQ(device.at("depth_formats"), json(depth::namesOf(deviceInfo().depthFormats)));
        }
        if (name.starts_with("llvmpipe") || name.starts_with("SwiftShader")) {
            EXPECT_EQ(kind, "cpu") << name;
        }
    }
}

/// The loader hides a driver that lacks a part of Vulkan unless the program asks for such drivers. Here lavapipe's manifest
/// says that it lacks one.
TEST_F(Commands, DevicesFindsPortabilityDrivers) {
    const fs::path manifests = "/usr/share/vulkan/icd.d";
    std::string library;
    for (const auto& entry :
         fs::exists(manifests) ? fs::directory_iterator(manifests) : fs::directory_iterator()) {
        if (entry.path().filename().string().starts_with("lvp_icd")) {
            library = json::parse(readText(entry.path())).at("ICD").at("library_path");
        }
    }
    if (library.empty()) {
        GTEST_SKIP() << "lavapipe is not installed";
    }
    const json manifest{
        {"file_format_version", "1.0.1"},
        {"ICD", {{"library_path", library}, {"api_version", "1.3.0"}, {"is_portability_driver", true}}}};
    std::ofstream(at("driver.json")) << manifest;
    const ProgramResult result =
        succeed("render cubes --size 64x36",
                "VK_ICD_FILENAMES=\"$PWD/driver.json\" VK_DRIVER_FILES=\"$PWD/driver.json\"");
    EXPECT_NE(result.out.find("llvmpipe"), std::string::npos) << result.out;
}

TEST_F(Commands, PrecisionReproducesAll16CellsOfTable41) {
    const ProgramResult result = succeed("--points 0.02 precision --texture-memory 64 --json --curve c.csv");
    const json document = json::parse(result.out);
    expectEnvelope(document, "precision");
    EXPECT_EQ(document.at("given"), (json{{"texture-memory", {"64"}}, {"points", {"0.02"}}}))
        << "not where results go";
    int cells = 0;
    for (const json& cell : document["results"]) {
        if (cell.contains("thesis")) {
            ++cells;
            EXPECT_NEAR(cell["depth"].get<double>() / cell["thesis"].get<double>(), 1.0, 1e-3) << cell;
        }
    }
    EXPECT_EQ(cells, 16);
    EXPECT_EQ(textIn("c.csv").substr(0, 18), "distance,standard,");
}

TEST_F(Commands, PicturesWritesThemAllAndTheirNumbers) {
    const json document = documentOf("--validate pictures --size 320x180 --frames 2 --out p");
    expectEnvelope(document, "pictures");
    std::set<std::string> seen;
    for (const json& row : document["results"]) {
        const std::string stem = row["scene"].get<std::string>() + "_" + row["technique"].get<std::string>();
        seen.insert(stem);
        EXPECT_GT(row["pixels"], 1000);
        EXPECT_NEAR(row["wrong_fraction"].get<double>(),
                    row["wrong"].get<double>() / row["pixels"].get<double>(), 1e-12);
        const auto picture = readPicture(at("p") / (stem + ".png"));
        EXPECT_EQ(picture.width, 320u);
        // Not black: a good share of the picture is lit.
        EXPECT_GT(std::count_if(picture.pixels.begin(), picture.pixels.end(),
                                [](const auto& p) { return p[0] > 60; }),
                  320 * 180 / 20);
    }
    EXPECT_EQ(seen.size(), 12u);
    EXPECT_EQ(readPicture(at("p/contact_sheet.png")).width, 6u * 328u + 8u);
}

/// A million units away: nothing that starts from a float32 distance, micrometres anchored.
TEST_F(Commands, ProbeFindsWhatEachTechniqueResolves) {
    const json document = documentOf("--validate probe --distances 1e6 --formats " + fineFormats());
    expectEnvelope(document, "probe");
    std::map<std::string, double> resolved;
    for (const json& row : document["results"]) {
        EXPECT_EQ(row["distance"], 1e6);
        EXPECT_TRUE(row.contains("predicted"));
        const std::string key = row["technique"].get<std::string>() + " " + row["format"].get<std::string>();
        resolved[key] = row["resolved"].is_null() ? 10.0 : row["resolved"].get<double>();
    }
    EXPECT_EQ(resolved.at("standard d32f"), 10.0);
    EXPECT_EQ(resolved.at("log d32f"), 10.0);
    EXPECT_GE(resolved.at("cdr d32f"), 0.5);
    EXPECT_GE(resolved.at("logcdr d32f"), 0.5);
    EXPECT_GE(resolved.at("reversed d32f"), 0.04);
    EXPECT_LE(resolved.at("reversed d32f"), 0.3);
    EXPECT_LE(resolved.at("anchored d32f"), 2e-5);
    if (!hasD24()) {
        GTEST_SKIP() << kNoD24;
    }
    EXPECT_EQ(resolved.size(), 12u);
    for (const char* unresolved : {"standard d24", "log d24", "reversed d24"}) {
        EXPECT_EQ(resolved.at(unresolved), 10.0) << unresolved;
    }
    EXPECT_LE(resolved.at("anchored d24"), 5e-5);
}

/// Not asked for formats, probe takes those there are and says which are absent.
TEST_F(Commands, ProbeTakesTheFormatsThereAre) {
    const ProgramResult result =
        succeed("probe --distances 10 --techniques anchored --size 160x90 --json p.json");
    const json document = jsonIn("p.json");
    const std::size_t has = deviceInfo().depthFormats.size();
    EXPECT_EQ(document["results"].size(), has);
    EXPECT_EQ(document["missing_formats"].size(), depth::kDepthFormats.size() - has);
    EXPECT_EQ(result.out.find("cannot draw to it: d24") != std::string::npos, !hasD24()) << result.out;
}

TEST_F(Commands, ProbeTakesTechniquesByTheirParts) {
    const json document = documentOf(
        "--validate probe --distances 1e7 --techniques anchored-reversed/fitted --formats " + fineFormats());
    ASSERT_EQ(document["results"].size(), hasD24() ? 2u : 1u);
    for (const json& row : document["results"]) {
        EXPECT_EQ(row["technique"], "anchored-reversed/fitted");
        EXPECT_LE(row["resolved"].get<double>(), 2e-5);
    }
    if (!hasD24()) {
        GTEST_SKIP() << kNoD24;
    }
}

/// At this size 4 bits are too few for what `mixed` shows.
TEST_F(Commands, PicturesSnapVertices) {
    const auto rowOf = [&](int bits, const std::string& snapping) {
        json document =
            documentOf("--validate pictures --scenes mixed --frames 1 --size 480x270 --techniques anchored "
                       "--out p --snapping " +
                       snapping + " --snap-bits " + std::to_string(bits));
        EXPECT_EQ(document["options"]["snap_bits"], bits);
        EXPECT_EQ(document["options"]["snapping"], snapping);
        return document["results"][0];
    };
    const json snapped = rowOf(4, "by-device");
    EXPECT_GT(snapped["wrong"], 0);
    EXPECT_LT(snapped["wrong_fraction"], 0.05);
    EXPECT_LE(rowOf(0, "by-device")["wrong"], snapped["wrong"]);
    EXPECT_EQ(rowOf(4, "in-plane")["wrong"], 0);
    EXPECT_EQ(run("render cubes --snap-bits 9").status, 2);
    expectRefusal("render cubes --snapping in-plan", "in-plane");
}

TEST_F(Commands, AdviseCountsSnapping) {
    const std::string question = "advise --separation 0.5 --far 1e5 --json a.json";
    const ProgramResult plain = succeed(question);
    EXPECT_NE(plain.out.find("If vertices snap to 8 sub-pixel bits"), std::string::npos) << plain.out;
    EXPECT_TRUE(jsonIn("a.json")["options"]["sub_pixel_bits"].is_null());
    succeed(question + " --sub-pixel-bits 8");
    const json document = jsonIn("a.json");
    EXPECT_EQ(document["options"]["sub_pixel_bits"], 8);
    EXPECT_TRUE(document["simplest"].is_null());
    for (const json& row : document["results"]) {
        EXPECT_NEAR(row["snap_step"].get<double>(), 0.626, 0.001);
    }
    for (const char* bad : {"33", "-1", "x"}) {
        EXPECT_EQ(run(question + " --sub-pixel-bits " + bad).status, 2) << bad;
    }
    EXPECT_EQ(run(question + " --slope nan").status, 2);
}

TEST_F(Commands, AdviseMeasures) {
    const ProgramResult result =
        succeed("--validate advise --separation 0.01 --at 1e6 --far 2e6 --fov 0.002 --format d32f --measured "
                "--frames 2 --json a.json");
    EXPECT_NE(result.out.find("time over standard"), std::string::npos);
    EXPECT_NE(result.out.find("was measured to resolve"), std::string::npos) << result.out;
    const json document = jsonIn("a.json");
    expectEnvelope(document, "advise");
    EXPECT_FALSE(document["device"]["name"].get<std::string>().empty());
    ASSERT_EQ(document["results"].size(), 8u);
    for (const json& row : document["results"]) {
        EXPECT_GT(row["time_ratio"].get<double>(), 0.0);
        EXPECT_TRUE(row.at("time_ratio_ci95").is_null()) << "two frames have no interval";
        EXPECT_EQ(row["largest"], 1.0);
        const bool anchored = row["mapping"].get<std::string>().starts_with("anchored");
        EXPECT_EQ(row["suffices"], anchored) << row["technique"];
        EXPECT_EQ(row["resolved"].is_number() && row["resolved"] < 2e-5, anchored) << row["technique"];
    }
    EXPECT_EQ(document["simplest"]["technique"], "anchored");
}

TEST_F(Commands, AdviseMeasuresTheTechniquesAskedForInPicturesAskedFor) {
    const json document = documentOf(
        "advise --separation 1 --far 1000 --format d32f,d16 --techniques reversed,standard/count:2 --measured "
        "--size 160x90 --frames 1");
    EXPECT_EQ(document["time_format"], "d32f");
    EXPECT_EQ(document["options"]["measured_width"], 160);
    EXPECT_EQ(document["options"]["measured_height"], 90);
    ASSERT_EQ(document["results"].size(), 4u);
    EXPECT_EQ(document["results"][0]["mapping"], "reversed");
    EXPECT_EQ(document["results"][1]["format"], "d16");
    EXPECT_EQ(document["results"][1]["time_ratio"], document["results"][0]["time_ratio"]);
}

/// In a picture so small that no pixel shows a pair of cubes off edges, the forecast decides.
TEST_F(Commands, AdviseMeasuresNothingWhereNoPixelTells) {
    const ProgramResult result = succeed("advise --separation 0.5 --far 100000 --format d32f --techniques "
                                         "reversed --measured --size 64x36 --frames 1 --json a.json");
    EXPECT_NE(result.out.find("no pixel tells"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("is enough: it resolves"), std::string::npos) << result.out;
    EXPECT_TRUE(jsonIn("a.json")["results"][0].at("largest").is_null());
}

TEST_F(Commands, AdviseSaysWhenReversedIsEnough) {
    const ProgramResult result = succeed("advise --separation 0.5 --at 5000 --json a.json");
    EXPECT_NE(result.out.find("reversed with d32f in one cascade is enough"), std::string::npos)
        << result.out;
    const json document = jsonIn("a.json");
    expectEnvelope(document, "advise");
    EXPECT_EQ(document["simplest"]["technique"], "reversed");
    EXPECT_EQ(document["results"].size(), 24u);
    EXPECT_TRUE(document["results"][0].contains("predicted"));
}

TEST_F(Commands, RenderWritesEveryOutputAsPngAndAsExr) {
    std::set<std::string> pictures;
    for (const char* aov : {"color", "linear", "id", "distance", "normal", "cascade", "wrong"}) {
        for (const char* extension : {"png", "exr"}) {
            const std::string file = std::string(aov) + "." + extension;
            const ProgramResult result = succeed("--quiet render cubes --size 64x36 --technique cdr --aov " +
                                                 std::string(aov) + " -o " + file);
            EXPECT_EQ(result.out, "");
            EXPECT_GT(fs::file_size(at(file)), 100u) << file;
        }
        pictures.insert(textIn(std::string(aov) + ".png"));
    }
    EXPECT_EQ(pictures.size(), 7u) << "each output is another picture";
}

TEST_F(Commands, NamesOfPicturesEndInEitherCase) {
    const std::string render = "--quiet render cubes --size 64x36 -o ";
    for (const auto& [upper, lower] :
         {std::pair("A.PNG", "a.png"), std::pair("A.Tga", "a.tga"), std::pair("A.EXR", "a.exr")}) {
        succeed(render + upper);
        succeed(render + lower);
        EXPECT_EQ(textIn(upper), textIn(lower)) << upper;
    }
}

/// Against the truth of where each frame puts 100,000 objects, from 1 to 10,000,000 units away.
TEST_F(Commands, RenderDrawsTrafficWithoutAWrongPixel) {
    const auto count = [&](const std::string& arguments) {
        return documentOf("render traffic --size 960x540 --aov wrong -o w.png " + arguments)["results"][0];
    };
    for (const char* frame : {"3", "100"}) {
        const json row = count("--technique anchored --frame " + std::string(frame));
        EXPECT_GT(row["pixels"], 50'000);
        EXPECT_GT(row["overlap_pixels"], 20'000);
        EXPECT_EQ(row["wrong"], 0) << frame;
    }
    EXPECT_GT(count("--technique standard --frame 100")["wrong"], 20) << "what would be seen";
}

TEST_F(Commands, RenderCountsWrongPixelsAsPicturesDoes) {
    const ProgramResult rendered =
        succeed("render cubes --size 320x180 --technique standard --aov wrong -o w.png --json r.json");
    const json row = jsonIn("r.json")["results"][0];
    const json expected =
        documentOf("pictures --scenes cubes --techniques standard --size 320x180 --frames 1")["results"][0];
    EXPECT_GT(expected["wrong"], 0);
    for (const char* field : {"pixels", "wrong", "overlap_pixels", "overlap_wrong", "edge_wrong"}) {
        EXPECT_EQ(row[field], expected[field]) << field;
    }
    // Both write their counts alike, so what the picture marks must agree too, and the shares with the
    // counts.
    const auto marks = readPicture(at("w.png")).pixels;
    EXPECT_EQ(row["wrong"], std::count(marks.begin(), marks.end(), image::Rgba8{255, 0, 0, 255}));
    EXPECT_EQ(row["edge_wrong"], std::count(marks.begin(), marks.end(), image::Rgba8{255, 165, 0, 255}));
    EXPECT_EQ(row["wrong_fraction"], row["wrong"].get<double>() / row["pixels"].get<double>());
    EXPECT_EQ(row["overlap_wrong_fraction"],
              row["overlap_wrong"].get<double>() / row["overlap_pixels"].get<double>());
    const std::string share =
        base::quantityText(100.0 * expected["wrong_fraction"].get<double>(), base::NumberStyle::plain) + " %";
    EXPECT_NE(rendered.out.find(share), std::string::npos) << rendered.out;
}

TEST_F(Commands, RenderIdIsObjectIndexPlusOneInThreeBytes) {
    succeed("render cubes --size 320x180 --aov id -o id.png");
    const auto picture = readPicture(at("id.png"));
    std::set<unsigned> ids;
    for (const auto& p : picture.pixels) {
        ids.insert(p[0] + 256u * p[1] + 65536u * p[2]);
    }
    EXPECT_TRUE(ids.contains(0));
    EXPECT_GT(ids.size(), 200u);
    EXPECT_LE(*ids.rbegin(), 1000u);
    EXPECT_GT(*ids.rbegin(), 256u);
}

TEST_F(Commands, RenderSequencesNumberTheirFrames) {
    const ProgramResult result =
        succeed("render afc --size 160x90 --frame 7 --frames 3 -o f_%04d.png --hash --json r.json");
    for (const char* name : {"f_0007.png", "f_0008.png", "f_0009.png"}) {
        EXPECT_TRUE(fs::exists(at(name))) << name;
    }
    const json document = jsonIn("r.json");
    expectEnvelope(document, "render");
    std::set<std::string> hashes;
    for (const json& row : document["results"]) {
        for (const char* field : {"technique", "targets", "threads", "cascades", "draws", "hash"}) {
            EXPECT_TRUE(row.contains(field)) << field;
        }
        hashes.insert(row["hash"].get<std::string>());
        EXPECT_NE(result.out.find(row["hash"].get<std::string>()), std::string::npos);
    }
    EXPECT_EQ(hashes.size(), 3u);
}

TEST_F(Commands, RenderSaysWhichTargetsAndHowManyLayers) {
    std::set<std::string> hashes;
    for (const auto& [targets, layers] : {std::pair{"single", 0}, {"pool:4", 4}, {"layers", 0}}) {
        const std::string name = targets;
        const json row =
            documentOf("render afc --technique cdr --size 160x90 --targets " + name)["results"][0];
        EXPECT_EQ(row["targets"], name.substr(0, name.find(':')));
        EXPECT_EQ(row["layers"], layers) << name;
        hashes.insert(row["hash"].get<std::string>());
    }
    EXPECT_EQ(hashes.size(), 1u);
}

/// A coarse likeness: a model fills a fair share of the picture, in many colours, lit.
void expectRecognisable(const fs::path& asset, const std::string& options = "") {
    SCOPED_TRACE(asset);
    const TemporaryFolder folder;
    succeed("--validate render '" + fs::absolute(asset).string() + "' --size 640x360 -o m.png " + options,
            folder.path());
    const auto picture = readPicture(folder.path() / "m.png");
    std::map<unsigned, int> colors;
    for (const auto& p : picture.pixels) {
        ++colors[(p[0] >> 3) + 32u * (p[1] >> 3) + 1024u * (p[2] >> 3)];
    }
    const auto background = std::max_element(
        colors.begin(), colors.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    const int model = 640 * 360 - background->second;
    EXPECT_GT(model, 640 * 360 / 20);
    EXPECT_GT(colors.size(), 60u);
}

TEST(Assets, AreRecognisable) {
    const fs::path own = fs::path(CDR_SOURCE_DIR) / "tests" / "assets";
    expectRecognisable(own / "garden.glb", "--camera 0");
    expectRecognisable(own / "well.gltf");
}

TEST(Assets, LargerOnesAreRecognisable) {
    const fs::path shared = CDR_ASSETS_DIR;
    if (!fs::exists(shared)) {
        GTEST_SKIP() << "no larger models in " << shared;
    }
    for (const char* name : {"flight_helmet/flight_helmet.gltf", "retro_ufo.glb", "cesium_man.glb"}) {
        expectRecognisable(shared / name);
    }
}

/// A special case is named in every output.
TEST_F(RenderTable, NamesASurfacePathThatIsNotTheDefault) {
    const auto drawn = [&](const std::string& options) {
        return run("render cubes --technique standard --size 64x36 " + options).out;
    };
    EXPECT_NE(drawn("--surface lit").find("standard/lit"), std::string::npos) << drawn("--surface lit");
    EXPECT_EQ(drawn("").find("standard/"), std::string::npos) << drawn("");
}

} // namespace

} // namespace cdr::cli_test
