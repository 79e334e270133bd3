#include "fixture.h"

#include <cdr/image/codec.h>
#include <cdr/scene/gltf/solids/solids.h>

#include <cmath>
#include <map>
#include <utility>

namespace cdr::scene::test {
namespace {

using GltfPoints = GltfFolder;

constexpr double kRadius = 0.125;

/// (0, 0, 0) (2, 0, 0) (2, 4, 0) (0, 4, 0) of a mode, without normals.
Document cornersOf(Mode mode) {
    Document document = square();
    document.primitive()["attributes"].erase("NORMAL");
    document.primitive().erase("indices");
    document.primitive()["mode"] = mode;
    return document;
}

GltfLimits sized(double radius = kRadius) {
    GltfLimits limits;
    limits.pointRadius = radius;
    return limits;
}

void setIndices(Document& document, const std::vector<std::uint8_t>& indices) {
    document.primitive()["indices"] = document.addAccessor(indices, "SCALAR", kUByte);
}

/// World position of a vertex of a scene's instance.
glm::dvec3 worldOf(const Scene& scene, std::size_t vertex, std::size_t instance = 0) {
    const Mesh& mesh = scene.meshes.at(scene.instances.mesh.at(instance));
    return scene.instances.position(instance) +
           glm::dmat3(scene.instances.basis[instance]) * glm::dvec3(mesh.vertices.at(vertex).position);
}

/// The ends of each solid: the middles of its two rings of three corners.
std::vector<std::pair<glm::dvec3, glm::dvec3>> endsIn(const Scene& scene) {
    std::vector<std::pair<glm::dvec3, glm::dvec3>> ends;
    for (std::size_t i = 0; i + 5 < scene.meshes.at(0).vertices.size(); i += 6) {
        const auto middle = [&](std::size_t first) {
            return (worldOf(scene, first) + worldOf(scene, first + 1) + worldOf(scene, first + 2)) / 3.0;
        };
        ends.emplace_back(middle(i), middle(i + 3));
    }
    return ends;
}

void expectEnds(const Scene& scene, const std::vector<std::pair<glm::dvec3, glm::dvec3>>& wanted) {
    const auto ends = endsIn(scene);
    ASSERT_EQ(ends.size(), wanted.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        EXPECT_NEAR(glm::distance(ends[i].first, wanted[i].first), 0.0, 1e-6) << i;
        EXPECT_NEAR(glm::distance(ends[i].second, wanted[i].second), 0.0, 1e-6) << i;
    }
}

/// The volume inside; refuses a surface that is not closed.
double volumeOf(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    double volume = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        for (std::size_t c = 0; c < 3; ++c) {
            ++edges[{mesh.indices[i + c], mesh.indices[i + (c + 1) % 3]}];
        }
        const auto at = [&](std::size_t c) {
            return glm::dvec3(mesh.vertices[mesh.indices[i + c]].position);
        };
        volume += glm::dot(at(0), glm::cross(at(1), at(2))) / 6.0;
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1) << edge.first << " " << edge.second;
        EXPECT_TRUE(edges.contains({edge.second, edge.first})) << edge.first << " " << edge.second;
    }
    return volume;
}

TEST_F(GltfPoints, APointIsAClosedOctahedron) {
    const Scene scene = load(cornersOf(kPoints), sized()).scene;
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.vertices.size(), 24u);
    EXPECT_EQ(mesh.indices.size(), 96u);
    EXPECT_NEAR(volumeOf(mesh), 4 * 4.0 / 3.0 * std::pow(kRadius, 3), 1e-9) << "fronts are outside";
    const std::vector<float> points = corners(true);
    for (std::size_t i = 0; i < 24; ++i) {
        const std::size_t p = i / 6 * 3;
        const glm::dvec3 point(points[p], points[p + 1], points[p + 2]);
        EXPECT_NEAR(glm::distance(worldOf(scene, i), point), kRadius, 1e-9);
        EXPECT_NEAR(glm::distance(glm::dvec3(mesh.vertices[i].normal), (worldOf(scene, i) - point) / kRadius),
                    0.0, 1e-6);
    }
}

