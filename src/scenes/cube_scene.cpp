#include <scenes/cube_scene.h>

namespace cdr::scenes {

scene::Scene cubeScene(const char* name, double halfDistanceOfLight) {
    scene::Scene scene;
    scene.name = name;
    scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    scene.materials.push_back({.name = "white", .baseColorFactor = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f)});
    scene.lights.push_back(
        {.position = glm::dvec3(0.0), .color = glm::vec3(1.0f), .halfDistance = halfDistanceOfLight});
    return scene;
}

void addBox(scene::Scene& scene, std::uint32_t material, const glm::dvec3& centre, const glm::mat3& basis) {
    const auto object = static_cast<std::uint32_t>(scene.instances.size());
    scene::addInstance(scene, 0, material, object, centre, basis);
}

void addCube(scene::Scene& scene, const glm::dvec3& position, float scale) {
    addBox(scene, 0, position, glm::mat3(scale));
}

} // namespace cdr::scenes
