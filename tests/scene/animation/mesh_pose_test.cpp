#include "../../support/deformers.h"
#include "../../support/refusal.h"

#include <cdr/base/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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

/// A joint pushes its vertices away by them.
TEST(MeshPose, BoundsHoldVerticesWithNegativeWeights) {
    auto deformer = std::make_shared<Deformer>();
    for (const glm::vec3& corner :
         {glm::vec3(0.0f), glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.0f, 1.0f, 0.0f)}) {
        deformer->vertices.push_back({.position = corner, .normal = {0.0f, 0.0f, 1.0f}});
        deformer->firstInfluence.push_back(deformer->influences.size());
        deformer->influences.push_back({.joint = 0, .weight = 3.0f});
        deformer->influences.push_back({.joint = 1, .weight = -2.0f});
    }
    deformer->firstInfluence.push_back(deformer->influences.size());
    finish(*deformer);
    MeshPose pose{.deformer = deformer, .weights = {}, .joints = {}, .place = {}};
    pose.joints = {glm::dmat4(1.0), glm::translate(glm::dmat4(1.0), glm::dvec3(10.0, 0.0, 0.0))};
    pose.place = placeOf(*deformer, pose.joints);
    const float least = boundingRadiusOf(test::deformedByCpu(pose).vertices);
    EXPECT_GT(least, 20.0f);
    EXPECT_LE(least, boundingRadiusOf(pose));
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

/// Wherever it stands in a deformer: the next number is compared with it.
TEST(MeshPose, ANumberThatIsNoneInADeformerBoundsNothing) {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    for (const DeformerKind& kind : test::deformerKinds()) {
        const auto sound = test::makeDeformer(kind, 6);
        const auto radiusWith = [&](const auto& spoil) {
            auto spoilt = std::make_shared<Deformer>(*sound);
            spoil(*spoilt);
            finish(*spoilt);
            MeshPose pose = test::poseOf(kind, sound, 1);
            pose.deformer = spoilt;
            return boundingRadiusOf(pose);
        };
        EXPECT_TRUE(std::isfinite(radiusWith([](Deformer&) {}))) << kind.name;
        for (const std::size_t vertex : {0u, 100u, 332u}) {
            EXPECT_FALSE(std::isfinite(radiusWith([&](Deformer& d) {
                d.vertices[vertex].position.y = kNone;
            }))) << kind.name
                 << " " << vertex;
        }
        for (const std::size_t delta : {0u, 10u}) {
            EXPECT_EQ(std::isfinite(radiusWith([&](Deformer& d) {
                          for (std::vector<MorphDelta>& target : d.targets) {
                              target[delta].position.z = kNone;
                          }
                      })),
                      kind.targets == 0)
                << kind.name << " " << delta;
        }
        for (const std::size_t influence : {0u, 300u}) {
            EXPECT_EQ(std::isfinite(radiusWith([&](Deformer& d) {
                          if (kind.joints > 0) {
                              d.influences[influence].weight = kNone;
                          }
                      })),
                      kind.joints == 0)
                << kind.name << " " << influence;
        }
    }
}