TEST_F(GltfPoints, ASegmentIsAClosedPrism) {
    Document document = triangle();
    document.primitive()["mode"] = kLineStrip;
    document.setFloats("POSITION", "VEC3", {0, 0, 0, 3, 0, 0, 3, 0, 4, 3, -2, 4, 4, 0, 2});
    const Scene scene = load(document, sized()).scene;
    const double section = 0.75 * std::sqrt(3.0) * kRadius * kRadius;
    EXPECT_NEAR(volumeOf(scene.meshes.at(0)), section * (3 + 4 + 2 + 3), 1e-6) << "fronts are outside";
    expectEnds(
        scene,
        {{{0, 0, 0}, {3, 0, 0}}, {{3, 0, 0}, {3, 0, 4}}, {{3, 0, 4}, {3, -2, 4}}, {{3, -2, 4}, {4, 0, 2}}});
    EXPECT_NEAR(glm::distance(worldOf(scene, 0), glm::dvec3(0.0)), kRadius, 1e-7);
}

TEST_F(GltfPoints, EveryModeHasItsSolids) {
    const glm::dvec3 a(0, 0, 0);
    const glm::dvec3 b(2, 0, 0);
    const glm::dvec3 c(2, 4, 0);
    const glm::dvec3 d(0, 4, 0);
    const auto sceneOf = [&](Mode mode) { return load(cornersOf(mode), sized()).scene; };
    EXPECT_EQ(endsIn(sceneOf(kPoints)).size(), 4u);
    expectEnds(sceneOf(kLines), {{a, b}, {c, d}});
    expectEnds(sceneOf(kLineStrip), {{a, b}, {b, c}, {c, d}});
    expectEnds(sceneOf(kLineLoop), {{a, b}, {b, c}, {c, d}, {d, a}});
    Document indexed = cornersOf(kLineLoop);
    setIndices(indexed, {3, 1, 0});
    expectEnds(load(indexed, sized()).scene, {{d, b}, {b, a}, {a, d}});
    indexed.primitive()["mode"] = kPoints;
    EXPECT_EQ(load(indexed, sized()).scene.meshes.at(0).vertices.size(), 18u);
}

TEST_F(GltfPoints, CountsThatMakeNoLineAreDropped) {
    Document document = cornersOf(kLines);
    const auto solids = [&](Mode mode, const std::vector<std::uint8_t>& indices) -> std::size_t {
        document.primitive()["mode"] = mode;
        setIndices(document, indices);
        const GltfImport result = load(document, sized());
        if (result.scene.meshes.empty()) {
            EXPECT_TRUE(anySays(result.ignored, "a primitive has no points or lines"));
            return 0;
        }
        EXPECT_TRUE(result.ignored.empty());
        return result.scene.meshes[0].vertices.size() / 6;
    };
    EXPECT_EQ(solids(kLines, {0, 1, 2}), 1u);
    EXPECT_EQ(solids(kLines, {0}), 0u);
    EXPECT_EQ(solids(kLineStrip, {0}), 0u);
    EXPECT_EQ(solids(kLineLoop, {0}), 0u);
    EXPECT_EQ(solids(kLineLoop, {0, 1}), 1u) << "there and back is one line";
    EXPECT_EQ(solids(kLines, {0, 0, 1, 2}), 1u) << "from a vertex to itself is no line";
    EXPECT_EQ(solids(kLineStrip, {2, 2, 2}), 0u);
    EXPECT_EQ(solids(kPoints, {2, 2}), 2u);
}

TEST_F(GltfPoints, IndicesAreChecked) {
    for (const Mode mode : {kPoints, kLines, kLineLoop, kLineStrip}) {
        Document document = cornersOf(mode);
        setIndices(document, {0, 1, 4, 2});
        EXPECT_EQ(refusal(document), "mesh 0 '' primitive 0: index 4 exceeds its 4 vertices") << mode;
        document.primitive()["indices"] = document.addAccessor(std::vector<float>{0, 1}, "SCALAR", kFloat);
        expectSays(refusal(document), "cannot hold vertex indices");
    }
}

TEST_F(GltfPoints, CornersHaveTheColoursOfTheirEnds) {
    for (const Mode mode : {kPoints, kLineStrip}) {
        Document document = cornersOf(mode);
        const int colours = document.addAccessor(
            std::vector<std::uint8_t>{1, 2, 3, 255, 4, 5, 6, 255, 7, 8, 9, 255, 10, 11, 12, 255}, "VEC4",
            kUByte);
        document.root["accessors"].back()["normalized"] = true;
        document.primitive()["attributes"]["COLOR_0"] = colours;
        const Mesh mesh = load(document, sized()).scene.meshes.at(0);
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            const std::size_t vertex = i / 6 + (mode == kLineStrip && i % 6 >= 3 ? 1 : 0);
            EXPECT_EQ(mesh.vertices[i].color.r, 3 * vertex + 1) << i;
        }
    }
}

