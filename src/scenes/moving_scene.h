#pragma once

#include <cdr/platform/worker_pool.h>
#include <cdr/scene/scene_setup.h>
#include <cdr/scene/world/world.h>
#include <scenes/deform.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cdr::scenes {

/// A scene whose instances and lights follow their paths and whose meshes deform, from frame to frame. What deforms has no levels of
/// detail. Its materials may change their layers meanwhile.
class MovingScene {
  public:
    /// @param motion of the scene's instances. base::InputError as scene::World.
    /// @param deform who makes vertices. Those that no pose makes (scene::SceneMotion::poses) the CPU makes.
    MovingScene(scene::Scene scene, scene::SceneMotion motion, Deform deform = Deform::cpu);

    /// Brings all to where they are at a frame. Whether that was another one than is shown.
    /// base::InputError where a frame puts something where nothing can be drawn. Then a part may have moved, until the next frame.
    bool show(std::uint32_t frame, platform::WorkerPool& workers);
    /// Gives all materials other layers (scene::Material::layer), by index. base::InputError for one that is not finite.
    void setLayers(std::span<const float> layers);

    const scene::World& world() const { return m_world; }
    /// The meshes that show() deforms, by index.
    const std::vector<std::uint32_t>& deformedMeshes() const { return m_motion.meshes; }

  private:
    void deform(std::uint32_t frame, platform::WorkerPool& workers);

    scene::World m_world;
    scene::SceneMotion m_motion;
    std::vector<scene::InstanceHandle> m_instances;
    std::vector<scene::MeshHandle> m_meshes;
    std::vector<scene::LightHandle> m_lights;
    std::optional<std::uint32_t> m_frame = 0; ///< none where show() failed half way
    Deform m_deform;
};

} // namespace cdr::scenes
