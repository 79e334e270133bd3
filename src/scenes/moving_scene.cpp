#include <scenes/moving_scene.h>

#include <utility>

namespace cdr::scenes {

MovingScene::MovingScene(scene::Scene scene, scene::InstancePaths motion)
    : m_world(std::move(scene)),
      m_motion(std::move(motion)) {
    for (std::size_t i = 0; i < m_world.scene().instances.size(); ++i) {
        m_instances.push_back(m_world.instance(i));
    }
}

bool MovingScene::show(std::uint32_t frame) {
    if (frame == m_frame) {
        return false;
    }
    m_world.setTransforms(m_instances, m_motion(frame));
    m_frame = frame;
    return true;
}

} // namespace cdr::scenes
