#include "../support/refusal.h"

#include <cdr/base/error.h>
#include <cdr/scene/world/world.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace cdr::scene {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A world of one box, one white material and one instance.
World boxWorld() {
    Scene scene;
    scene.meshes.push_back(makeBox(glm::vec3(0.5f)));
    scene.materials.push_back({.name = "white"});
    addInstance(scene, 0, 0, 0, glm::dvec3(1.0, 2.0, 3.0), glm::mat3(1.0f));
    return World(std::move(scene));
}

InstanceOptions boxAt(const World& world, const glm::dvec3& position) {
    return {.mesh = world.mesh(0), .material = world.material(0), .transform = {.position = position}};
}

TEST(World, AddsMovesAndRemovesInstances) {
    World world = boxWorld();
    const InstanceHandle added = world.addInstance(boxAt(world, {9.0, 0.0, 0.0}));
    EXPECT_EQ(world.scene().instances.size(), 2u);
    EXPECT_EQ(world.scene().instances.position(added.index), glm::dvec3(9.0, 0.0, 0.0));
    world.setTransform(added, {.position = {8.0, 0.0, 0.0}, .basis = glm::mat3(2.0f)});
    EXPECT_EQ(world.scene().instances.position(added.index), glm::dvec3(8.0, 0.0, 0.0));
    EXPECT_NEAR(world.scene().instances.radius[added.index], std::sqrt(3.0f), 1e-3f);
    world.removeInstance(added);
    EXPECT_EQ(world.scene().instances.radius[added.index], kNoRadius);
    const InstanceHandle again = world.addInstance(boxAt(world, {7.0, 0.0, 0.0}));
    EXPECT_EQ(again.index, added.index);
    EXPECT_NE(again, added);
    EXPECT_EQ(world.scene().instances.size(), 2u);
}

/// A scene that a world left has places of what was removed.
TEST(World, OfAnotherWorldsSceneLeavesRemovedInstancesRemoved) {
    World first = boxWorld();
    const MeshHandle mesh = first.addMesh(makeBox(glm::vec3(1.0f)));
    const MaterialHandle material = first.addMaterial({.name = "second"});
    first.removeInstance(first.addInstance({.mesh = mesh, .material = material}));
    World second{Scene(first.scene())};
    EXPECT_EQ(cdr::test::inputErrorOf([&] { second.instance(1); }), "instance 1 is not there");
    second.removeMesh(second.mesh(1));
    second.removeMaterial(second.material(1));
    const InstanceHandle added = second.addInstance(boxAt(second, {9.0, 0.0, 0.0}));
    EXPECT_EQ(added.index, 1u);
    EXPECT_EQ(second.instance(1), added);
    EXPECT_EQ(second.scene().instances.size(), 2u);
}

TEST(World, GivesAMeshOtherVertices) {
    World world = boxWorld();
    const InstanceHandle second = world.addInstance(boxAt(world, {9.0, 0.0, 0.0}));
    const InstanceHandle removed = world.addInstance(boxAt(world, {}));
    std::vector<Vertex> vertices = world.scene().meshes[0].vertices;
    for (Vertex& vertex : vertices) {
        vertex.position *= 4.0f;
    }
    world.setVertices(world.mesh(0), vertices);
    world.removeInstance(removed);
    for (Vertex& vertex : vertices) {
        vertex.position *= 0.5f;
    }
    const InstanceHandle third = world.addInstance(boxAt(world, {5.0, 0.0, 0.0}));
    world.setVertices(world.mesh(0), vertices);
    const Mesh& mesh = world.scene().meshes[0];
    EXPECT_EQ(mesh.vertices[3].position, vertices[3].position);
    EXPECT_NEAR(mesh.boundingRadius, std::sqrt(3.0f), 1e-6f);
    EXPECT_FALSE(mesh.boxHalfSides);
    for (const InstanceHandle handle : {world.instance(0), second, third}) {
        EXPECT_NEAR(world.scene().instances.radius[handle.index], std::sqrt(3.0f), 1e-4f) << handle.index;
    }
}

