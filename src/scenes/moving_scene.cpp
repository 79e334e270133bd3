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

MovingScene::MovingScene(scene::Scene scene, scene::SceneMotion motion, Deform deform)
    : m_world(withoutLevels(std::move(scene), motion.meshes)),
      m_motion(std::move(motion)),
      m_deform(deform) {
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

void MovingScene::deform(std::uint32_t frame, platform::WorkerPool& workers) {
    std::vector<scene::MeshPose> poses =
        m_motion.poses ? m_motion.poses(frame) : std::vector<scene::MeshPose>();
    std::vector<scene::MeshVertices> vertices;
    if (poses.empty() || m_deform != Deform::device) {
        vertices = m_motion.vertices(frame, workers);
    }
    for (std::size_t i = 0; i < m_meshes.size(); ++i) {
        if (poses.empty()) {
            m_world.setVertices(m_meshes[i], std::move(vertices[i].vertices), std::move(vertices[i].details));
        } else if (m_deform == Deform::cpu) {
            m_world.setVertices(m_meshes[i], std::move(vertices[i]), scene::boundingRadiusOf(poses[i]));
        } else if (m_deform == Deform::device) {
            m_world.setPose(m_meshes[i], std::move(poses[i]));
        } else {
            m_world.setPose(m_meshes[i], std::move(poses[i]), std::move(vertices[i]));
        }
    }
}

bool MovingScene::show(std::uint32_t frame, platform::WorkerPool& workers) {
    if (m_frame == frame) {
        return false;
    }
    m_frame.reset();
    if (!m_meshes.empty()) {
        deform(frame, workers);
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
