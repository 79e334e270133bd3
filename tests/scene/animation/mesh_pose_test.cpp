#include "../../support/deformers.h"

#include <cdr/base/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cdr::scene {

namespace {

using test::DeformerKind;

/// No vertex is beyond, and no bound is far off.
TEST(MeshPose, BoundsHoldAllVertices) {
    for (const DeformerKind& kind : test::deformerKinds()) {
        const auto deformer = test::makeDeformer(kind, 4);
        for (std::uint32_t seed = 0; seed < 50; ++seed) {
            const MeshPose pose = test::poseOf(kind, deformer, seed);
            const float least = boundingRadiusOf(test::deformedByCpu(pose).vertices);
            EXPECT_LE(least, boundingRadiusOf(pose)) << kind.name << " " << seed;
            EXPECT_LE(boundingRadiusOf(pose), 3.0f * least) << kind.name << " " << seed;
        }
    }
}

/// Joints that flatten a mesh to a point far away leave its roundings.
TEST(MeshPose, BoundsHoldWhatRoundingsMove) {
    const DeformerKind kind{.name = "flattened", .joints = 5};
    const auto deformer = test::makeDeformer(kind, 5);
    MeshPose pose = test::poseOf(kind, deformer, 1);
    for (glm::dmat4& joint : pose.joints) {
        joint = glm::dmat4(0.0);
        joint[3] = glm::dvec4(1e9, -3e8, 7e7, 1.0);
    }
    pose.place = placeOf(*deformer, pose.joints);
    const float least = boundingRadiusOf(test::deformedByCpu(pose).vertices);
    EXPECT_GT(least, 0.0f);
    EXPECT_LE(least, boundingRadiusOf(pose));
    EXPECT_LE(boundingRadiusOf(pose), 1e4f);
}

TEST(MeshPose, ANumberThatIsNoneBoundsNothing) {
    for (const DeformerKind& kind : test::deformerKinds()) {
        const auto deformer = test::makeDeformer(kind, 6);
        MeshPose pose = test::poseOf(kind, deformer, 1);
        if (pose.joints.empty()) {
            pose.weights[1] = std::numeric_limits<double>::quiet_NaN();
        } else {
            pose.joints[deformer->jointReaches[1].joint][0][1] = std::numeric_limits<double>::quiet_NaN();
        }
        EXPECT_FALSE(std::isfinite(boundingRadiusOf(pose))) << kind.name;
    }
}

Scene oneMesh(const Deformer& deformer) {
    Scene scene;
    Mesh mesh;
    mesh.vertices = deformer.vertices;
    mesh.details = deformer.details;
    mesh.indices = {0, 1, 2};
    mesh.boundingRadius = boundingRadiusOf(mesh.vertices);
    scene.meshes.push_back(mesh);
    scene.materials.push_back({.name = "white"});
    addInstance(scene, 0, 0, 0, glm::dvec3(0.0), glm::mat3(1.0f));
    return scene;
}

std::string refusalOf(World& world, const MeshPose& pose) {
    try {
        world.setPose(world.mesh(0), pose);
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(MeshPose, AWorldTakesWhatCanBeDrawn) {
    const DeformerKind kind = test::deformerKinds()[2];
    const auto deformer = test::makeDeformer(kind, 7);
    World world(oneMesh(*deformer));
    const float radius = world.scene().instances.radius[0];
    const MeshPose pose = test::poseOf(kind, deformer, 1);
    MeshPose spoilt = pose;
    spoilt.deformer = nullptr;
    EXPECT_EQ(refusalOf(world, spoilt), "mesh 0: its pose has no deformer");
    spoilt = pose;
    spoilt.joints.resize(deformer->jointReaches.back().joint);
    EXPECT_EQ(refusalOf(world, spoilt), "mesh 0: its pose has other joints than its deformer");
    spoilt = pose;
    spoilt.joints[deformer->influences[0].joint][3][0] = std::numeric_limits<double>::infinity();
    EXPECT_NE(refusalOf(world, spoilt).find("its bounding radius must lie in"), std::string::npos);
    auto fewer = std::make_shared<Deformer>();
    fewer->vertices.resize(3);
    finish(*fewer);
    spoilt = {.deformer = fewer, .weights = {}, .joints = {}, .place = {}};
    EXPECT_EQ(refusalOf(world, spoilt), "mesh 0: 3 vertices cannot stand in the place of 333");
    EXPECT_EQ(world.pose(0), nullptr);
    EXPECT_EQ(world.scene().instances.radius[0], radius);
    EXPECT_EQ(refusalOf(world, pose), "none");
    EXPECT_NE(world.pose(0), nullptr);
    EXPECT_FALSE(world.hasPosedVertices());
    EXPECT_EQ(world.posedMeshes(), std::vector<std::uint32_t>{0});
    EXPECT_NE(world.scene().instances.radius[0], radius);
    world.setPose(world.mesh(0), pose, test::deformedByCpu(pose));
    EXPECT_TRUE(world.hasPosedVertices());
    world.setVertices(world.mesh(0), deformer->vertices);
    EXPECT_EQ(world.pose(0), nullptr);
}

/// Without finish() nothing says which joints a pose must have.
TEST(MeshPose, AWorldRefusesADeformerThatNamesWhatIsNotThere) {
    const DeformerKind kind = test::deformerKinds()[2];
    const auto sound = test::makeDeformer(kind, 7);
    World world(oneMesh(*sound));
    MeshPose pose = test::poseOf(kind, sound, 1);
    auto spoilt = std::make_shared<Deformer>(*sound);
    spoilt->targets[1].push_back({.vertex = 333, .position = glm::vec3(1.0f)});
    finish(*spoilt);
    pose.deformer = spoilt;
    EXPECT_EQ(refusalOf(world, pose), "mesh 0: a morph target moves a vertex that its deformer has not");
    spoilt = std::make_shared<Deformer>(*sound);
    spoilt->jointReaches.clear(); // as before finish(), which finds out what joints there must be
    pose.deformer = spoilt;
    EXPECT_EQ(refusalOf(world, pose), "mesh 0: its deformer is not as finish() leaves it");
    spoilt = std::make_shared<Deformer>(*sound);
    spoilt->influences.back().joint = 1000;
    finish(*spoilt);
    pose.deformer = spoilt;
    EXPECT_EQ(refusalOf(world, pose), "mesh 0: its pose has other joints than its deformer");
    pose.deformer = sound;
    pose.weights.clear(); // all 0
    EXPECT_EQ(refusalOf(world, pose), "none");
}

/// The device draws what the mesh has, and deform() makes what the deformer has.
TEST(MeshPose, AWorldRefusesADeformerOfOtherColoursOrTextureCoordinatesThanItsMesh) {
    const DeformerKind kind = test::deformerKinds()[0];
    const auto sound = test::makeDeformer(kind, 8);
    World world(oneMesh(*sound));
    MeshPose pose = test::poseOf(kind, sound, 1);
    const auto expectRefusal = [&](void (*spoil)(Deformer&), const std::string& part) {
        auto spoilt = std::make_shared<Deformer>(*sound);
        spoil(*spoilt);
        pose.deformer = spoilt;
        EXPECT_EQ(refusalOf(world, pose), "mesh 0: its deformer has other " + part +
                                              " than the mesh, and a pose changes positions, normals and "
                                              "tangents alone");
        EXPECT_THROW(world.setPose(world.mesh(0), pose, test::deformedByCpu(pose)), base::InputError);
    };
    for (const bool hasPose : {false, true}) {
        expectRefusal([](Deformer& d) { d.vertices[5].color.g = 0; }, "colours");
        expectRefusal([](Deformer& d) { d.vertices[332].uv.x = 0.75f; }, "texture coordinates");
        expectRefusal([](Deformer& d) { d.details.clear(); }, "details");
        expectRefusal([](Deformer& d) { d.details[0].uv.y = 0.5f; }, "second texture coordinates");
        EXPECT_EQ(world.pose(0) != nullptr, hasPose);
        pose.deformer = sound;
        EXPECT_EQ(refusalOf(world, pose), "none");
    }
    std::vector<Vertex> red = sound->vertices;
    red[0].color = {255, 0, 0, 255};
    world.setVertices(world.mesh(0), red);
    EXPECT_NE(refusalOf(world, pose).find("other colours"), std::string::npos) << "the mesh has others now";
}

} // namespace

} // namespace cdr::scene