TEST(World, GivesAMeshOtherDetails) {
    World world = boxWorld();
    const std::vector<Vertex> vertices = world.scene().meshes[0].vertices;
    std::vector<VertexDetail> details(24, {.tangent = {0.0f, 1.0f, 0.0f, -1.0f}});
    world.setVertices(world.mesh(0), vertices, details);
    world.setVertices(world.mesh(0), vertices); // keeps them
    ASSERT_EQ(world.scene().meshes[0].details.size(), 24u);
    EXPECT_EQ(world.scene().meshes[0].details[3].tangent, details[3].tangent);
    details[5].tangent.w = NAN;
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.setVertices(world.mesh(0), vertices, details); }),
              "mesh 0: its vertices must be finite");
    details.pop_back();
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.setVertices(world.mesh(0), vertices, details); }),
              "mesh 0: 23 details for 24 vertices");
    world.setVertices(world.mesh(0), vertices, {});
    EXPECT_TRUE(world.scene().meshes[0].details.empty());
}

TEST(World, RefusesVerticesThatDoNotFit) {
    World world = boxWorld();
    const std::vector<Vertex> before = world.scene().meshes[0].vertices;
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.setVertices(world.mesh(0), {}); }),
              "mesh 0: 0 vertices cannot stand in the place of 24");
    std::vector<Vertex> vertices = before;
    vertices[7].position.x = NAN;
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.setVertices(world.mesh(0), vertices); }),
              "mesh 0: its vertices must be finite");
    vertices[7].position.x = 1e30f;
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.setVertices(world.mesh(0), vertices); }), "");
    Mesh levelled = makeBox(glm::vec3(1.0f));
    levelled.levels.push_back({.indices = {0, 1, 2}, .error = 1.0f});
    const MeshHandle other = world.addMesh(levelled);
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.setVertices(other, before); }),
              "mesh 1: its levels of detail would not hold for other vertices");
    EXPECT_EQ(world.scene().meshes[0].vertices[7].position, before[7].position);
    Mesh clustered = makeBox(glm::vec3(1.0f));
    clustered.clusters = {
        .indices = clustered.indices, .clusters = {{.firstIndex = 0, .indexCount = 36}}, .groups = {}};
    const MeshHandle third = world.addMesh(clustered);
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.setVertices(third, before); }),
              "mesh 2: its levels of detail would not hold for other vertices");
}

TEST(World, RefusesClustersThatReferToNothing) {
    World world = boxWorld();
    const auto refusal = [&](const ClusterTree& tree) {
        Mesh mesh = makeBox(glm::vec3(1.0f));
        mesh.clusters = tree;
        return cdr::test::inputErrorOf([&] { world.addMesh(mesh); });
    };
    const std::vector<std::uint32_t> whole = makeBox(glm::vec3(1.0f)).indices;
    const std::string noIndices = "a cluster refers to indices or groups that are not there";
    for (const MeshCluster& cluster :
         {MeshCluster{.firstIndex = 0, .indexCount = 39},
          MeshCluster{.firstIndex = 0xfffffffdu, .indexCount = 3},
          MeshCluster{.firstIndex = 1, .indexCount = 3}, MeshCluster{.firstIndex = 0, .indexCount = 4},
          MeshCluster{.firstIndex = 0, .indexCount = 3, .madeBy = 1},
          MeshCluster{.firstIndex = 0, .indexCount = 3, .coarserBy = 2}}) {
        EXPECT_NE(refusal({.indices = whole, .clusters = {cluster}, .groups = {{}}}).find(noIndices),
                  std::string::npos);
    }
    EXPECT_NE(refusal({.indices = whole,
                       .clusters = {{.firstIndex = 0, .indexCount = 36}},
                       .groups = {{.firstCluster = 1, .clusterCount = 1}}})
                  .find("a group of clusters refers to clusters that are not there"),
              std::string::npos);
    EXPECT_NE(refusal({.indices = {0, 1, 99}, .clusters = {}, .groups = {}}), "");
    EXPECT_EQ(refusal({.indices = whole, .clusters = {{.firstIndex = 0, .indexCount = 36}}, .groups = {}}),
              "");
}

