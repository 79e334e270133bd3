#include "fixture.h"

#include <string>
#include <vector>

namespace cdr::scene::test {
namespace {

using GltfLayers = GltfFolder;

/// A square on two nodes, the second below a parent.
Document twoSquares() {
    Document document = square();
    document.root["materials"] = {{{"name", "paint"}}};
    document.primitive()["material"] = 0;
    document.root["nodes"] = {{{"mesh", 0}}, {{"children", {2}}}, {{"mesh", 0}}};
    document.root["scenes"] = {{{"nodes", {0, 1}}}};
    return document;
}

std::vector<float> layersOf(const Scene& scene) {
    std::vector<float> layers;
    for (const std::uint32_t material : scene.instances.material) {
        layers.push_back(scene.materials[material].layer);
    }
    return layers;
}

TEST_F(GltfLayers, ComeFromTheExtrasOfMaterials) {
    Document document = twoSquares();
    document.root["materials"][0]["extras"] = {{"cdr_layer", 0.25}};
    EXPECT_EQ(layersOf(load(document).scene), (std::vector<float>{0.25f, 0.25f}));
}

TEST_F(GltfLayers, OfNodesWinAndHoldForWhatIsBelowThem) {
    Document document = twoSquares();
    document.root["materials"][0]["extras"] = {{"cdr_layer", 0.25}};
    document.root["nodes"][1]["extras"] = {{"cdr_layer", -0.5}};
    const Scene scene = load(document).scene;
    EXPECT_EQ(layersOf(scene), (std::vector<float>{0.25f, -0.5f}));
    EXPECT_EQ(scene.materials.size(), 2u);
    document.root["nodes"][2]["extras"] = {{"cdr_layer", 0.25}};
    EXPECT_EQ(load(document).scene.materials.size(), 1u); // nothing to tell apart
}

TEST_F(GltfLayers, ComeFromNamesOfToolsThatWriteNoExtras) {
    Document document = twoSquares();
    document.root["materials"][0]["name"] = "paint@layer=0.125";
    document.root["nodes"][2]["name"] = "decal@layer=-2";
    EXPECT_EQ(layersOf(load(document).scene), (std::vector<float>{0.125f, -2.0f}));
}

TEST_F(GltfLayers, ThatAreNoNumbersAreNoted) {
    for (const json& wrong : {json("high"), json(1e300), json(nullptr), json::array({1})}) {
        Document document = twoSquares();
        document.root["materials"][0]["extras"] = {{"cdr_layer", wrong}};
        const GltfImport import = load(document);
        EXPECT_EQ(layersOf(import.scene), (std::vector<float>{0.0f, 0.0f})) << wrong;
        ASSERT_EQ(import.ignored.size(), 1u) << wrong;
        EXPECT_NE(import.ignored[0].find("layer"), std::string::npos);
    }
    for (const char* name : {"paint@layer=", "paint@layer=1m", "paint@layer=nan"}) {
        Document document = twoSquares();
        document.root["nodes"][0]["name"] = name;
        const GltfImport import = load(document);
        EXPECT_EQ(layersOf(import.scene), (std::vector<float>{0.0f, 0.0f})) << name;
        EXPECT_EQ(import.ignored.size(), 1u) << name;
    }
}

/// A file has no more materials of its own.
TEST_F(GltfLayers, OfNodesMakeNoMoreMaterialsThanAFileMayHave) {
    Document document = twoSquares();
    document.root["nodes"] = json::array();
    for (int i = 0; i < 70'000; ++i) {
        document.root["nodes"].push_back({{"mesh", 0}, {"extras", {{"cdr_layer", i + 1}}}});
        document.root["scenes"][0]["nodes"][static_cast<std::size_t>(i)] = i;
    }
    expectSays(refusal(document), "layers of nodes need over 65536 materials");
}

/// Extras are free to hold anything else.
TEST_F(GltfLayers, AreNotReadFromOtherExtras) {
    Document document = twoSquares();
    document.root["materials"][0]["extras"] = "text";
    document.root["nodes"][0]["extras"] = {{"layer", 3}};
    const GltfImport import = load(document);
    EXPECT_EQ(layersOf(import.scene), (std::vector<float>{0.0f, 0.0f}));
    EXPECT_TRUE(import.ignored.empty());
}

} // namespace
} // namespace cdr::scene::test