TEST_F(GltfPoints, WithoutNormalsTheyAreUnlitAndWithThemLit) {
    Document document = cornersOf(kPoints);
    document.root["materials"] = {{{"doubleSided", true},
                                   {"emissiveFactor", {1, 0, 0}},
                                   {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, 1}}}}}};
    document.primitive()["material"] = 0;
    json triangles = square().primitive();
    triangles["attributes"].erase("NORMAL");
    triangles.erase("indices");
    triangles["material"] = 0;
    document.root["meshes"][0]["primitives"].push_back(triangles);
    const GltfImport unlit = load(document, sized());
    ASSERT_EQ(unlit.scene.materials.size(), 2u);
    EXPECT_TRUE(unlit.scene.materials[0].unlit);
    EXPECT_FALSE(unlit.scene.materials[0].metallicRoughness.has_value());
    EXPECT_FALSE(unlit.scene.materials[0].doubleSided) << "a solid is closed";
    EXPECT_EQ(unlit.scene.materials[0].baseColorFactor, glm::vec4(0.5f, 0.25f, 1, 1));
    EXPECT_EQ(unlit.scene.materials[0].detail, MaterialDetail{.emission = glm::vec3(1, 0, 0)});
    EXPECT_TRUE(unlit.ignored.empty());
    EXPECT_FALSE(unlit.scene.materials[1].unlit) << "triangles of the same material stay";
    EXPECT_TRUE(unlit.scene.materials[1].doubleSided);

    document.setFloats("NORMAL", "VEC3", {0, 2, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1});
    const GltfImport lit = load(document, sized());
    EXPECT_FALSE(lit.scene.materials[0].unlit);
    EXPECT_TRUE(lit.scene.materials[0].metallicRoughness.has_value());
    EXPECT_EQ(lit.scene.materials[0].detail.emission, glm::vec3(1, 0, 0));
    EXPECT_TRUE(lit.ignored.empty());
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(lit.scene.meshes[0].vertices[i].normal, glm::vec3(0, 1, 0));
        EXPECT_EQ(lit.scene.meshes[0].vertices[i + 6].normal, glm::vec3(1, 0, 0));
    }
}

TEST_F(GltfPoints, WithoutNormalsTheyKeepNoTextureButThoseOfColourAndEmission) {
    image::writeImage(folder() / "t.png", image::ImageRgba8(2, 2, {128, 128, 255, 255}));
    Document document = cornersOf(kPoints);
    document.root["images"] = {{{"uri", "t.png"}}};
    document.root["textures"] = {{{"source", 0}}};
    const json use = {{"index", 0}};
    document.root["materials"] = {
        {{"emissiveFactor", {0, 1, 0}},
         {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}},
         {"normalTexture", use},
         {"occlusionTexture", use},
         {"pbrMetallicRoughness", {{"baseColorTexture", use}, {"metallicRoughnessTexture", use}}}}};
    document.primitive()["material"] = 0;
    document.setFloats("TEXCOORD_1", "VEC2", {0, 0, 1, 0, 0, 1, 0.25, 0.5});
    const Scene scene = load(document, sized()).scene;
    EXPECT_EQ(scene.textures.size(), 1u) << "what is not shown is not read";
    EXPECT_EQ(scene.materials.at(0).baseColorTexture, 0u);
    EXPECT_EQ(scene.materials[0].detail,
              (MaterialDetail{.emissive = TextureUse{.texture = 0, .second = true}, .emission = {0, 1, 0}}));
    ASSERT_EQ(scene.meshes.at(0).details.size(), scene.meshes[0].vertices.size());
    EXPECT_EQ(scene.meshes[0].details[18].uv, glm::vec2(0.25f, 0.5f));
}

TEST_F(GltfPoints, NormalTexturesNeedTangents) {
    image::writeImage(folder() / "t.png", image::ImageRgba8(2, 2, {128, 128, 255, 255}));
    Document document = square();
    document.primitive()["mode"] = kPoints;
    document.root["images"] = {{{"uri", "t.png"}}};
    document.root["textures"] = {{{"source", 0}}};
    document.root["materials"] = {{{"normalTexture", {{"index", 0}}}}};
    document.primitive()["material"] = 0;
    const Scene without = load(document, sized()).scene;
    EXPECT_FALSE(without.materials.at(0).detail.normal.has_value());
    EXPECT_TRUE(without.meshes.at(0).details.empty());
    document.setFloats("TANGENT", "VEC4", {1, 0, 0, 1, 0, 1, 0, -1, 1, 0, 0, 1, 1, 0, 0, 1});
    const Scene with = load(document, sized()).scene;
    EXPECT_TRUE(with.materials.at(0).detail.normal.has_value());
    ASSERT_EQ(with.meshes.at(0).details.size(), with.meshes[0].vertices.size());
    EXPECT_EQ(with.meshes[0].details[11].tangent, glm::vec4(0, 1, 0, -1));
}