TEST(World, RefusesStaleHandlesByName) {
    World world = boxWorld();
    const InstanceHandle gone = world.addInstance(boxAt(world, {}));
    world.removeInstance(gone);
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.removeInstance(gone); }),
              "instance 1 (generation 1) is not there: it was removed");
    world.addInstance(boxAt(world, {}));
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.setTransform(gone, {}); }),
              "instance 1 (generation 1) is not there: it was removed");
    EXPECT_EQ(cdr::test::inputErrorOf(
                  [&] { world.setTransform({.index = 7, .generation = 1, .world = gone.world}, {}); }),
              "instance 7 (generation 1) is not there: it never was");
    EXPECT_EQ(cdr::test::inputErrorOf([&] { (void)world.mesh(5); }), "mesh 5 is not there");
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.addInstance({}); }), "");
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.removeLight({}); }), "");
}

struct Misuse {
    const char* call;
    std::function<void()> run;
};

void expectRefusals(const std::vector<Misuse>& misuses, const char* words) {
    for (const Misuse& misuse : misuses) {
        EXPECT_NE(cdr::test::inputErrorOf(misuse.run).find(words), std::string::npos)
            << misuse.call << ": " << cdr::test::inputErrorOf(misuse.run);
    }
}

/// Handles of each kind.
struct Handles {
    MeshHandle mesh;
    MaterialHandle material;
    TextureHandle texture;
    InstanceHandle instance;
    LightHandle light;
};

Handles addOneOfEach(World& world) {
    return {.mesh = world.addMesh(makeBox(glm::vec3(1.0f))),
            .material = world.addMaterial({}),
            .texture = world.addTexture({.name = "dot", .pixels = image::ImageRgba8(1, 1, {1, 2, 3, 255})}),
            .instance = world.addInstance(boxAt(world, {})),
            .light = world.addLight({})};
}

/// Every call that takes a handle, with those that name nothing in this world.
void expectRefusals(World& world, const Handles& bad, const char* words) {
    const InstanceHandle kept = world.instance(0);
    const std::vector<InstanceHandle> both{kept, bad.instance};
    const std::vector<Transform> two(2);
    const std::vector<Vertex> vertices = makeBox(glm::vec3(1.0f)).vertices;
    expectRefusals(
        {{"addInstance, mesh", [&] { world.addInstance({.mesh = bad.mesh, .material = world.material(0)}); }},
         {"addInstance, material",
          [&] { world.addInstance({.mesh = world.mesh(0), .material = bad.material}); }},
         {"removeInstance", [&] { world.removeInstance(bad.instance); }},
         {"setTransform", [&] { world.setTransform(bad.instance, {}); }},
         {"setTransforms", [&] { world.setTransforms(both, two); }},
         {"setMaterial, instance", [&] { world.setMaterial(bad.instance, world.material(0)); }},
         {"setMaterial of an instance", [&] { world.setMaterial(kept, bad.material); }},
         {"setLight", [&] { world.setLight(bad.light, {}); }},
         {"removeLight", [&] { world.removeLight(bad.light); }},
         {"setVertices", [&] { world.setVertices(bad.mesh, vertices); }},
         {"removeMesh", [&] { world.removeMesh(bad.mesh); }},
         {"setMaterial", [&] { world.setMaterial(bad.material, Material{}); }},
         {"removeMaterial", [&] { world.removeMaterial(bad.material); }},
         {"removeTexture", [&] { world.removeTexture(bad.texture); }}},
        words);
    EXPECT_EQ(world.scene().instances.position(0), glm::dvec3(1.0, 2.0, 3.0));
}

TEST(World, EveryCallRefusesAHandleOfWhatWasRemoved) {
    World world = boxWorld();
    const Handles gone = addOneOfEach(world);
    world.removeInstance(gone.instance);
    world.removeMesh(gone.mesh);
    world.removeMaterial(gone.material);
    world.removeTexture(gone.texture);
    world.removeLight(gone.light);
    expectRefusals(world, gone, "it was removed");
    expectRefusals({{"instance", [&] { (void)world.instance(1); }},
                    {"mesh", [&] { (void)world.mesh(1); }},
                    {"material", [&] { (void)world.material(1); }},
                    {"texture", [&] { (void)world.texture(0); }},
                    {"light", [&] { (void)world.light(0); }}},
                   "is not there");
}

