#include "../../support/refusal.h"
#include "fixture.h"

#include <cdr/platform/worker_pool.h>
#include <cdr/scene/gltf/open_gltf.h>

#include <cmath>

namespace cdr::scene::test {
namespace {

using GltfAnimation = GltfFolder;

/// A square that moves along x for two seconds.
Document moving() {
    Document document = square();
    giveMove(document, 0, {0, 2}, {0, 0, 0, 10, 0, 0});
    document.root["animations"][0]["name"] = "slide";
    return document;
}

json& sampler(Document& document) {
    return document.root["animations"][0]["samplers"][0];
}

/// A square whose right half follows a second joint, one unit up.
Document skinned() {
    Document document = square();
    const std::vector<float> weights{1, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    giveSkin(document, {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0},
             document.addAccessor(weights, "VEC4", kFloat),
             {{{"mesh", 0}, {"skin", 0}, {"translation", {50, 0, 0}}},
              {{"name", "low"}},
              {{"name", "high"}, {"translation", {0, 1, 0}}}});
    return document;
}

glm::dvec3 cornerOf(const Scene& scene, std::size_t vertex) {
    const Mesh& mesh = scene.meshes[scene.instances.mesh[0]];
    return scene.instances.position(0) +
           glm::dmat3(scene.instances.basis[0]) * glm::dvec3(mesh.vertices[vertex].position);
}

TEST_F(GltfAnimation, MovesItsNodes) {
    const std::filesystem::path path = write("a.glb", moving().glb());
    const auto xAt = [&](double seconds) {
        GltfChoice choice;
        choice.seconds = seconds;
        return openGltf(path, choice).setup.scene.instances.x[0];
    };
    EXPECT_EQ(xAt(0.0), 1.0);
    EXPECT_EQ(xAt(1.0), 6.0);
    EXPECT_EQ(xAt(9.0), 11.0);
    const OpenedScene still = openGltf(path);
    EXPECT_EQ(still.setup.scene.instances.x[0], 1.0);
    EXPECT_FALSE(still.setup.motion);
    ASSERT_TRUE(still.animationsNote.has_value());
    EXPECT_EQ(still.notes.at(*still.animationsNote), "its animation of 2 s, which render --time shows");
    GltfChoice played;
    played.seconds = 0.0;
    EXPECT_FALSE(openGltf(path, played).animationsNote.has_value());
    ASSERT_EQ(still.animations.size(), 1u);
    EXPECT_EQ(still.animations[0].name, "slide");
    EXPECT_EQ(still.animations[0].seconds, 2.0);
}

/// So that pictures of a moment do not depend on the one that a run begins with.
TEST_F(GltfAnimation, LampsAreThoseOfTheModelAtRest) {
    Document document = moving();
    document.root["nodes"].push_back({{"mesh", 0}}); // one stays, so that the bounds change
    document.root["scenes"][0]["nodes"].push_back(document.root["nodes"].size() - 1);
    const std::filesystem::path path = write("a.glb", document.glb());
    for (const ModelLight by : {ModelLight::lamps, ModelLight::sky}) {
        GltfChoice choice;
        choice.light = by;
        const Scene atRest = openGltf(path, choice).setup.scene;
        choice.seconds = 2.0;
        const Scene later = openGltf(path, choice).setup.scene;
        ASSERT_EQ(later.lights.size(), atRest.lights.size());
        ASSERT_NE(later.instances.x[0], atRest.instances.x[0]);
        for (std::size_t i = 0; i < later.lights.size(); ++i) {
            EXPECT_EQ(later.lights[i].position, atRest.lights[i].position);
            EXPECT_EQ(later.lights[i].halfDistance, atRest.lights[i].halfDistance);
        }
    }
}

TEST_F(GltfAnimation, FramesGoByTheirRate) {
    GltfChoice choice;
    choice.seconds = 0.5;
    choice.framesPerSecond = 4.0;
    const OpenedScene opened = openGltf(write("a.glb", moving().glb()), choice);
    ASSERT_EQ(opened.setup.motion.instances, (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(opened.setup.scene.instances.x[0], 3.5);
    EXPECT_EQ(opened.setup.motion.transforms(0)[0].position.x, 3.5);
    EXPECT_EQ(opened.setup.motion.transforms(2)[0].position.x, 6.0);
    EXPECT_EQ(secondsAt(choice, 2), 1.0);
    EXPECT_FALSE(secondsAt({}, 2));
}

/// A model that grows from nothing is seen later.
TEST_F(GltfAnimation, OneThatBeginsWithNothingIsFramedByItsLaterMoments) {
    Document document = moving();
    giveMove(document, 0, {0, 2}, {0, 0, 0, 5, 5, 5});
    document.root["animations"][0]["channels"][0]["target"]["path"] = "scale";
    GltfChoice choice;
    choice.framesPerSecond = 2.0;
    for (const char* interpolation : {"LINEAR", "STEP"}) { // the latter shows it at its end alone
        sampler(document)["interpolation"] = interpolation;
        for (const json& atRest : {json{1, 1, 1}, json{0, 0, 0}}) {
            document.root["nodes"][0]["scale"] = atRest;
            const OpenedScene opened = openGltf(write("a.glb", document.glb()), choice);
            EXPECT_EQ(opened.setup.scene.instances.radius[0], 0.0f) << "the scene is as at the first moment";
            const Camera camera = opened.setup.path.at(0);
            const double distance = camera.viewDistance({5, 10, 0}); // of the centre of the square at its end
            EXPECT_GT(distance * std::sin(0.5 * camera.fovY), 5.0 * std::sqrt(5.0)) << interpolation;
            EXPECT_LT(distance, 100.0);
        }
    }
    choice = {};
    choice.seconds = 0.0;
    EXPECT_NE(cdr::test::inputErrorOf([&] {
                  openGltf(write("a.glb", document.glb()), choice);
              }).find("the scene has no extent to look at"),
              std::string::npos);
}

TEST_F(GltfAnimation, IsChosenByNameOrNumber) {
    Document document = moving();
    document.root["animations"].push_back(document.root["animations"][0]);
    document.root["animations"][1]["name"] = "0"; // names come first
    document.root["animations"][1]["channels"] = json::array();
    const std::filesystem::path path = write("a.glb", document.glb());
    const auto xOf = [&](const std::string& name) {
        GltfChoice choice;
        choice.animation = name;
        choice.seconds = 1.0;
        return openGltf(path, choice).setup.scene.instances.x[0];
    };
    EXPECT_EQ(xOf("slide"), 6.0);
    EXPECT_EQ(xOf("0"), 1.0);
    EXPECT_EQ(xOf("1"), 1.0);
    EXPECT_EQ(xOf("#0"), 6.0);
    GltfChoice first;
    first.seconds = 1.0;
    EXPECT_EQ(openGltf(path, first).setup.scene.instances.x[0], 6.0) << "the first, not '0'";
    const std::string message = cdr::test::inputErrorOf([&] { xOf("walk"); });
    expectSays(message, "animation 'walk' does not exist, the file has 2: 0 'slide', 1 '0'");
}

TEST_F(GltfAnimation, ANodeThatIsFlatAtRestMayGrow) {
    Document document = moving();
    document.root["nodes"][0]["scale"] = {0, 0, 0};
    document.root["animations"][0]["channels"][0]["target"]["path"] = "scale";
    EXPECT_EQ(load(document).scene.instances.basis[0], glm::mat3(0.0f));
    Document grows = document;
    sampler(grows)["output"] = grows.addAccessor(std::vector<float>{0, 0, 0, 4, 4, 4}, "VEC3", kFloat);
    EXPECT_EQ(
        openGltf(write("b.glb", grows.glb()), {.scene = {}, .camera = {}, .animation = {}, .seconds = 1.0})
            .setup.scene.instances.basis[0],
        glm::mat3(2.0f));
}

/// So that a picture of a model far from the origin is not framed to show the origin too.
TEST_F(GltfAnimation, ANodeThatIsFlatAtRestKeepsItsPlace) {
    Document document = moving();
    document.root["nodes"][0]["scale"] = {0, 0, 0};
    document.root["nodes"][0]["translation"] = {1e6, 0, 0};
    document.root["animations"][0]["channels"][0]["target"]["path"] = "scale";
    document.root["nodes"].push_back({{"mesh", 0}, {"translation", {1e6, 0, 0}}});
    document.root["scenes"][0]["nodes"] = {0, 1};
    const Instances instances = load(document).scene.instances;
    EXPECT_EQ(instances.position(0), glm::dvec3(1e6, 0, 0));
    EXPECT_EQ(instances.basis[0], glm::mat3(0.0f));
    const Camera camera = openGltf(write("a.glb", document.glb())).setup.path.at(0);
    EXPECT_LT(glm::distance(camera.position, glm::dvec3(1e6, 0, 0)), 20.0);
}

/// Also where float32 has no such size, whose volume is not a number.
TEST_F(GltfAnimation, OneThatGrowsBeyondWhatCanBeDrawnIsRefused) {
    for (const float size : {1e18f, 1e20f}) {
        Document document = moving();
        giveMove(document, 0, {0, 2}, {1e-20f, 1e-20f, 1e-20f, size, size, size});
        document.root["animations"][0]["channels"][0]["target"]["path"] = "scale";
        document.root["nodes"][0]["scale"] = {1e-20, 1e-20, 1e-20};
        for (const double around : {1.0, 1e20}) {
            document.root["nodes"][1] = {{"children", {0}}, {"scale", {around, around, around}}};
            document.root["scenes"][0]["nodes"] = {1};
            const std::filesystem::path path = write("a.glb", document.glb());
            GltfChoice choice;
            choice.seconds = 2.0;
            EXPECT_EQ(cdr::test::inputErrorOf([&] { openGltf(path, choice); }),
                      path.string() +
                          ": instance 0: its basis must be finite, with columns no longer than 1e17")
                << size << " " << around;
        }
    }
}

/// Exporters write splines of one keyframe for what does not move.
TEST_F(GltfAnimation, ASplineOfOneKeyframeIsItsValue) {
    Document document = moving();
    giveMove(document, 0, {0}, {9, 9, 9, 1, 2, 3, 9, 9, 9});
    sampler(document)["interpolation"] = "CUBICSPLINE";
    const std::filesystem::path path = write("a.glb", document.glb());
    for (const double seconds : {0.0, 0.5}) {
        GltfChoice choice;
        choice.animation = "0";
        choice.seconds = seconds;
        // Of the square's middle, which is (1, 2, 0) from the node.
        EXPECT_EQ(openGltf(path, choice).setup.scene.instances.position(0), glm::dvec3(2, 4, 3)) << seconds;
    }
}

TEST_F(GltfAnimation, UnsoundOnesAreRefused) {
    const auto with = [&](auto change) {
        Document document = moving();
        change(document);
        return refusal(document);
    };
    const auto output = [](int type, std::size_t count, const char* kind) {
        return [=](Document& document) {
            sampler(document)["output"] = document.addAccessor(std::vector<float>(count, 1.0f), kind, type);
        };
    };
    const auto input = [](std::vector<float> times) {
        return [=](Document& document) {
            sampler(document)["input"] = document.addAccessor(times, "SCALAR", kFloat);
        };
    };
    expectSays(with(input({})), "its times are no list of numbers");
    expectSays(with(output(kFloat, 9, "VEC3")), "3 elements of 3 components where 2 of 3 are needed");
    expectSays(with(output(kFloat, 8, "VEC4")), "2 elements of 4 components where 2 of 3 are needed");
    const char* interpolation = "/animations/0/samplers/0/interpolation";
    expectRefused(moving(), interpolation, "CUBICSPLINE", "where 6 of 3 are needed");
    expectRefused(moving(), interpolation, "SINE", "interpolation 'SINE' does not");
    expectRefused(moving(), "/animations/0/channels/0/sampler", 7, "sampler 7 does not exist");
    expectRefused(moving(), "/animations/0/channels/0/target/node", 7, "node 7 does not exist");
    expectSays(with([](Document& d) {
                   d.root["animations"][0]["channels"][0]["target"]["path"] = "rotation";
                   sampler(d)["output"] = d.addAccessor(std::vector<float>(8, 0.0f), "VEC4", kFloat);
               }),
               "its rotation 0 has no direction");
}

/// A picture of the file at rest needs none of them.
TEST_F(GltfAnimation, OneWhoseTimesAreUnsoundIsRefusedWhenItIsPlayed) {
    const auto with = [&](const std::vector<float>& times) {
        Document document = moving();
        json other = document.root["animations"][0];
        other["name"] = "other";
        document.root["animations"].push_back(std::move(other));
        document.root["animations"][0]["samplers"][0]["input"] =
            document.addAccessor(times, "SCALAR", kFloat);
        const std::filesystem::path path = write("a.glb", document.glb());
        EXPECT_TRUE(anySays(openGltf(path).notes, "animation 0 'slide': it cannot be played, because"));
        GltfChoice choice;
        choice.seconds = 1.0;
        choice.animation = "1";
        EXPECT_EQ(openGltf(path, choice).setup.scene.instances.x[0], 6.0);
        choice.animation.reset();
        return cdr::test::inputErrorOf([&] { openGltf(path, choice); }, "opened");
    };
    expectSays(with({1, 1}), "animation 0 'slide' sampler 0: its time 1 is not finite, or does not come");
    expectSays(with({0, NAN}), "its time 1 is not finite");
    expectSays(with({-1, 1}), "its time 0 is negative");
}

TEST_F(GltfAnimation, ChannelsThatNothingFollowsAreSaid) {
    Document document = moving();
    document.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_TRUE(anySays(load(document).ignored, "a node that is given as a matrix, which stays"));
    document = moving();
    document.root["animations"][0]["channels"][0]["target"]["path"] = "weights";
    EXPECT_TRUE(anySays(load(document).ignored, "a node without morph targets"));
    document.root["animations"][0]["channels"][0]["target"]["path"] = "pointer";
    EXPECT_TRUE(anySays(load(document).ignored, "moves what is no part of a node"));
}

/// The node of a skinned mesh does not place it, and weights are made to add up to one.
TEST_F(GltfAnimation, SkinsAreAppliedAtRest) {
    const GltfImport result = load(skinned());
    EXPECT_EQ(result.ignored, std::vector<std::string>());
    EXPECT_EQ(cornerOf(result.scene, 0), glm::dvec3(0.0, 0.0, 0.0));
    EXPECT_EQ(cornerOf(result.scene, 1), glm::dvec3(2.0, 1.0, 0.0));
    EXPECT_EQ(cornerOf(result.scene, 2), glm::dvec3(2.0, 5.0, 0.0));
    EXPECT_EQ(cornerOf(result.scene, 3), glm::dvec3(0.0, 4.0, 0.0));
}

TEST_F(GltfAnimation, InverseBindMatricesComeFirst) {
    Document document = skinned();
    std::vector<float> matrices;
    for (const float down : {0.0f, -1.0f}) {
        matrices.insert(matrices.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, down, 0, 1});
    }
    document.root["skins"][0]["inverseBindMatrices"] = document.addAccessor(matrices, "SCALAR", kFloat);
    document.root["accessors"].back()["type"] = "MAT4";
    document.root["accessors"].back()["count"] = 2;
    EXPECT_EQ(cornerOf(load(document).scene, 2), glm::dvec3(2.0, 4.0, 0.0));
}

TEST_F(GltfAnimation, UnsoundSkinsAreRefused) {
    const Document sound = skinned();
    expectRefused(sound, "/skins/0/joints", {1},
                  "mesh 0 '' primitive 0: vertex 1 follows joint 1, and the skin has 1");
    expectRefused(sound, "/skins/0/joints", json::array(), "skin 0: has no joints");
    expectRefused(sound, "/skins/0/joints", {1, 9}, "node 9 does not exist");
    expectRefused(sound, "/nodes/0/skin", 3, "skin 3 does not exist");
    expectRefused(sound, "/skins/0/inverseBindMatrices", 0,
                  "4 inverse bind matrices of 3 components for 2 joints");
    expectRefused(sound, "/meshes/0/primitives/0/attributes/WEIGHTS_0", 0,
                  "WEIGHTS_0 has 4 elements of 3 components where 4 of 4 are needed");
    Document document = sound;
    document.setFloats("WEIGHTS_0", "VEC4", std::vector<float>(16, -1.0f));
    expectSays(refusal(document), "a weight of vertex 0 is negative or not finite");
}

TEST_F(GltfAnimation, MorphTargetsAreAppliedAtRest) {
    Document document = square();
    const int target =
        document.addAccessor(std::vector<float>{0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3", kFloat);
    document.primitive()["targets"] = {{{"POSITION", target}}};
    EXPECT_EQ(load(document).animation, nullptr);
    document.root["meshes"][0]["weights"] = {0.5};
    EXPECT_EQ(cornerOf(load(document).scene, 1), glm::dvec3(3.0, 0.0, 0.0));
    document.root["nodes"][0]["weights"] = {2.0};
    EXPECT_EQ(cornerOf(load(document).scene, 1), glm::dvec3(6.0, 0.0, 0.0));
    document.root["nodes"][0]["weights"] = {2.0, 1.0};
    expectSays(refusal(document), "2 weights for 1 morph targets");
    document.root["nodes"][0]["weights"] = {2.0};
    document.primitive()["targets"][0]["POSITION"] =
        document.addAccessor(std::vector<float>(9, 0.0f), "VEC3", kFloat);
    const char* unlike = "POSITION of a morph target has 3 elements, and the mesh has 4 vertices";
    expectSays(refusal(document), unlike);
    document.root["nodes"][0]["weights"] = {0.0};
    expectSays(refusal(document), unlike); // used or not
}

/// A material with a normal texture, and tangents along x.
void makeBumpy(Document& document) {
    giveNormalTexture(document);
    document.setFloats("TANGENT", "VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1});
}

TEST_F(GltfAnimation, TangentsFollowJoints) {
    Document document = skinned();
    makeBumpy(document);
    document.root["nodes"][2]["rotation"] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)}; // 90 degrees about z
    const Scene scene = load(document).scene;
    const std::vector<VertexDetail>& details = scene.meshes[0].details;
    ASSERT_EQ(details.size(), 4u);
    EXPECT_EQ(details[0].tangent, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_NEAR(details[1].tangent.y, 1.0f, 1e-6f);
    EXPECT_NEAR(details[2].tangent.x, 0.0f, 1e-6f);
    EXPECT_EQ(details[3].tangent, glm::vec4(1.0f, 0.0f, 0.0f, -1.0f));
}

TEST_F(GltfAnimation, MorphTargetsTurnTangents) {
    Document document = square();
    makeBumpy(document);
    const std::vector<float> deltas{0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0};
    document.primitive()["targets"] = {{{"TANGENT", document.addAccessor(deltas, "VEC3", kFloat)}}};
    document.root["meshes"][0]["weights"] = {0.5};
    const Scene scene = load(document).scene;
    EXPECT_EQ(scene.meshes[0].details[0].tangent, glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_NEAR(scene.meshes[0].details[1].tangent.y, std::sqrt(0.5f), 1e-6f);
    document.primitive()["targets"][0]["TANGENT"] = 0;
    document.root["accessors"][0]["type"] = "VEC2";
    expectSays(refusal(document), "has 2 components");
}

/// A few bytes may name many targets of many vertices.
TEST_F(GltfAnimation, DeformersAreForetold) {
    Document document = square();
    document.root["accessors"].push_back({{"componentType", kFloat}, {"count", 4}, {"type", "VEC3"}});
    document.primitive()["targets"] = json::array();
    for (int i = 0; i < 1000; ++i) {
        document.primitive()["targets"].push_back({{"POSITION", 3}});
    }
    document.root["nodes"][0]["weights"] = std::vector<double>(1000, 1.0);
    GltfLimits limits;
    limits.maxBytes = 50'000;
    expectSays(refusal(document, limits), "over the limit of 50000");
    EXPECT_EQ(refusal(document), "loaded");
}

} // namespace
} // namespace cdr::scene::test