TEST_F(GltfPoints, DefaultRadiusFollowsTheData) {
    using gltf::defaultLineRadius;
    using gltf::defaultPointRadius;
    // A square of 100 x 100, 1 apart; a row of 1000; two; a ball's surface; all at one place.
    EXPECT_NEAR(defaultPointRadius({99, 99, 0}, 10'000), 0.33, 1e-9);
    EXPECT_NEAR(defaultPointRadius({0, 999, 0}, 1000), 0.333, 1e-9);
    EXPECT_NEAR(defaultPointRadius({0, 0, 6}, 2), 1.0, 1e-9);
    EXPECT_NEAR(defaultPointRadius({2, 2, 2}, 1'000'000), std::sqrt(12.0) / 3000, 1e-9);
    EXPECT_EQ(defaultPointRadius(glm::dvec3(0.0), 5), 0.0);
    EXPECT_NEAR(defaultLineRadius({300, 0, 400}), 1.0, 1e-9);
    EXPECT_EQ(defaultLineRadius(glm::dvec3(0.0)), 0.0);

    Document document = cornersOf(kPoints);
    const double expected = std::sqrt(8.0 / 4.0) / 3.0;
    EXPECT_NEAR(glm::distance(worldOf(load(document).scene, 0), glm::dvec3(0.0)), expected, 1e-6);
    document.root["nodes"][0]["scale"] = {5, 5, 5};
    EXPECT_NEAR(glm::distance(worldOf(load(document).scene, 0), glm::dvec3(0.0)), 5 * expected, 1e-5);
}

TEST_F(GltfPoints, AGivenRadiusIsInSceneUnitsOfTheLargestNode) {
    Document document = cornersOf(kPoints);
    document.root["nodes"] = {{{"mesh", 0}, {"scale", {100, 100, 100}}}, {{"mesh", 0}, {"scale", {1, 1, 1}}}};
    document.root["scenes"][0]["nodes"] = {0, 1};
    const Scene scene = load(document, sized(7.0)).scene;
    EXPECT_NEAR(glm::distance(worldOf(scene, 0), glm::dvec3(0.0)), 7.0, 1e-4);
    EXPECT_NEAR(glm::distance(worldOf(scene, 0, 1), glm::dvec3(0.0)), 0.07, 1e-6);
}

TEST_F(GltfPoints, WhatIsAllAtOnePlaceNeedsARadius) {
    Document document = cornersOf(kPoints);
    document.setFloats("POSITION", "VEC3", std::vector<float>(12, 3.0f));
    for (const Mode mode : {kPoints, kLineStrip}) {
        document.primitive()["mode"] = mode;
        const GltfImport result = load(document);
        EXPECT_TRUE(result.scene.meshes.empty());
        EXPECT_TRUE(anySays(result.ignored, "all at one place, so their size is not known"));
    }
    EXPECT_TRUE(anySays(load(document, sized()).ignored, "its lines have no length"));
    document.primitive()["mode"] = kPoints;
    EXPECT_EQ(load(document, sized()).scene.meshes.at(0).vertices.size(), 24u);
}

TEST_F(GltfPoints, PositionsAndSizesThatAreNotFiniteAreRefused) {
    Document document = cornersOf(kPoints);
    expectSays(refusal(document, sized(1e39)), "its bounding radius must lie in [0, 1e20]");
    std::vector<float> positions = corners(true);
    positions[4] = std::nanf("");
    document.setFloats("POSITION", "VEC3", positions);
    for (const Mode mode : {kPoints, kLines, kLineLoop, kLineStrip}) {
        document.primitive()["mode"] = mode;
        expectSays(refusal(document), "the position of vertex 1 is not finite");
        expectSays(refusal(document, sized()), "the position of vertex 1 is not finite");
    }
}

TEST_F(GltfPoints, FarPointsKeepTheirShape) {
    Document document = cornersOf(kPoints);
    document.setFloats("POSITION", "VEC3", {1e7f, 0, 0, 1e7f + 2, 0, 0});
    const Mesh mesh = load(document, sized(0.001)).scene.meshes.at(0);
    EXPECT_NEAR(volumeOf(mesh), 2 * 4.0 / 3.0 * 1e-9, 1e-13);
}

TEST_F(GltfPoints, TooManyAreRefused) {
    GltfLimits limits;
    limits.maxTriangles = 31;
    EXPECT_EQ(refusal(cornersOf(kPoints), limits),
              "its triangles, repeats counted, are over the limit of 31");
    limits.maxTriangles = 32;
    EXPECT_EQ(refusal(cornersOf(kPoints), limits), "loaded");
    // 4 solids of 6 vertices and 24 indices: 1248 bytes that stay, and 2816 that pass.
    limits.maxBytes = 1248 + 2816;
    EXPECT_EQ(refusal(cornersOf(kLineLoop), limits), "loaded");
    limits.maxBytes -= 1;
    EXPECT_EQ(refusal(cornersOf(kLineLoop), limits),
              "mesh 0 '' primitive 0: the import would take 4064 bytes of memory, over the limit of 4063");
    Document hollow = cornersOf(kPoints);
    hollow.root["accessors"].push_back(
        {{"componentType", kFloat}, {"count", 2'000'000'000}, {"type", "VEC3"}});
    hollow.primitive()["attributes"]["POSITION"] = hollow.root["accessors"].size() - 1;
    expectSays(refusal(hollow), "the import would take 2032000000000 bytes of memory");
}

TEST_F(GltfPoints, QuantizedAndSparsePositionsAreRead) {
    Document document = cornersOf(kPoints);
    const int positions =
        document.addAccessor(std::vector<std::int16_t>{0, 0, 0, 0, 32767, 0, 0, 0}, "VEC4", kShort);
    json& accessor = document.root["accessors"].back();
    accessor["type"] = "VEC3";
    accessor["normalized"] = true;
    document.root["bufferViews"].back()["byteStride"] = 8;
    accessor["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", document.addView(std::vector<std::uint8_t>{1})}, {"componentType", kUByte}}},
        {"values", {{"bufferView", document.addView(std::vector<std::int16_t>{0, 32767, 0})}}}};
    document.primitive()["attributes"]["POSITION"] = positions;
    document.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    document.root["nodes"][0]["scale"] = {10, 10, 10};
    const Scene scene = load(document, sized()).scene;
    ASSERT_EQ(scene.meshes.at(0).vertices.size(), 12u);
    EXPECT_NEAR(glm::distance(worldOf(scene, 6), glm::dvec3(0, 10, 0)), kRadius, 1e-6);
}

TEST_F(GltfPoints, CopiesOfPointsStandWhereTheyShould) {
    Document document = cornersOf(kPoints);
    document.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = {
        {"attributes",
         {{"TRANSLATION", document.addAccessor(std::vector<float>{0, 0, 0, 0, 0, 50}, "VEC3", kFloat)}}}};
    document.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
    const Scene scene = load(document, sized()).scene;
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_NEAR(glm::distance(worldOf(scene, 0, 1), glm::dvec3(0, 0, 50)), kRadius, 1e-6);
}

TEST_F(GltfPoints, CornersOfAPointAreMorphedAlike) {
    Document document = cornersOf(kPoints);
    document.primitive()["targets"] = {
        {{"POSITION",
          document.addAccessor(std::vector<float>{0, 0, 8, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3", kFloat)}}};
    document.root["meshes"][0]["weights"] = {0.5};
    const Scene scene = load(document, sized()).scene;
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(glm::distance(worldOf(scene, i), glm::dvec3(0, 0, 4)), kRadius, 1e-6);
        EXPECT_NEAR(glm::distance(worldOf(scene, i + 6), glm::dvec3(2, 0, 0)), kRadius, 1e-6);
    }
    EXPECT_NEAR(glm::length(scene.meshes[0].vertices[0].normal - glm::vec3(0, -1, 0)), 0.0f, 1e-6f)
        << "normals stay those of the solid";
}

TEST_F(GltfPoints, LinesFollowTheJointsOfTheirEnds) {
    Document document = cornersOf(kLines);
    const std::vector<float> weights{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    giveSkin(
        document, {0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
        document.addAccessor(weights, "VEC4", kFloat),
        {{{"mesh", 0}, {"skin", 0}, {"scale", {9, 9, 9}}}, {{"name", "rest"}}, {{"translation", {0, 0, 5}}}});
    const Scene scene = load(document, sized()).scene;
    expectEnds(scene, {{{0, 0, 0}, {2, 0, 5}}, {{2, 4, 0}, {0, 4, 0}}});
    EXPECT_NEAR(glm::distance(worldOf(scene, 0), glm::dvec3(0.0)), kRadius, 1e-6) << "the node has no say";
}

} // namespace
} // namespace cdr::scene::test