TEST(World, EveryCallRefusesAHandleOfAnotherWorld) {
    World world = boxWorld();
    World other = boxWorld();
    addOneOfEach(world);
    expectRefusals(world, addOneOfEach(other), "it is of another world");
}

TEST(World, ACopyTakesTheHandlesOfItsOriginal) {
    World world = boxWorld();
    const InstanceHandle box = world.instance(0);
    World copy = world;
    copy.setTransform(box, {.position = {5.0, 0.0, 0.0}});
    EXPECT_EQ(copy.scene().instances.position(0), glm::dvec3(5.0, 0.0, 0.0));
    EXPECT_EQ(world.scene().instances.position(0), glm::dvec3(1.0, 2.0, 3.0));
}

TEST(World, EveryCallRefusesWhatIsNotFinite) {
    World world = boxWorld();
    const auto nan = static_cast<float>(kNan);
    const LightHandle light = world.addLight({});
    Mesh mesh = makeBox(glm::vec3(1.0f));
    mesh.vertices[3].position.y = nan;
    std::vector<Vertex> vertices = world.scene().meshes[0].vertices;
    vertices[5].position.z = nan;
    Material material;
    material.baseColorFactor.x = nan;
    expectRefusals({{"addInstance",
                     [&] {
                         world.addInstance(boxAt(world, {kNan, 0.0, 0.0}));
                     }},
                    {"setTransform",
                     [&] {
                         world.setTransform(world.instance(0), {.position = {0.0, 0.0, kNan}});
                     }},
                    {"addLight",
                     [&] {
                         world.addLight({.position = {kNan, 0.0, 0.0}});
                     }},
                    {"setLight",
                     [&] {
                         world.setLight(light, {.position = {0.0, kNan, 0.0}});
                     }},
                    {"addMesh", [&] { world.addMesh(mesh); }},
                    {"setVertices", [&] { world.setVertices(world.mesh(0), vertices); }},
                    {"addMaterial", [&] { world.addMaterial(material); }},
                    {"setMaterial", [&] { world.setMaterial(world.material(0), material); }}},
                   "finite");
    EXPECT_EQ(world.scene().instances.size(), 1u);
    EXPECT_EQ(world.scene().meshes.size(), 1u);
    EXPECT_EQ(world.scene().materials.size(), 1u);
}

TEST(World, RefusesInstancesWhoseArraysDifferInLength) {
    const auto refuses = [](auto member) {
        Scene scene = boxWorld().scene();
        (scene.instances.*member).emplace_back();
        return cdr::test::inputErrorOf([&] { requireUsable(scene); }).find("equally long") !=
               std::string::npos;
    };
    EXPECT_TRUE(refuses(&Instances::x));
    EXPECT_TRUE(refuses(&Instances::y));
    EXPECT_TRUE(refuses(&Instances::z));
    EXPECT_TRUE(refuses(&Instances::radius));
    EXPECT_TRUE(refuses(&Instances::basis));
    EXPECT_TRUE(refuses(&Instances::mesh));
    EXPECT_TRUE(refuses(&Instances::material));
    EXPECT_TRUE(refuses(&Instances::object));
}

TEST(World, RefusesWhatCannotBeDrawn) {
    World world = boxWorld();
    const InstanceHandle box = world.instance(0);
    EXPECT_EQ(cdr::test::inputErrorOf([&] {
                  world.setTransform(box, {.position = {0.0, kNan, 0.0}});
              }),
              "instance 0: its position must be finite");
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.setTransform(box, {.basis = glm::mat3(NAN)}); }),
              "instance 0: its basis must be finite, with columns no longer than 1e17");
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.setTransform(box, {.basis = glm::mat3(1e18f)}); }), "");
    InstanceOptions large = boxAt(world, {});
    large.object = kMaxObjects + 1;
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.addInstance(large); }),
              "object 16777215 is over the limit of 16777214");
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.addLight({.color = {1.0f, -1.0f, 1.0f}}); }), "");
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.addLight({.halfDistance = 0.0}); }), "");
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.addLight({.range = 0.0}); }), "");
    for (const LightCone& cone :
         {LightCone{.direction = {0.0, 0.0, -2.0}}, LightCone{.inner = -0.1}, LightCone{.inner = 0.8},
          LightCone{.outer = 1.6}, LightCone{.outer = std::nan("")}}) {
        EXPECT_NE(cdr::test::inputErrorOf([&] { world.addLight({.cone = cone}); }), "");
    }
    world.removeLight(world.addLight({.cone = LightCone{}, .range = 2.0}));
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.addLight({.position = {kNan, 0.0, 0.0}}); }), "");
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.addMaterial({.name = {}, .baseColorTexture = 0}); }), "");
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.addTexture({}); }), "");
    Mesh mesh = makeBox(glm::vec3(1.0f));
    mesh.indices.back() = 24;
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.addMesh(mesh); }),
              "the new mesh: index 24 is beyond its 24 vertices");
    mesh.indices.back() = 0;
    mesh.boundingRadius = 1.0f;
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.addMesh(mesh); }).find("beyond its bounding radius"),
              std::string::npos);
    EXPECT_EQ(world.scene().instances.position(0), glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(world.scene().meshes.size(), 1u);
}