/// Such a joint is not forgotten where a pose must have it.
TEST(MeshPose, AJointWhoseVerticesAreNoNumbersIsStillNeeded) {
    const DeformerKind kind{.name = "skin", .joints = 3};
    auto spoilt = std::make_shared<Deformer>(*test::makeDeformer(kind, 4));
    for (Vertex& vertex : spoilt->vertices) {
        vertex.position = glm::vec3(std::numeric_limits<float>::quiet_NaN());
    }
    finish(*spoilt);
    EXPECT_EQ(spoilt->jointReaches.size(), 3u);
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
    return cdr::test::inputErrorOf([&] { world.setPose(world.mesh(0), pose); }, "none");
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

/// deform() and the device take it as its own inverse.
TEST(MeshPose, AWorldRefusesABasisThatASkinDoesNotHave) {
    for (const DeformerKind& kind : test::deformerKinds()) {
        const auto deformer = test::makeDeformer(kind, 7);
        World world(oneMesh(*deformer));
        MeshPose pose = test::poseOf(kind, deformer, 1);
        EXPECT_EQ(refusalOf(world, pose), "none") << kind.name;
        for (const double bad : {10.0, std::numeric_limits<double>::quiet_NaN()}) {
            pose.place.basis[0][0] = bad;
            EXPECT_EQ(refusalOf(world, pose),
                      kind.joints == 0
                          ? "none"
                          : "mesh 0: with joints, the basis of its place must be as placeOf() makes it")
                << kind.name;
        }
    }
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

/// finish() and deform() read the influences where it says.
TEST(MeshPose, AWorldRefusesInfluencesThatAreNotDividedAmongTheVertices) {
    const DeformerKind kind = test::deformerKinds()[0];
    const auto sound = test::makeDeformer(kind, 7);
    World world(oneMesh(*sound));
    MeshPose pose = test::poseOf(kind, sound, 1);
    const std::vector<void (*)(std::vector<std::size_t>&)> spoils{
        [](std::vector<std::size_t>& first) { first.back() += 1; },
        [](std::vector<std::size_t>& first) { first.back() -= 1; },
        [](std::vector<std::size_t>& first) { first.front() = 1; },
        [](std::vector<std::size_t>& first) { first[7] = 1u << 30; },
        [](std::vector<std::size_t>& first) { first.push_back(first.back()); },
        [](std::vector<std::size_t>& first) { first.clear(); }};
    for (std::size_t i = 0; i < spoils.size(); ++i) {
        auto spoilt = std::make_shared<Deformer>(*sound);
        spoils[i](spoilt->firstInfluence);
        EXPECT_EQ(cdr::test::inputErrorOf([&] { finish(*spoilt); }),
                  "the firstInfluence of a deformer must divide its influences among its vertices")
            << i;
        pose.deformer = spoilt; // as finish() left it before
        EXPECT_NE(refusalOf(world, pose), "none") << i;
        EXPECT_EQ(cdr::test::inputErrorOf([&] { requireUsable(*spoilt, "it"); }),
                  "it: its firstInfluence must divide its influences among its vertices")
            << i;
    }
    pose.deformer = sound;
    EXPECT_EQ(refusalOf(world, pose), "none");
}

/// deform() looks for the vertices of a part of the mesh.
TEST(MeshPose, AWorldRefusesMorphTargetsWhoseVerticesDoNotAscend) {
    const DeformerKind kind = test::deformerKinds()[2];
    const auto sound = test::makeDeformer(kind, 7);
    World world(oneMesh(*sound));
    MeshPose pose = test::poseOf(kind, sound, 1);
    const std::string refusal = "mesh 0: the vertices of a morph target must ascend, each once";
    auto spoilt = std::make_shared<Deformer>(*sound);
    std::swap(spoilt->targets[1][3], spoilt->targets[1][4]);
    finish(*spoilt);
    pose.deformer = spoilt;
    EXPECT_EQ(refusalOf(world, pose), refusal);
    spoilt = std::make_shared<Deformer>(*sound);
    spoilt->targets[2][5].vertex = 333; // not the last
    finish(*spoilt);
    pose.deformer = spoilt;
    EXPECT_EQ(refusalOf(world, pose), refusal);
    spoilt = std::make_shared<Deformer>(*sound);
    spoilt->targets[0][1].vertex = spoilt->targets[0][0].vertex; // would move it farther than targetReach
    finish(*spoilt);
    pose.deformer = spoilt;
    EXPECT_EQ(refusalOf(world, pose), refusal);
    EXPECT_THROW(world.setPose(world.mesh(0), pose, test::deformedByCpu(test::poseOf(kind, sound, 1))),
                 base::InputError);
}

TEST(MeshPose, AWorldRefusesADeformerThatIsNotFinite) {
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    constexpr float kEndless = std::numeric_limits<float>::infinity();
    const DeformerKind kind = test::deformerKinds()[2];
    const auto sound = test::makeDeformer(kind, 7);
    World world(oneMesh(*sound));
    MeshPose pose = test::poseOf(kind, sound, 1);
    const auto refusalWith = [&](const auto& spoil) {
        auto spoilt = std::make_shared<Deformer>(*sound);
        spoil(*spoilt);
        finish(*spoilt);
        pose.deformer = spoilt;
        return refusalOf(world, pose);
    };
    for (const bool hasPose : {false, true}) {
        for (const float bad : {kNone, kEndless, -kEndless}) {
            for (const std::size_t at : {0u, 30u}) {
                const std::string vertices = "mesh 0: its vertices must be finite";
                EXPECT_EQ(refusalWith([&](Deformer& d) { d.vertices[at].position.x = bad; }), vertices);
                EXPECT_EQ(refusalWith([&](Deformer& d) { d.vertices[at].normal.y = bad; }), vertices);
                EXPECT_EQ(refusalWith([&](Deformer& d) { d.details[at].tangent.w = bad; }), vertices);
                const std::string targets = "mesh 0: its morph targets must be finite";
                EXPECT_EQ(refusalWith([&](Deformer& d) { d.targets[1][at].position.x = bad; }), targets);
                EXPECT_EQ(refusalWith([&](Deformer& d) { d.targets[4][at].normal.y = bad; }), targets);
                EXPECT_EQ(refusalWith([&](Deformer& d) { d.targets[0][at].tangent.z = bad; }), targets);
                EXPECT_EQ(refusalWith([&](Deformer& d) { d.influences[at].weight = bad; }),
                          "mesh 0: the weights of its joints must be finite");
            }
        }
        EXPECT_EQ(world.pose(0) != nullptr, hasPose);
        pose.deformer = sound;
        EXPECT_EQ(refusalOf(world, pose), "none");
    }
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
