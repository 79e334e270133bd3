#pragma once

#include <cdr/scene/lod/mesh_pieces.h>
#include <cdr/scene/scene.h>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace cdr::scenes {

/// Puts named objects of boxes and meshes into a scene.
class SceneBuilder {
  public:
    /// @param scene must outlive the builder.
    explicit SceneBuilder(scene::Scene& scene) : m_scene(scene) {}

    std::uint32_t addMaterial(const std::string& name, const glm::vec3& linearColor);
    std::uint32_t addMaterial(scene::Material material);

    /// The texture's index.
    std::uint32_t addTexture(scene::Texture texture);

    /// What follows belongs to a new object of that name.
    void beginObject(const std::string& name) { m_scene.objectNames.push_back(name); }

    /// @param basis unit axes; identity for a box along the world's.
    void addBox(std::uint32_t material, const glm::dvec3& centre, const glm::dvec3& halfSides,
                const glm::dmat3& basis = glm::dmat3(1.0));
    /// One mesh about its own middle, its vertices float64 until then.
    void addMesh(std::uint32_t material, const scene::SourceMesh& mesh,
                 const glm::dmat4& toWorld = glm::dmat4(1.0));

    scene::Scene& scene() { return m_scene; }

  private:
    scene::Scene& m_scene;
    std::optional<std::uint32_t> m_unitBox; ///< mesh that all boxes share
};

/// A white light so far away that it shines evenly on everything.
/// @param direction from the world's origin towards the light.
scene::PointLight farLight(const glm::dvec3& direction, double distance);

} // namespace cdr::scenes