TEST(World, SetsAllTransformsOrNone) {
    World world = boxWorld();
    const InstanceHandle first = world.instance(0);
    const InstanceHandle second = world.addInstance(boxAt(world, {}));
    const std::vector<InstanceHandle> both{first, second};
    const std::uint64_t before = world.changes().instances.end();
    const std::vector<Transform> halfBad{{.position = {5.0, 5.0, 5.0}}, {.position = {kNan, 0.0, 0.0}}};
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.setTransforms(both, halfBad); }),
              "instance 1: its position must be finite");
    EXPECT_EQ(cdr::test::inputErrorOf([&] {
                  world.setTransforms(both, {halfBad.data(), 1});
              }),
              "2 instances cannot take 1 transforms");
    EXPECT_EQ(world.scene().instances.position(0), glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(world.changes().instances.end(), before);
    const std::vector<Transform> good{{.position = {5.0, 5.0, 5.0}}, {.position = {6.0, 6.0, 6.0}}};
    world.setTransforms(both, good);
    EXPECT_EQ(world.scene().instances.position(1), glm::dvec3(6.0, 6.0, 6.0));
    EXPECT_EQ(world.changes().instances.since(before)->size(), 2u);
}

TEST(World, KeepsWhatIsInUse) {
    World world = boxWorld();
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.removeMesh(world.mesh(0)); }),
              "mesh 0 cannot be removed: 1 instances use it");
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.removeMaterial(world.material(0)); }),
              "material 0 cannot be removed: 1 instances use it");
    const TextureHandle texture =
        world.addTexture({.name = "dot", .pixels = image::ImageRgba8(1, 1, {1, 2, 3, 255})});
    const MaterialHandle material = world.addMaterial({.name = {}, .baseColorTexture = texture.index});
    EXPECT_EQ(cdr::test::inputErrorOf([&] { world.removeTexture(texture); }),
              "texture 0 cannot be removed: 1 materials use it");
    world.setMaterial(material, {});
    world.removeTexture(texture);
    world.removeMaterial(material);
    world.removeInstance(world.instance(0));
    world.removeMesh(world.mesh(0));
    EXPECT_NE(cdr::test::inputErrorOf([&] { (void)world.mesh(0); }), "");
}

TEST(World, RefusesAnUnsoundScene) {
    Scene scene;
    scene.meshes.push_back(makeBox(glm::vec3(0.5f)));
    addInstance(scene, 0, 3, 0, {}, glm::mat3(1.0f));
    EXPECT_EQ(cdr::test::inputErrorOf([&] { World{scene}; }),
              "instance 0: material 3 is not there, the scene has 0");
}

TEST(World, RefusesAirThatCannotBe) {
    Scene scene;
    scene.air.emplace();
    EXPECT_EQ(cdr::test::inputErrorOf([&] { requireUsable(scene); }), "");
    for (const Air& air :
         {Air{.centre = {0.0, kNan, 0.0}}, Air{.radius = 0.0}, Air{.axis = glm::dvec3(1.0)},
          Air{.flattening = 1.0}, Air{.flattening = -0.1}, Air{.toSun = glm::dvec3(0.0)},
          Air{.sunlight = glm::vec3(-1.0f)}, Air{.molecules = {.scattering = glm::vec3(-1.0f)}},
          Air{.haze = {.height = 0.0}}, Air{.hazeAhead = 1.0}}) {
        scene.air = air;
        EXPECT_NE(cdr::test::inputErrorOf([&] { requireUsable(scene); }).find("the air"), std::string::npos);
    }
}

