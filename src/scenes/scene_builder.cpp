#include <scenes/scene_builder.h>

#include <utility>

namespace cdr::scenes {

std::uint32_t SceneBuilder::addMaterial(const std::string& name, const glm::vec3& linearColor) {
    return addMaterial({.name = name, .baseColorFactor = glm::vec4(linearColor, 1.0f)});
}

std::uint32_t SceneBuilder::addMaterial(scene::Material material) {
    m_scene.materials.push_back(std::move(material));
    return static_cast<std::uint32_t>(m_scene.materials.size() - 1);
}

std::uint32_t SceneBuilder::addTexture(scene::Texture texture) {
    m_scene.textures.push_back(std::move(texture));
    return static_cast<std::uint32_t>(m_scene.textures.size() - 1);
}

void SceneBuilder::addBox(std::uint32_t material, const glm::dvec3& centre, const glm::dvec3& halfSides,
                          const glm::dmat3& basis) {
    if (!m_unitBox) {
        m_unitBox = static_cast<std::uint32_t>(m_scene.meshes.size());
        m_scene.meshes.push_back(scene::makeBox(glm::vec3(0.5f)));
    }
    const glm::dmat3 scaled(2.0 * halfSides.x * basis[0], 2.0 * halfSides.y * basis[1],
                            2.0 * halfSides.z * basis[2]);
    scene::addInstance(m_scene, *m_unitBox, material,
                       static_cast<std::uint32_t>(m_scene.objectNames.size() - 1), centre, glm::mat3(scaled));
}

void SceneBuilder::addMesh(std::uint32_t material, const scene::SourceMesh& mesh, const glm::dmat4& toWorld) {
    const scene::PieceSet pieces = addPieces(m_scene, scene::cutIntoPieces(mesh));
    placePieces(m_scene, pieces, material, static_cast<std::uint32_t>(m_scene.objectNames.size() - 1),
                toWorld);
}

scene::PointLight farLight(const glm::dvec3& direction, double distance) {
    return {.position = distance * direction, .color = glm::vec3(1.0f), .halfDistance = 10.0 * distance};
}

} // namespace cdr::scenes
