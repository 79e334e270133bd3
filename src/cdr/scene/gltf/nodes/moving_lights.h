#pragma once

#include <cdr/scene/gltf/gltf.h>
#include <cdr/scene/scene_setup.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cdr::scene::gltf {

/// The lights of a file that go with nodes that an animation moves.
class MovingLights {
  public:
    /// @param chosen into the animations of `import`, which has some
    MovingLights(const GltfImport& import, std::size_t chosen, const FrameClock& clock);

    /// The lights that move, by index into GltfImport::lights.
    const std::vector<std::uint32_t>& moving() const { return m_moving; }

    /// Brings all of a file's lights to a frame. Where that flattens one that has a direction, it stays as it is at rest.
    /// @param lights GltfImport::lights of the same import
    void place(std::span<GltfLight> lights, std::uint32_t frame) const;

    /// Adds them to what moves in a scene that has the file's lights, in their order, and no others.
    /// @param centre of the sphere around the scene, as is @param radius, which pointLightOf() was given
    void addTo(SceneMotion& motion, const glm::dvec3& centre, double radius) const;

  private:
    std::vector<GltfLight> lightsAt(std::uint32_t frame) const;

    std::shared_ptr<const SceneAnimation> m_animation;
    std::size_t m_chosen;
    FrameClock m_clock;
    std::vector<GltfLight> m_atRest;  ///< of those that move
    std::vector<std::size_t> m_nodes; ///< into Rig::nodes, of those that move
    std::vector<std::uint32_t> m_moving;
};

} // namespace cdr::scene::gltf
