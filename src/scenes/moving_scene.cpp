#include <scenes/moving_scene.h>

#include <utility>

namespace cdr::scenes {

namespace {

scene::Scene withoutLevels(scene::Scene scene, const std::vector<std::uint32_t>& meshes) {
    for (const std::uint32_t mesh : meshes) {
        scene.meshes[mesh].levels.clear();
        scene.meshes[mesh].clusters = {};
    }
    return scene;
}

} // namespace

MovingScene::MovingScene(scene::Scene scene, scene::SceneMotion motion)
    : m_world(withoutLevels(std::move(scene), motion.meshes)),
      m_motion(std::move(motion)) {
    for (const std::uint32_t instance : m_motion.instances) {
        m_instances.push_back(m_world.instance(instance));
    }
    for (const std::uint32_t mesh : m_motion.meshes) {
        m_meshes.push_back(m_world.mesh(mesh));
    }
    for (const std::uint32_t light : m_motion.lights) {
        m_lights.push_back(m_world.light(light));
    }
}

bool MovingScene::show(std::uint32_t frame, host::WorkerPool& workers) {
    if (frame == m_frame) {
        return false;
    }
    if (!m_meshes.empty()) {
        std::vector<scene::MeshVertices> vertices = m_motion.vertices(frame, workers);
        for (std::size_t i = 0; i < m_meshes.size(); ++i) {
            m_world.setVertices(m_meshes[i], std::move(vertices[i].vertices), std::move(vertices[i].details));
        }
    }
    if (!m_instances.empty()) {
        m_world.setTransforms(m_instances, m_motion.transforms(frame));
    }
    if (!m_lights.empty()) {
        const std::vector<scene::PointLight> lights = m_motion.lightsAt(frame);
        for (std::size_t i = 0; i < m_lights.size(); ++i) {
            m_world.setLight(m_lights[i], lights[i]);
        }
    }
    m_frame = frame;
    return true;
}

void MovingScene::setLayers(std::span<const float> layers) {
    for (std::size_t i = 0; i < layers.size(); ++i) {
        scene::Material material = m_world.scene().materials[i];
        if (material.layer != layers[i]) {
            material.layer = layers[i];
            m_world.setMaterial(m_world.material(i), std::move(material));
        }
    }
}

} // namespace cdr::scenes
