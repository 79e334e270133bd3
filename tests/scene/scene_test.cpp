#include <cdr/base/error.h>
#include <cdr/scene/scene.h>

#include <gtest/gtest.h>

#include <string>

namespace cdr::scene {

namespace {

std::string refusalOfMesh(Scene& scene, std::uint32_t mesh) {
    try {
        addInstance(scene, mesh, 0, 0, {0.0, 0.0, -5.0}, glm::mat3(1.0f));
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "added";
}

/// An instance takes its radius from its mesh, so the mesh comes first.
TEST(AddInstance, RefusesAMeshThatIsNotThere) {
    Scene scene;
    EXPECT_EQ(
        refusalOfMesh(scene, 0),
        "scene: mesh 0 of an instance is not there, the scene has 0; add meshes before their instances");
    scene.meshes.push_back(makeBox(glm::vec3(1.0f)));
    EXPECT_EQ(refusalOfMesh(scene, 0), "added");
    EXPECT_NE(refusalOfMesh(scene, 1), "added");
    const Instances& instances = scene.instances;
    for (const std::size_t count : {instances.x.size(), instances.y.size(), instances.z.size(),
                                    instances.radius.size(), instances.basis.size(), instances.mesh.size(),
                                    instances.material.size(), instances.object.size()}) {
        EXPECT_EQ(count, 1u) << "a refused one leaves nothing behind";
    }
    scene.instances.mesh[0] = 7;
    EXPECT_THROW(placeInstance(scene, 0, {0.0, 0.0, 0.0}, glm::mat3(1.0f)), base::InputError);
}

} // namespace

} // namespace cdr::scene
