#include <cdr/gpu/commands.h>
#include <cdr/render/upload/vertex_updates.h>

#include <set>
#include <vector>

namespace cdr::render {

void VertexUpdates::forget(const std::optional<std::span<const std::uint32_t>>& meshes,
                           gpu::Retired& retired) {
    if (m_deformer != nullptr) {
        m_deformer->forget(meshes, retired);
    }
}

void VertexUpdates::follow(const scene::World& world, std::span<const std::uint32_t> changed,
                           const Into& into) {
    std::vector<std::uint32_t> uploaded;
    std::vector<DeformJob> jobs;
    for (const std::uint32_t mesh : std::set<std::uint32_t>(changed.begin(), changed.end())) {
        if (const scene::MeshPose* pose = world.pose(mesh)) {
            const std::int32_t first = into.meshes.ranges()[mesh].vertexOffset;
            jobs.push_back({.mesh = mesh,
                            .pose = pose,
                            .indices = world.scene().meshes[mesh].indices,
                            .firstVertex = static_cast<std::size_t>(first)});
        } else {
            uploaded.push_back(mesh);
        }
    }
    forget(uploaded, into.retired);
    if (!jobs.empty()) {
        if (m_deformer == nullptr) {
            m_deformer = std::make_unique<DeviceDeformer>(m_device);
        }
        m_deformer->provide(jobs);
    }
    if (into.last != nullptr) {
        into.last->choose(into.meshes, world.scene(), changed);
    }
    const auto keep = [&](vk::CommandBuffer commands) {
        if (into.last != nullptr) {
            into.last->record(commands, into.meshes);
        }
    };
    if (!uploaded.empty()) {
        gpu::waitForQueue(m_device); // frames in flight read what is written over
        gpu::runOnce(m_device, keep);
        into.meshes.followVertices(world.scene(), uploaded);
    }
    for (const DeformJob& job : jobs) {
        into.meshes.followPose(job.mesh, m_deformer->isFaceted(job.mesh));
    }
    if (!jobs.empty()) {
        m_deformer->run(jobs, {.vertices = into.meshes.vertices(), .details = into.meshes.details()},
                        [&](vk::CommandBuffer commands) {
                            if (uploaded.empty()) { // else it is done
                                keep(commands);
                            }
                        });
    }
}

} // namespace cdr::render