TEST(World, RefusesAScenesColoursThatCanNotBe) {
    const auto refused = [](auto change) {
        Scene scene;
        scene.materials.emplace_back();
        change(scene);
        return cdr::test::inputErrorOf([&] { requireUsable(scene); });
    };
    EXPECT_EQ(refused([](Scene&) {}), "");
    EXPECT_NE(refused([](Scene& scene) { scene.ambient.r = std::numeric_limits<float>::quiet_NaN(); }), "");
    EXPECT_NE(refused([](Scene& scene) { scene.background.g = -1.0f; }), "");
    EXPECT_NE(refused([](Scene& scene) { scene.materials[0].baseColorFactor.b = -0.5f; }), "");
}

TEST(World, TakesSurroundingsThatCanBe) {
    World world;
    const Environment day{
        .ambient = glm::vec3(0.5f), .background = {0.2f, 0.3f, 0.4f}, .sky = Sky{}, .air = Air{}};
    world.setEnvironment(day);
    EXPECT_EQ(world.scene().ambient, day.ambient);
    EXPECT_EQ(world.scene().background, day.background);
    EXPECT_TRUE(world.scene().sky);
    EXPECT_TRUE(world.scene().air);
    Environment dark = world.environment();
    dark.background.x = -0.1f;
    EXPECT_THROW(world.setEnvironment(dark), base::InputError);
    EXPECT_THROW(world.setEnvironment({.ambient = glm::vec3(std::numeric_limits<float>::infinity())}),
                 base::InputError);
    EXPECT_THROW(world.setEnvironment({.sky = Sky{.up = glm::dvec3(0.0)}}), base::InputError);
    EXPECT_THROW(world.setEnvironment({.air = Air{.radius = 0.0}}), base::InputError);
    EXPECT_EQ(world.environment().background, day.background) << "all of it or nothing";
    world.setEnvironment({});
    EXPECT_FALSE(world.scene().sky);
    EXPECT_FALSE(world.scene().air);
}

TEST(World, LightsKeepTheirOrder) {
    World world = boxWorld();
    const LightHandle a = world.addLight({.position = {1.0, 0.0, 0.0}});
    const LightHandle b = world.addLight({.position = {2.0, 0.0, 0.0}});
    const LightHandle c = world.addLight({.position = {3.0, 0.0, 0.0}});
    world.removeLight(a);
    world.setLight(c, {.position = {4.0, 0.0, 0.0}});
    ASSERT_EQ(world.scene().lights.size(), 2u);
    EXPECT_EQ(world.scene().lights[0].position.x, 2.0);
    EXPECT_EQ(world.scene().lights[1].position.x, 4.0);
    EXPECT_NE(cdr::test::inputErrorOf([&] { world.setLight(a, {}); }), "");
    const LightHandle d = world.addLight({.position = {5.0, 0.0, 0.0}});
    world.removeLight(b);
    EXPECT_EQ(world.scene().lights[1].position.x, 5.0);
    world.setLight(d, {.position = {6.0, 0.0, 0.0}});
    EXPECT_EQ(world.scene().lights[1].position.x, 6.0);
}

TEST(ChangeLog, ForgetsNothingThatAReaderFollowsEachTurn) {
    constexpr std::size_t kPlaces = 2000;
    ChangeLog log;
    std::uint64_t read = log.end();
    for (int turn = 0; turn < 9; ++turn) {
        for (std::uint32_t i = 0; i < kPlaces; ++i) {
            log.add(i, kPlaces);
        }
        const auto changed = log.since(read);
        ASSERT_TRUE(changed.has_value());
        EXPECT_EQ(changed->size(), kPlaces);
        EXPECT_EQ(changed->front(), 0u);
        read = log.end();
    }
    EXPECT_FALSE(log.since(0).has_value());
}

} // namespace

} // namespace cdr::scene
