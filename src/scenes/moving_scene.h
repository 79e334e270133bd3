#pragma once

#include <cdr/scene/scene_setup.h>
#include <cdr/scene/world/world.h>

#include <cstdint>
#include <vector>

namespace cdr::scenes {

/// A scene whose instances follow their paths, from frame to frame.
class MovingScene {
  public:
    /// @param motion of the scene's instances. base::InputError as scene::World.
    MovingScene(scene::Scene scene, scene::InstancePaths motion);

    /// Brings all to where they are at a frame. Whether that was another one than is shown.
    bool show(std::uint32_t frame);

    const scene::World& world() const { return m_world; }

  private:
    scene::World m_world;
    scene::InstancePaths m_motion;
    std::vector<scene::InstanceHandle> m_instances;
    std::uint32_t m_frame = 0;
};

} // namespace cdr::scenes
